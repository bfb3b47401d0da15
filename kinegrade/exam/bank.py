"""The bank's file, an exam's blueprint: which questions are put, for how many points, within which
tolerance.

title  = { en = "Kinematics midterm", zh = "运动学期中测验" }
course = { en = "Theoretical mechanics", zh = "理论力学" }
tolerance = { relative = "1 %" }  # or { absolute = 0.01 }, { figures = 3 }: or several of them
shuffle = true  # optional: every paper has its own order of the questions
versions = 3  # optional: versions A, B, C instead of a paper for each student
engine = "latex"  # optional: what typesets the exam (typst)
credit = { follow-through = "1/2" }  # optional: see bank_credit
solutions = true  # optional: feedback holds the worked solutions
lms = "canvas"  # optional: refuse draws that Canvas's four decimals cannot tell

[[questions]]
template = "slider-crank"  # a shipped template, or a file beside the bank: "mine.toml"
asks = { v_B = 3, omega_AB = 2 }  # optional: what is asked, with points
draw = { k = ["sqrt(3)", "2"] }  # optional: other domains for some parameters
tolerance = { relative = "2 %" }  # optional: for this question

[[questions]]
family = "rolling"  # or tag = "acceleration": shipped templates, drawn once for the class
number = 2  # optional: how many different ones (1)
without = ["rolling-wheel-rim-points"]  # optional: not these
asks = "velocity"  # optional: only this (position, acceleration) of what the template asks
points = 10  # optional: shared out as the template weighs what it asks
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, cast, get_args

from kinegrade.errors import BankError, did_you_mean, short_line
from kinegrade.exam.bank_credit import read_credit
from kinegrade.exam.bank_questions import MAX_QUESTIONS, Entries
from kinegrade.exam.bank_values import Values, written
from kinegrade.exam.blueprint import LMS, Bank, Blueprint, Slot, matched, wishes
from kinegrade.exam.press import ENGINES, Engine
from kinegrade.exam.versions import LETTERS
from kinegrade.fields.document import FileKind, read_text, toml_table
from kinegrade.problem.library import shipped
from kinegrade.problem.tolerance import ONE_PER_CENT, Tolerance

KEYS = (
    "title",
    "course",
    "date",
    "tolerance",
    "shuffle",
    "versions",
    "engine",
    "credit",
    "solutions",
    "lms",
    "questions",
)
MAX_BYTES = 200_000
_BANK_FILE = FileKind("a bank file", BankError, MAX_BYTES)


def bank_path(path: Path) -> Path:
    """The file of a bank: at that path, or the shipped one of that name. Raises BankError where
    there is neither.
    """
    banks = {file.stem: file for file in shipped("banks").glob("*.toml")}
    if not path.is_file() and str(path) in banks:
        return banks[str(path)]
    if path.suffix != ".toml" and not path.exists():
        raise BankError(
            f'no bank "{short_line(str(path))}": {did_you_mean(str(path), banks)}; or give a bank '
            "file"
        )
    return path


def read_bank(path: Path, secret: str = "") -> Bank:
    """The exam that a secret makes of a bank's file; the secret matters where the bank draws by
    family or tag.

    Raises BankError with all faults at once.
    """
    return read_blueprint(path).bank(secret)


def read_blueprint(path: Path, folder: Path | None = None) -> Blueprint:
    """The blueprint in a file; `folder` holds the templates, by default the shipped ones.

    Raises BankError with all faults at once.
    """
    text = read_text(path, _BANK_FILE)
    table = toml_table(str(path), text, _BANK_FILE).content
    return blueprint(Values(path), table, text, folder or shipped("templates"))


def blueprint(values: Values, table: Mapping[str, Any], text: str, folder: Path) -> Blueprint:
    """The whole of a file; raises BankError when anything is at fault."""
    values.unknown_keys("", table, KEYS)
    tolerance = values.tolerance("tolerance", table.get("tolerance"), ONE_PER_CENT)
    slots = read_slots(values, table.get("questions"), Entries(values, folder), tolerance)
    frame = Bank(
        values.translated("title", table.get("title")),
        values.translated("course", table.get("course")),
        values.date("date", table.get("date", "")),
        tolerance,
        (),
        text,
        values.flag("shuffle", table.get("shuffle", False)),
        values.whole("versions", table["versions"], 1, len(LETTERS)) if "versions" in table else 0,
        read_engine(values, table.get("engine", "typst")),
        read_credit(values, table.get("credit")),
        values.flag("solutions", table.get("solutions", False)),
        read_lms(values, table.get("lms")),
    )
    if values.faults:
        raise BankError(*values.faults)
    return Blueprint(frame, slots)


def read_engine(values: Values, value: Any) -> Engine:
    """What typesets the exam; after a fault Typst, with which reading goes on."""
    if value in ENGINES:
        return cast(Engine, value)
    values.fault("engine", f"expected {' or '.join(ENGINES)}, not {written(value)!r}")
    return "typst"


def read_lms(values: Values, value: Any) -> LMS | None:
    """The system that the exam is put into, where its draws have to suit it."""
    if value is None or value in get_args(LMS):
        return cast(LMS | None, value)
    values.fault("lms", f"expected {' or '.join(get_args(LMS))}, or no lms, not {written(value)!r}")
    return None


def read_slots(
    values: Values, entries: Any, reader: Entries, tolerance: Tolerance
) -> tuple[Slot, ...]:
    """The exam's questions q1, q2 ... in the bank's order; an entry may stand for several."""
    if not isinstance(entries, list) or not 1 <= len(entries) <= MAX_QUESTIONS:
        values.fault("questions", f"expected 1 to {MAX_QUESTIONS} tables [[questions]]")
        return ()
    found: dict[str, tuple[Slot, ...]] = {}
    for number, entry in enumerate(entries, start=1):
        place, first = f"questions[{number}]", sum(map(len, found.values())) + 1
        found[place] = reader.slots(place, entry, first, tolerance)
    slots = tuple(slot for group in found.values() for slot in group)
    if len(slots) > MAX_QUESTIONS:
        values.fault("questions", f"expected at most {MAX_QUESTIONS} questions, not {len(slots)}")
    same_names(values, found)
    enough(values, found, slots)
    return slots


def same_names(values: Values, found: Mapping[str, Sequence[Slot]]) -> None:
    """A fault where two different template files share a name: the exam folder keeps one file of a
    name.
    """
    texts: dict[str, str] = {}
    for place, slots in found.items():
        for template in (slot.candidates[0].template for slot in slots if not slot.drawn):
            if texts.setdefault(template.name, template.text) != template.text:
                values.fault(
                    f"{place}.template",
                    f'another template of this bank has the name "{template.name}": rename the '
                    "file",
                )


def enough(values: Values, found: Mapping[str, Sequence[Slot]], slots: Sequence[Slot]) -> None:
    """A fault where no choice gives every question a template of its own."""
    chosen = matched(wishes(slots, lambda slot, name: 0))
    for place, own in found.items():
        left = sum(not slot.drawn or slot.identifier in chosen for slot in own)
        if left < len(own):
            values.fault(
                f"{place}.number",
                f"{len(own)} different templates are to be drawn, {left} can be had "
                "besides those of the other questions: draw fewer",
            )
