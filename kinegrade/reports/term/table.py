"""The results of a term as a table, and in words how many students there are of each kind."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from kinegrade.files.csv_writing import neutralise
from kinegrade.files.rows.row import Row
from kinegrade.files.tables import Table
from kinegrade.grade_scale.scale import Scale
from kinegrade.language.message import Message
from kinegrade.marks_folder.layout import Status
from kinegrade.numbers.amounts import write_amount
from kinegrade.reports.term.plan import Part, Plan
from kinegrade.reports.term.results import Exams, TermResult, rank_results

_ABSENT: Status = "absent"
_ALL: Status = "marked"
_SOME = "partly"
_EXCUSED = "excused"
_NOT_LISTED = "-"
_FULL, _PLACES = 100, 2


def make_term_table(
    results: Sequence[TermResult], exams: Exams, plan: Plan, *, grades: bool, ranks: bool
) -> Table:
    """A line for each student: percentages of each exam, of each part of several exams and of the
    whole; grade and rank where they are wanted; whether the student was there in all of them.

    An exam that was missed says "absent", one from which the student is excused says so, and one in
    which the student is not listed has a dash.
    Names are safe for spreadsheets.
    """
    several = [part for part in plan.parts if part.marks != (part.name,)]
    header = (
        "student",
        "name",
        *map(neutralise, exams),
        *(neutralise(part.name) for part in several),
        "total",
        *(["grade"] if grades else []),
        *(["rank"] if ranks else []),
        "status",
    )
    places = rank_results(results) if ranks else {}
    rows = (
        (
            *_write_person(each),
            *_write_exams(each, exams),
            *_write_parts(each, several),
            *([neutralise(each.grade)] if grades else []),
            *([_write_rank(each, places)] if ranks else []),
            _find_status(each, exams),
        )
        for each in results
    )
    lines = tuple(Row(line, cells) for line, cells in enumerate(rows, 2))
    return Table("", header, lines, "UTF-8", ",", ())


def _write_person(result: TermResult) -> tuple[str, str]:
    return result.student, neutralise(result.name)


def _write_exams(result: TermResult, exams: Exams) -> Iterator[str]:
    for name in exams:
        if name in result.sat:
            yield write_amount(_FULL * result.sat[name].share, _PLACES)
        elif name in result.excused:
            yield _EXCUSED
        else:
            yield _ABSENT if name in result.listed else _NOT_LISTED


def _write_parts(result: TermResult, several: Sequence[Part]) -> Iterator[str]:
    """The percentages of the parts and of the whole; none for a student who sat nothing, or of
    parts that do not count.
    """
    for share in (*(result.parts[part.name] for part in several), result.total):
        if share is None or not result.sat:
            yield ""
        else:
            yield write_amount(_FULL * share, _PLACES)


def _write_rank(result: TermResult, places: Mapping[str, int]) -> str:
    return str(places[result.student]) if result.student in places else ""


def _find_status(result: TermResult, exams: Exams) -> str:
    if not result.sat:
        return _ABSENT
    return _ALL if result.sat.keys() | result.excused == exams.keys() else _SOME


def describe_results(
    results: Sequence[TermResult], exams: Exams, scale: Scale | None
) -> Iterator[Message]:
    """How many students sat each exam, missed it or are excused; how many sat all, some or none;
    and with a scale how many passed.
    """
    for name in exams:
        yield from _describe_exam(name, results)
    statuses = [_find_status(each, exams) for each in results]
    yield Message(
        "term.students",
        count=len(results),
        all=statuses.count(_ALL),
        some=statuses.count(_SOME),
        none=statuses.count(_ABSENT),
    )
    if scale is not None:
        passing = {step.grade for step in scale.steps if step.passes}
        there = [each for each in results if each.sat]
        passed = sum(each.grade in passing for each in there)
        yield Message("term.passed", count=passed, present=len(there))


def _describe_exam(name: str, results: Sequence[TermResult]) -> Iterator[Message]:
    """How many sat an exam, missed it, are not listed in it or are excused from it."""
    expected = [each for each in results if name not in each.excused]
    listed = [each for each in expected if name in each.listed]
    present = sum(name in each.sat for each in listed)
    yield Message(
        "term.exam",
        name=name,
        count=present,
        absent=len(listed) - present,
        missing=len(expected) - len(listed),
    )
    excused = len(results) - len(expected)
    if excused:
        yield Message("term.excused", name=name, count=excused)
