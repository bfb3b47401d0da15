"""Whether a bank and its templates are those from which an exam was set: as its folder holds them,
as they were before a correction, or shipped ones that another version of kinegrade has otherwise.
"""

from __future__ import annotations

import tomllib
from collections.abc import Collection, Mapping
from hashlib import sha256
from pathlib import PurePosixPath
from typing import Any

from kinegrade.errors import BankError
from kinegrade.exam.bank.blueprint import Bank, Blueprint
from kinegrade.exam.bank.keys import OWN_ASK
from kinegrade.exam.folder.contents import BANK, TEMPLATES
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.generating.exam_files import source_files, translation_files
from kinegrade.language.message import Fault, Message
from kinegrade.problem.template.library.library import find_shipped
from kinegrade.problem.template.sections.stepwise_keys import STEPWISE

_EXPECTED = Message("exam.same-sources")
_RESTORING = Message("exam.give-same-sources")


def require_same_sources(exam: ExamFolder, blueprint: Blueprint) -> tuple[str, ...]:
    """The shipped templates that are others than when the exam was set, as another version of
    kinegrade has them: the folder's copies hold.

    Raises BankError with every other text of a bank that is not the folder's copy of it.
    """
    bank = _same_choice(exam, blueprint)
    sources = source_files(bank) | translation_files(bank, (exam.language,))
    found = {question.template.name for question in bank.questions}
    unlike = [name for name in sources if not _is_accepted(exam, name, sources[name])]
    shipped = [name for name in unlike if _is_shipped(name, sources[name])]
    faults = [
        Fault(str(exam.path / name), Message("exam.differs-from-given"), _EXPECTED, _RESTORING)
        for name in unlike
        if name not in shipped
    ]
    faults += [
        Fault(
            str(exam.path / TEMPLATES),
            Message("exam.not-in-bank", template=name),
            _EXPECTED,
            _RESTORING,
        )
        for name in dict.fromkeys(each.template for each in exam.head.questions)
        if name not in found
    ]
    if faults:
        raise BankError(*faults)
    return tuple(name for name in shipped if name in map(_name_copy, found))


def _name_copy(template: str) -> str:
    """The folder's copy of a template."""
    return f"{TEMPLATES}/{template}.toml"


def _is_shipped(name: str, content: bytes) -> bool:
    """Whether that is a text of the installed kinegrade: its templates, their translations and
    mechanisms.
    """
    path = PurePosixPath(name)
    if path.parts[0] != TEMPLATES:
        return False
    file = find_shipped(TEMPLATES).joinpath(*path.parts[1:])
    return file.is_file() and file.read_bytes() == content


def _same_choice(exam: ExamFolder, blueprint: Blueprint) -> Bank:
    """The bank with the templates that the exam has, as far as they are there."""
    chosen = {each.question: each.template for each in exam.head.questions}
    return blueprint.choose(chosen)


def _is_accepted(exam: ExamFolder, name: str, content: bytes) -> bool:
    """Whether that is a source of the exam: as its folder holds it, or as it was before a template
    was corrected.
    """
    given, file = exam.head.given, exam.path / name
    if not file.is_file():
        return False
    if content == file.read_bytes() or sha256(content).hexdigest() == given.get(name):
        return True
    corrected = {PurePosixPath(each).stem for each in given}
    if name == BANK and corrected:
        return _read_frame(content, corrected) == _read_frame(file.read_bytes(), corrected)
    return name in given and _read(content) == _read(file.read_bytes())


def _read_frame(text: bytes, corrected: Collection[str]) -> Mapping[str, object]:
    """What a bank states but for its `corrected` templates, which are held against copies of their
    own: these may stand in the bank as questions with steps, or in files elsewhere.
    """
    content = _read(text)
    questions = [_reduce(entry, corrected) for entry in content["questions"]]
    return {**content, "questions": questions}


def _reduce(entry: Mapping[str, Any], corrected: Collection[str]) -> Mapping[str, object]:
    """An entry of a bank without what is read from a template that was corrected."""
    template = PurePosixPath(str(entry.get("template", ""))).stem
    if template in corrected:
        return {**entry, "template": template}
    if entry.get("name") not in corrected:
        return entry
    asks = {
        ask: {key: value for key, value in stated.items() if key in OWN_ASK}
        for ask, stated in entry["asks"].items()
    }
    return {**{key: entry[key] for key in entry if key not in STEPWISE}, "asks": asks}


def _read(text: bytes) -> dict[str, Any]:
    """A source that was read without a fault."""
    return tomllib.loads(text.decode())
