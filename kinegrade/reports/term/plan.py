"""What the exams of a term count: the plan in a file, or weights on the command line.

[parts.homework]
marks = ["HW1", "HW2", "HW3"]
best = 2
weight = "30 %"

[parts.FINAL]
weight = "70 %"

[excused]
HW2 = ["1002"]

[set-aside]
FINAL = ["1003"]

[scale]
kind = "german"
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from pathlib import Path

from kinegrade.errors import FieldError, OptionError, PolicyError, suggest
from kinegrade.files.fields.document import FileKind, read_text, toml_table
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import share, text, whole
from kinegrade.grade_scale.stated import StatedScale, read_scale
from kinegrade.language.message import Fault, Message, Quoted, list_plainly
from kinegrade.marks_folder.rows import ClassTotals
from kinegrade.numbers.amounts import write_amount
from kinegrade.reports.term.excuses import Excuses, FormerIds, find_present_ids, read_excuses

PLAN = (
    #: What counts: a table `[parts.NAME]` for each part, of a name of your own.
    "parts",
    #: Who is excused from which marks, `HW2 = ["1002"]`: they do not count for these students, and
    #: what else belongs to the part, or the other parts where nothing does, counts the more.
    "excused",
    #: For whom marks are set aside although these students were there, `FINAL = ["1003"]`: they
    #: do not count, as if the student were excused.
    "set-aside",
    #: Which grades the totals of the term earn: a table `[scale]`, as in a bank.
    "scale",
)
PART = (
    #: The marks that belong to the part, `["HW1", "HW2"]`, by the names of their folders; those of
    #: the part's own name where they are not stated.
    "marks",
    #: What the part counts, a share of the whole: `"30 %"`. All of them add up to 100 %.
    "weight",
    #: How many of its marks count, each student's best; all where it is not stated.
    "best",
)
_PLAN_FILE = FileKind(Message("term.file"), PolicyError, 200_000)
_LIKE = '{ marks = ["HW1", "HW2"], weight = "30 %" }'
_MOST = 100  # marks of a term


@dataclass(frozen=True, slots=True)
class Part:
    """Some of a term's marks, by their names: each counts the same, the `best` so many of a student
    count, and together they have a `weight`, a share of the whole.
    """

    name: str
    marks: tuple[str, ...]
    weight: Fraction
    best: int


@dataclass(frozen=True, slots=True)
class Plan:
    """The parts of a term, whose weights add up to 1, its scale, None for no grades, who is
    excused from what, and for whom what is set aside although they sat it.
    """

    parts: tuple[Part, ...]
    scale: StatedScale | None = None
    excused: Excuses = field(default_factory=dict)
    set_aside: Excuses = field(default_factory=dict)

    def by_present_ids(self, exams: Mapping[str, ClassTotals], former_ids: FormerIds) -> Plan:
        """The same plan, in which students may be named by ids that they had before."""
        excused = find_present_ids(self.excused, exams, former_ids)
        set_aside = find_present_ids(self.set_aside, exams, former_ids)
        return replace(self, excused=excused, set_aside=set_aside)

    def find_uncounted(self, student: str) -> frozenset[str]:
        """The names of the marks that do not count for a student."""
        stated = (*self.excused.items(), *self.set_aside.items())
        return frozenset(name for name, students in stated if student in students)


def plan_evenly(names: Sequence[str]) -> Plan:
    """Every exam counts the same."""
    return Plan(tuple(Part(name, (name,), Fraction(1, len(names)), 1) for name in names))


def plan_by_weights(weights: Iterable[str], names: Sequence[str]) -> Plan:
    """The plan of weights such as "FINAL=70 %", one for each exam. Raises OptionError with all
    faults at once.
    """
    faults: list[Fault] = []
    parts: list[Part] = []
    for stated in weights:
        name, _, amount = stated.rpartition("=")
        try:
            parts.append(Part(name, (name,), share(amount.strip()), 1))
        except FieldError as fault:
            faults.append(Fault("--weight", fault.what, fault.expected, fault.do))
    if not faults:
        faults += [Fault("--weight", each) for each in _list_mismatches(parts, names)]
        faults += [Fault("--weight", each) for each in _list_sums(parts)]
    if faults:
        raise OptionError(*faults)
    return Plan(tuple(parts))


def read_plan(path: Path, names: Sequence[str]) -> Plan:
    """The plan in a file, for the exams of these names. Raises PolicyError with all faults at
    once.
    """
    table = toml_table(str(path), read_text(path, _PLAN_FILE), _PLAN_FILE).only(*PLAN)
    tables = table.table("parts").each_table(_LIKE)
    if not tables:
        table.missing("parts", Message("fields.a-table-like", like=_LIKE))
    parts = [_read_part(name, each) for name, each in tables.items()]
    scale, excused = read_scale(table), read_excuses(table.table("excused"), names)
    set_aside = read_excuses(table.table("set-aside"), names)
    known = [each for each in parts if each is not None]
    if len(known) == len(tables) and tables:
        for what in (*_list_mismatches(known, names), *_list_sums(known)):
            table.fault("parts", what)
    table.faults.require_none()
    return Plan(tuple(known), scale, excused, set_aside)


def _read_part(name: str, table: Table) -> Part | None:
    """A part; None after a fault."""
    stated = table.only(*PART)
    marks = stated.listing("marks", text, '"HW1"') if "marks" in stated else (name,)
    weight = stated.required("weight", share)
    best = stated.with_default("best", whole(1, _MOST), len(marks))
    if "marks" in stated and stated.value("marks") == []:
        stated.fault("marks", Message("term.no-marks"), Message("fields.a-list-like", like='"HW1"'))
    if marks and best > len(marks):
        what = Message("term.best-of", best=best, count=len(marks))
        stated.fault("best", what, Message("term.best-at-most", most=len(marks)))
    if weight is None or not marks:
        return None
    return Part(name, marks, weight, best)


def _list_mismatches(parts: Sequence[Part], names: Sequence[str]) -> list[Message]:
    """What is wrong with the names of the marks: each belongs to one part."""
    counted = Counter(name for part in parts for name in part.marks)
    unknown = [
        Message("term.unknown-marks", name=Quoted(name), hint=suggest(name, names))
        for name in counted
        if name not in names
    ]
    twice = [
        Message("term.marks-twice", name=Quoted(name)) for name, each in counted.items() if each > 1
    ]
    left = [name for name in names if name not in counted]
    forgotten = [Message("term.marks-left", names=list_plainly(left))] if left else []
    return [*unknown, *twice, *forgotten]


def _list_sums(parts: Sequence[Part]) -> list[Message]:
    whole_weight = sum((part.weight for part in parts), Fraction(0))
    if whole_weight == 1:
        return []
    return [Message("term.sum", share=write_amount(100 * whole_weight))]
