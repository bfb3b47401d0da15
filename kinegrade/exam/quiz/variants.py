"""The variants of a pool: which lines of the key a quiz offers to all students, kept so that its
responses can be marked.

`kinegrade quiz --variants` stores them as variants.jsonl in the exam folder, in the form of
key.jsonl; `kinegrade.lms.responses` recognises by them what a student was asked.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from html import unescape
from itertools import islice

import msgspec

from kinegrade.errors import ExamError, FieldError
from kinegrade.exam.folder.contents import KEY
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.faults import describe_damage, explain_broken, name_line_of
from kinegrade.exam.folder.key.exact_keys import find_exact_value
from kinegrade.exam.folder.key.lines import KeyLine, KeyQuestion
from kinegrade.exam.quiz.paper import show_instance
from kinegrade.exam.quiz.quiz import different
from kinegrade.files.output import output_file
from kinegrade.files.placing.previous import Previous
from kinegrade.language.message import Fault, Message
from kinegrade.language.prose.html import write_prose
from kinegrade.problem.statement import list_statement_languages, write_statement
from kinegrade.problem.template.template import Template

_NUMBER = re.compile(r"[0-9]+(?:[.,][0-9]+)?")
_SIGN = re.compile(rf"([-−]?)({_NUMBER.pattern})|[^\W\d_]")
_TAG = re.compile(r"</?[A-Za-z][^<>]*>")
Numbers = tuple[str, ...]


@contextmanager
def variants_stored(exam: ExamFolder, count: int) -> Iterator[None]:
    """Store the first `count` variants of an exam while a quiz of them is written; where that
    fails, the exam folder is as it was. Any further ones already there stay, and none is ever
    changed.

    Raises ExamError if those that are stored belong to another key, OutputError if nothing can be
    written there.
    """
    lines = [text.rstrip(b"\r\n") for _, text in islice(different(exam), count)]
    before = [text.rstrip(b"\r\n") for _, text in exam.keys.pool_texts()]
    if before[: len(lines)] != lines[: len(before)]:
        raise ExamError(Fault(str(exam.keys.pool_file), Message("exam.other-variants", key=KEY)))
    if len(lines) > len(before):
        _write(exam, lines)
    try:
        yield
    except BaseException:
        if len(lines) > len(before):
            _write(exam, before)
        raise


def _write(exam: ExamFolder, lines: Sequence[bytes]) -> None:
    """The file of the variants with these lines, none where there are no lines."""
    if not lines:
        exam.keys.pool_file.unlink(missing_ok=True)
        return
    with output_file(exam.keys.pool_file, force=True, previous=Previous.NONE) as partial:
        partial.write_bytes(b"".join(line + b"\n" for line in lines))
    exam.keys.pool_file.chmod(exam.keys.file.stat().st_mode & 0o777)


def _numbers_in(text: str) -> Numbers:
    """The numbers of a text as they are written, by which a question's text is recognised in any
    layout.

    >>> _numbers_in(r"a crank of \\(r = 0.25\\,\\mathrm{m/s^{2}}\\)")
    ('0.25', '2')
    """
    return tuple(_NUMBER.findall(text))


def _plain_text(shown: str) -> str:
    """A text as a download has it, without what a system may have left of its HTML."""
    return unescape(_TAG.sub(" ", shown))


def _letters_in(text: str) -> str:
    r"""The letters and numbers of a text, which no layout changes; numbers stand between blanks.

    >>> _letters_in(r"The **crank** of \\(x = -0.25\\,m\\)")
    'thecrankofx -0.25 m'
    """
    return "".join(
        f" {'-' if sign[1] else ''}{sign[2]} " if sign[2] else sign[0].casefold()
        for sign in _SIGN.finditer(text)
    )


@dataclass(frozen=True)
class Variant:
    """One question of a pool: `source` is the student on whose line of the key it stands, `right`
    is by ask.
    """

    source: str
    right: Mapping[str, float]
    entry: KeyQuestion
    template: Template

    @cached_property
    def texts(self) -> frozenset[str]:
        """Its statement in each language as a quiz shows it, without mark-up."""
        shown = show_instance(self.template, self.entry.values, self.entry.asks)
        statements = (
            write_statement(self.template, shown.parameters, language, shown.asks)
            for language in list_statement_languages(self.template)
        )
        return frozenset(_plain_text(write_prose(each, "statement")) for each in statements)

    @cached_property
    def letters(self) -> frozenset[str]:
        """The letters and numbers of its statement in each language."""
        return frozenset(map(_letters_in, self.texts))

    @cached_property
    def numbers(self) -> frozenset[Numbers]:
        """The numbers of its statement in each language."""
        return frozenset(map(_numbers_in, self.texts))


def of_text(variants: Sequence[Variant], shown: str) -> list[Variant]:
    """The variants whose statement stands in the text of a question: letter by letter, else by its
    numbers.

    If one statement is the beginning of another, the longer one is meant. Numbers alone identify a
    text that was corrected in the system, but not whether its crank speeds up or slows down.
    """
    text = _plain_text(shown)
    letters, numbers = _letters_in(text), _numbers_in(text)
    lengths = {
        place: max((len(each) for each in variant.letters if each in letters), default=0)
        for place, variant in enumerate(variants)
    }
    longest = max(lengths.values(), default=0)
    if longest:
        return [variants[place] for place, length in lengths.items() if length == longest]
    return [
        variant for variant in variants if any(_holds(numbers, each) for each in variant.numbers)
    ]


@dataclass(frozen=True)
class Variants:
    """The pool of an exam, by question; variants that are equal in everything are one."""

    count: int
    questions: Mapping[str, tuple[Variant, ...]]


def read_variants(exam: ExamFolder) -> Variants | None:
    """The variants that are stored with an exam; None where no pool was made. Raises ExamError."""
    lines = list(exam.keys.pool_lines())
    if not lines:
        return None
    templates = exam.templates.all()
    found: dict[str, dict[bytes, Variant]] = {}
    for line in lines:
        for entry in line.questions:
            same = msgspec.json.encode(entry, order="sorted")
            variant = _make_variant(exam, line, entry, templates)
            found.setdefault(entry.question, {}).setdefault(same, variant)
    return Variants(len(lines), {name: tuple(each.values()) for name, each in found.items()})


def _make_variant(
    exam: ExamFolder, line: KeyLine, entry: KeyQuestion, templates: Mapping[str, Template]
) -> Variant:
    try:
        right = {name: float(find_exact_value(ask)) for name, ask in entry.asks.items()}
        return Variant(line.student, right, entry, templates[entry.question])
    except (KeyError, FieldError) as fault:
        damage = Fault(name_line_of(line.student), describe_damage(fault))
        raise explain_broken(exam.keys.pool_file, [damage]) from fault


def _holds(numbers: Numbers, wanted: Numbers) -> bool:
    """Whether `numbers` holds those wanted one after another."""
    length = len(wanted)
    starts = range(len(numbers) - length + 1)
    return bool(wanted) and any(numbers[start : start + length] == wanted for start in starts)
