"""A scale as a bank, a policy or the file of a term states it: the table `[scale]`.

[scale]
kind = "german"
pass = "50 %"
curve = { "45 %" = "50 %", "90 %" = "95 %" }
absent = "NE"

[scale]
grades = { A = "85 %", B = "65 %", C = "50 %", D = 0 }
pass = "50 %"

`make_scale` in `kinds` makes the scale of it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from itertools import pairwise
from typing import Literal, assert_never, get_args

from msgspec import Struct, field

from kinegrade.errors import FieldError
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import choice, share, text
from kinegrade.language.message import Message, Quoted, list_choices
from kinegrade.numbers.amounts import write_amount

Kind = Literal["german", "letters", "hundred", "five-level"]
KINDS: tuple[Kind, ...] = get_args(Kind)
SCALE = (
    #: A usual scale: `"german"` (1.0 to 5.0, in ten equal steps from the pass mark on), `"letters"`
    #: (A from 90 %, B 80, C 70, D 60, F), `"hundred"` (whole numbers to 100, halves rounded up), or
    #: `"five-level"` (excellent from 90 %, good 80, fair 70, pass 60, fail).
    "kind",
    #: Grades of your own in place of a kind, the best first, each with the share of the points from
    #: which on it is given: `{ A = "85 %", B = "65 %", C = "50 %", D = 0 }`.
    "grades",
    #: The share of the points from which on one passes; of a kind 50 % (`"german"`) or 60 % where
    #: it is not stated. Of `"hundred"` the whole number has to reach it: 59.5 % is 60, and passes.
    "pass",
    #: What a share of the points counts as, by two points of a straight line: with
    #: `{ "45 %" = "50 %", "90 %" = "95 %" }` whoever reached 45 % has 50 %.
    "curve",
    #: The word for students who answered nothing at all, in place of a grade.
    "absent",
)
_LIKE = '{ kind = "german" }'
_GRADES = '{ A = "85 %", B = "65 %", C = "50 %", D = 0 }'
_CURVE = '{ "45 %" = "50 %", "90 %" = "95 %" }'
_BEGIN = tuple(Fraction(tenths, 10) for tenths in (6, 7, 8, 9))  # where letters and levels begin
_POINTS = 2  # of a straight line
_FEWEST = 2  # grades


class StatedScale(Struct, frozen=True):
    """A scale as stated: a kind, or grades with the shares from which on they are given, the best
    first; the pass mark, None for that of the kind; and the two points of the curve, each a share
    that was reached and what it counts as.
    """

    kind: Kind | None = None
    grades: Mapping[str, Fraction] = field(default_factory=dict)
    passing: Fraction | None = None
    curve: tuple[tuple[Fraction, Fraction], ...] = ()
    absent: str = ""

    def record(self) -> dict[str, object]:
        """The scale as exam.json keeps it and `read_scale` reads it."""
        record: dict[str, object] = {} if self.kind is None else {"kind": self.kind}
        if self.grades:
            record["grades"] = {grade: str(least) for grade, least in self.grades.items()}
        if self.passing is not None:
            record["pass"] = str(self.passing)
        if self.curve:
            record["curve"] = {str(reached): str(counted) for reached, counted in self.curve}
        if self.absent:
            record["absent"] = self.absent
        return record


def read_scale(table: Table) -> StatedScale | None:
    """What `scale` in a table states; None where it states none, and after a fault."""
    if "scale" not in table:
        return None
    stated = table.table("scale", _LIKE).only(*SCALE)
    kind = stated.optional("kind", choice(KINDS))
    grades = stated.table("grades", _GRADES).entries(share)
    passing = stated.optional("pass", share)
    curve = _read_curve(stated)
    absent = stated.with_default("absent", text, "")
    _require_one_kind(stated)
    if "grades" in stated and stated.is_sound("grades"):
        _require_whole(stated, grades)
        if grades:
            _require_pass(stated, grades, passing)
    _require_usual_pass(stated, kind, passing)
    if not table.is_sound("scale"):
        return None
    return StatedScale(kind, grades, passing, curve, absent)


def _require_one_kind(stated: Table) -> None:
    """A fault unless a scale is of a kind, or has grades of its own."""
    if stated.whole and ("kind" in stated) == ("grades" in stated):
        both = "kind" in stated
        what = Message("scale.both") if both else Message("scale.neither")
        stated.fault(None, what, Message("scale.kind-or-grades", like=_GRADES))


def _require_whole(stated: Table, grades: Mapping[str, Fraction]) -> None:
    """Faults where grades leave a gap, begin at one bound, or do not fall."""
    expected = Message("scale.grades-fall", like=_GRADES)
    if len(grades) < _FEWEST:
        stated.fault("grades", Message("scale.few-grades", count=len(grades)), expected)
    for (better, above), (grade, least) in pairwise(grades.items()):
        said = Quoted(grade), Quoted(better), _write_share(least)
        if least == above:
            what = Message("scale.overlap", grade=said[0], better=said[1], share=said[2])
            stated.fault("grades", what, expected)
        elif least > above:
            what = Message("scale.rises", grade=said[0], better=said[1], share=said[2])
            stated.fault("grades", what, expected)
    for grade in grades:
        if not grade.strip():
            stated.fault("grades", Message("scale.no-name"), expected)
    lowest = min(grades.values(), default=Fraction(0))
    if lowest:
        what = Message("scale.gap", share=_write_share(lowest))
        stated.fault("grades", what, Message("scale.from-zero"))


def _require_pass(stated: Table, grades: Mapping[str, Fraction], passing: Fraction | None) -> None:
    """A fault unless a grade of one's own begins at the pass mark."""
    expected = _expect_begin(grades.values())
    if "pass" not in stated:
        stated.missing("pass", expected)
    elif passing is not None and passing not in grades.values():
        stated.fault("pass", _write_share(passing), expected)


def _require_usual_pass(stated: Table, kind: Kind | None, passing: Fraction | None) -> None:
    """A fault where a pass mark does not suit a kind of scale."""
    if kind is None or passing is None:
        return
    match kind:
        case "german" if not 0 < passing < 1:
            stated.fault("pass", _write_share(passing), Message("scale.pass-between"))
        case "letters" | "five-level" if passing not in _BEGIN:
            stated.fault("pass", _write_share(passing), _expect_begin(_BEGIN))
        case "german" | "letters" | "five-level" | "hundred":
            pass
        case _:
            assert_never(kind)


def _read_curve(stated: Table) -> tuple[tuple[Fraction, Fraction], ...]:
    """The two points, the lower first; none where there is no curve, and after a fault."""
    table = stated.table("curve", _CURVE)
    counted = table.entries(share)
    expected = Message("scale.two-points", like=_CURVE)
    points: list[tuple[Fraction, Fraction]] = []
    for reached, value in counted.items():
        try:
            points.append((share(reached), value))
        except FieldError as fault:
            table.faults.note_error((*table.place, reached), fault)
    if "curve" not in stated or not stated.is_sound("curve"):
        return ()
    points.sort()
    if len(points) != _POINTS:
        stated.fault("curve", Message("scale.points", count=len(points)), expected)
    elif points[0][0] == points[1][0] or points[0][1] >= points[1][1]:
        stated.fault("curve", Message("scale.curve-falls"), expected)
    return tuple(points)


def _expect_begin(shares: Iterable[Fraction]) -> Message:
    return Message(
        "scale.pass-begins", shares=list_choices(map(_write_share, dict.fromkeys(shares)))
    )


def _write_share(amount: Fraction) -> Message:
    return Message("scale.percent", number=write_amount(100 * amount))
