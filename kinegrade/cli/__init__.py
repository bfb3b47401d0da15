"""The command line. Heavy modules are imported by the commands that need them, so that `--help`
answers at once.

Results go to standard output or to `-o`, messages go to standard error. Exit status: 0 fine, 1 done
with complaints, 2 cannot be done; an error is one line for each fault. `program` says how else a
run may end.
"""

from __future__ import annotations

import os

import click

from kinegrade import __version__
from kinegrade.cli.appeals import explain, forget, merge
from kinegrade.cli.doctor import doctor
from kinegrade.cli.entries import compare_entries
from kinegrade.cli.exams import archive, generate, verify
from kinegrade.cli.export import export
from kinegrade.cli.marks import class_report, diff, feedback, grade
from kinegrade.cli.practice import practice
from kinegrade.cli.printing import paper, papers, reprint_exam, sample, solutions
from kinegrade.cli.problems.choosing import list_templates, show
from kinegrade.cli.problems.cycle import cycle
from kinegrade.cli.problems.preview import preview
from kinegrade.cli.problems.solve import solve
from kinegrade.cli.problems.starters import new
from kinegrade.cli.problems.templates import check, gallery
from kinegrade.cli.problems.vocabulary import words
from kinegrade.cli.quiz import quiz
from kinegrade.cli.rosters import assign, exchange, roster
from kinegrade.cli.running.program import Program
from kinegrade.cli.series import series
from kinegrade.cli.sharing import sharing
from kinegrade.cli.term import term


@click.group(cls=Program, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="kinegrade")
def main() -> None:
    """Set, typeset and mark exams in planar kinematics."""
    # Read when numpy is loaded: its linear algebra library would start threads that nothing here
    # needs, and a process with threads cannot safely be copied.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


for command in (
    list_templates,
    show,
    solve,
    cycle,
    check,
    preview,
    new,
    words,
    gallery,
    roster,
    generate,
    series,
    sample,
    practice,
    papers,
    paper,
    reprint_exam,
    solutions,
    assign,
    exchange,
    archive,
    verify,
    doctor,
    compare_entries,
    grade,
    diff,
    class_report,
    feedback,
    explain,
    merge,
    forget,
    sharing,
    export,
    term,
    quiz,
):
    main.add_command(command)
