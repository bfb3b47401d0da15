"""What was asked of an exam whose writing was begun, kept in its unfinished folder: its secret, and
a digest of all that its papers follow from.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from hashlib import sha256
from pathlib import Path
from typing import Literal, get_args

import msgspec

from kinegrade import __version__
from kinegrade.errors import OutputError
from kinegrade.exam.folder.contents import UNFINISHED
from kinegrade.exam.folder.exam_secret import ExamSecret, find_secret
from kinegrade.exam.printing.printing import PrintRun
from kinegrade.exam.roster.roster import Roster
from kinegrade.files.output import find_unfinished
from kinegrade.language.message import Fault, Message, list_plainly

_BEGUN = "begun.json"

Part = Literal["version", "bank", "roster", "options", "replaced"]
Order = Mapping[Part, str]  # a digest of each


@dataclass(frozen=True)
class Begun:
    """An unfinished exam: where it is, its secret, and what was asked for."""

    folder: Path
    secret: ExamSecret
    order: Order

    def require_same(self, order: Order) -> None:
        """Raises OutputError where something else is asked for now."""
        parts = [part for part in get_args(Part) if self.order.get(part) != order[part]]
        if parts:
            names = list_plainly(Message(f"exam.begun-{part}") for part in parts)
            what, expected = Message("exam.otherwise-begun", parts=names), Message("exam.as-begun")
            do = Message("exam.begin-anew")
            raise OutputError(Fault(str(self.folder), what, expected, do))


def find_begun(output: Path) -> Begun | None:
    """The exam that was to become the folder `output`, as a killed process left it; None where
    there is none. Raises OutputError where it is damaged, or may be being written.
    """
    folder = find_unfinished(output, UNFINISHED)
    if folder is None:
        return None
    file = folder / UNFINISHED / _BEGUN
    try:
        content = json.loads(file.read_text(encoding="utf-8"))
        secret, order = find_secret(content["secret"]), content["order"]
    except (OSError, ValueError, KeyError, TypeError) as fault:
        raise _explain_damage(file) from fault
    if secret is None or not isinstance(order, dict):
        raise _explain_damage(file)
    return Begun(folder, secret, order)


def write_begun(folder: Path, secret: ExamSecret, order: Order) -> None:
    """State in the folder what is asked for, unless it does: in one step, or not at all."""
    if (folder / UNFINISHED).exists():
        return
    draft = folder / f"{UNFINISHED}.new"
    draft.mkdir(mode=0o700)
    content = {"secret": secret.record(), "order": order}
    (draft / _BEGUN).write_text(json.dumps(content), encoding="utf-8")
    draft.rename(folder / UNFINISHED)


@dataclass(frozen=True)
class Basis:
    """What an exam is made from: the files of its bank, its roster, and a digest of each paper of
    the exam that is `replaced`.
    """

    sources: Mapping[str, bytes]
    roster: Roster
    replaced: Mapping[str, bytes]


def describe_order(run: PrintRun, basis: Basis, wishes: object) -> Order:
    """All that the papers of an exam follow from but for its secret: also how they are printed, and
    what else is wished.
    """
    how = (run.language, run.press_order, run.extras, wishes, run.bank.earlier)
    return {
        "version": _digest(__version__),
        "bank": _digest(basis.sources),
        "roster": _digest([asdict(each) for each in basis.roster.students]),
        "options": _digest(how),
        "replaced": _digest(basis.replaced),
    }


def _digest(content: object) -> str:
    return sha256(msgspec.json.encode(content, order="deterministic")).hexdigest()


def _explain_damage(file: Path) -> OutputError:
    return OutputError(
        Fault(
            str(file),
            Message("exam.begun-damaged"),
            Message("exam.begun-as-written"),
            Message("exam.begin-anew"),
        )
    )
