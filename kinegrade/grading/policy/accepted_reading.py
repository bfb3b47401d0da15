"""The answers that a policy accepts besides the key's: `{ value = "2*sqrt(3)", unit = "m/s" }`.

`policy_reading` reads them along with the rest of a policy file; `accepted` works them out.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import partial

from kinegrade.errors import ExpressionError, FieldError, find_nearest, suggest
from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.value_dimension import require_countable
from kinegrade.expressions.angular import is_angle
from kinegrade.expressions.reading import read_expression
from kinegrade.expressions.tree import Expression, find_names
from kinegrade.files.fields.digits import Digits
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import flag, found, share
from kinegrade.grading.policy.keys import ACCEPTED
from kinegrade.grading.policy.policy import FULL_CREDIT, Accepted
from kinegrade.grading.typed.conversion import Conversion, WrongUnit, find_conversion
from kinegrade.grading.typed.number_text import Unreadable
from kinegrade.grading.typed.unit_spelling import read_unit as read_written_unit
from kinegrade.language.lines import shorten
from kinegrade.language.message import Message, Quoted, list_choices

_EXAMPLE = '{ value = "2*sqrt(3)" }'
_LONGEST_SHOWN = 80
_ANGLES = ("deg", "rad")


@dataclass(frozen=True)
class AcceptedReader:
    """Reads the accepted answers of a policy for one exam."""

    exam: ExamFolder
    students: frozenset[str]

    def read(self, table: Table, ask: Ask) -> Iterator[Accepted]:
        """The answers under `accept` in an ask's table; faulty ones are left out."""
        for number, entry in enumerate(table.tables("accept", _EXAMPLE), 1):
            known = entry.only(*ACCEPTED)
            credit = known.with_default("credit", share, FULL_CREDIT)
            students = self._students(known)
            leads = known.with_default("leads", flag, True)
            tree = known.required("value", _read_tree)
            if tree is not None:
                self._require_dimension(known, ask, tree)
                written = shorten(str(known.value("value")).strip(), _LONGEST_SHOWN)
                scale = self._scale(known, ask, tree)
                yield Accepted(number, written, tree, scale, credit, students, leads)

    def _students(self, entry: Table) -> frozenset[str] | None:
        """The students for whom an answer counts; None for all."""
        if "student" not in entry:
            return None
        if isinstance(entry.value("student"), list):
            return frozenset(entry.listing("student", self._student))
        student = entry.optional("student", self._student)
        return frozenset() if student is None else frozenset({student})

    def _student(self, value: object) -> str:
        """The id of a student of the exam, who may be called by a former one."""
        if not isinstance(value, str) or isinstance(value, Digits):
            raise FieldError(found(value), Message("policy.quoted-id"))
        student = self.exam.former_ids.get(value, value)
        if student not in self.students:
            unknown = Message("policy.no-student", student=found(value))
            raise FieldError(unknown, do=_suggest_student(value, self.students))
        return student

    def _scale(self, entry: Table, ask: Ask, tree: Expression) -> Conversion:
        """The factor for the value: for a number by its unit.

        Givens, asks and angles bring their own units, so that a value made of them is in SI units;
        a unit stated beside it has to be of the ask's kind and changes nothing.
        """
        used = [name for name in find_names(tree) if name != "pi"]
        units = self._units(ask, used)
        for name in sorted(set(used) - units.keys()):
            unknown = Message("policy.unknown-name", name=Quoted(name))
            entry.fault("value", unknown, do=suggest(name, units))
        stated = entry.with_default("unit", partial(_read_conversion, ask), Conversion())
        angles = frozenset(name for name in used if units.get(name) in _ANGLES)
        printed = read_written_unit(ask.unit)
        if printed and (used or is_angle(tree, angles)):
            return Conversion(1 / printed.factor, -printed.pi)
        return stated

    def _require_dimension(self, entry: Table, ask: Ask, tree: Expression) -> None:
        """Notes a value that cannot be counted in the unit of the ask, or takes plain numbers for
        angles; unknown names are told elsewhere.
        """
        units = self._units(ask, [name for name in find_names(tree) if name != "pi"])
        try:
            require_countable(tree, units, ask.unit, Message("policy.fix-it"))
        except ExpressionError:  # told where the value is worked out, or of another version's unit
            return
        except FieldError as error:
            entry.faults.note_error((*entry.place, "value"), error)

    def _units(self, ask: Ask, used: list[str]) -> Mapping[str, str]:
        """The units of the names a value may use: the question's asks, and its givens where it uses
        one.
        """
        units = {each.ask: each.unit for each in self.exam.asks if each.question == ask.question}
        if set(used) <= units.keys():
            return units
        drawn = self.exam.keys.parameters(self.exam.students[0], ask.question)
        return units | {name: each.unit for name, each in drawn.items()}


def _read_tree(value: object) -> Expression:
    """The number or expression of a value."""
    if isinstance(value, bool) or not isinstance(value, str | int):
        raise FieldError(found(value), Message("policy.expression"))
    return read_expression(str(value))


def _read_conversion(ask: Ask, unit: object) -> Conversion:
    """The conversion from a stated unit to the ask's."""
    if not isinstance(unit, str) or isinstance(unit, Digits):
        raise FieldError(found(unit), Message("policy.unit", unit=Quoted(ask.unit)))
    try:
        return find_conversion(unit, ask.unit)
    except (WrongUnit, Unreadable) as fault:
        raise FieldError(fault.reason) from fault


def _suggest_student(student: str, students: frozenset[str]) -> Message:
    """A hint that does not list the whole class."""
    near = find_nearest(student, students)
    if not near:
        return Message("policy.check-id")
    return Message("grammar.did-you-mean", names=list_choices(map(Quoted, near)))
