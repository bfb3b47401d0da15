"""The command that puts the exams of a term together: term."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

import kinegrade
from kinegrade.cli.help import command
from kinegrade.cli.options import FILE, FORCE, LANGUAGE, OUTPUT, finish_with_complaints, refusing
from kinegrade.cli.terminal import refuse_usage, say
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message

if TYPE_CHECKING:
    from collections.abc import Mapping

    from kinegrade.errors import Problem
    from kinegrade.files.tables import Table
    from kinegrade.language import Language
    from kinegrade.marks_folder.folder import MarksFolder
    from kinegrade.reports.term.plan import Plan


@command()
@click.argument("marks", type=FILE, nargs=-1, required=True)
@OUTPUT
@click.option(
    "--plan",
    type=FILE,
    metavar="FILE",
)
@click.option(
    "--weight",
    "weights",
    multiple=True,
    metavar="NAME=SHARE",
)
@click.option(
    "--ranks",
    is_flag=True,
)
@LANGUAGE
@FORCE
@refusing
def term(
    *,
    marks: tuple[Path, ...],
    output: Path,
    plan: Path | None,
    weights: tuple[str, ...],
    ranks: bool,
    language: Language,
    force: bool,
) -> None:
    """Put several MARKS together, by weights and the best of some, in one table with grades."""
    from kinegrade.grade_scale.kinds import make_scale
    from kinegrade.reports.term.excuses import require_excusable
    from kinegrade.reports.term.naming import name_folders, require_different_exams
    from kinegrade.reports.term.results import work_out_results
    from kinegrade.reports.term.table import describe_results, make_term_table

    names = name_folders(marks)
    chosen = _choose_plan(plan, weights, names)
    folders = {name: kinegrade.open_marks(path) for name, path in zip(names, marks, strict=True)}
    require_different_exams(folders.values())
    exams = {name: folder.totals for name, folder in folders.items()}
    if plan is not None:
        former_ids = {name: folder.former_ids for name, folder in folders.items()}
        chosen = chosen.by_present_ids(exams, former_ids)
        require_excusable(plan, chosen.excused, chosen.set_aside, exams, former_ids)
    words = open_catalogue(language)
    scale = None if chosen.scale is None else make_scale(chosen.scale, words)
    results = work_out_results(exams, chosen, scale)
    table = make_term_table(results, exams, chosen, grades=scale is not None, ranks=ranks)
    _write(table, output, force=force)
    for note in describe_results(results, exams, scale):
        say(note)
    finish_with_complaints(_list_complaints(folders))


def _list_complaints(folders: Mapping[str, MarksFolder]) -> list[Problem]:
    """Who is not marked to the end, which marks are by an earlier key, and who has two lines."""
    from kinegrade.grading.exams_beside import find_later_keys
    from kinegrade.marks_folder.open_questions import describe_unmarked
    from kinegrade.reports.term.forgotten_marks import find_forgotten_marks
    from kinegrade.reports.term.split_students import find_renamed_students, find_split_students
    from kinegrade.reports.unlike_names import find_unlike_names

    unmarked = [
        missing
        for name, folder in folders.items()
        for missing in describe_unmarked(name, folder.open, folder.lacking)
    ]
    exams = {name: folder.totals for name, folder in folders.items()}
    former_ids = {name: folder.former_ids for name, folder in folders.items()}
    people = [
        *find_forgotten_marks(exams),
        *find_split_students(exams),
        *find_renamed_students(exams, former_ids),
        *find_unlike_names(exams),
    ]
    return [*unmarked, *find_later_keys(folders.values()), *people]


def _choose_plan(plan: Path | None, weights: tuple[str, ...], names: tuple[str, ...]) -> Plan:
    from kinegrade.reports.term.plan import plan_by_weights, plan_evenly, read_plan

    if plan is not None and weights:
        raise refuse_usage(Message("terminal.plan-or-weights"))
    if plan is not None:
        return read_plan(plan, names)
    if weights:
        return plan_by_weights(weights, names)
    if len(names) > 1:
        say(Message("term.evenly", count=len(names)))
    return plan_evenly(names)


def _write(table: Table, output: Path, *, force: bool) -> None:
    """Write the table as its file's ending says."""
    from kinegrade.files.csv_writing import encode_for_people, write_csv_text
    from kinegrade.files.output import write_file

    ending = output.suffix.lower()
    if ending == ".xlsx":
        from kinegrade.lms.workbook import write_tables

        write_file(output, write_tables([("term", table)]), "xlsx", force=force)
    elif ending == ".csv":
        text = write_csv_text(table.header, [row.cells for row in table.rows])
        write_file(output, encode_for_people(text), "csv", force=force)
    else:
        raise refuse_usage(Message("terminal.term-ending", file=str(output)))
