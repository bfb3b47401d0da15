"""The command line. Heavy modules are imported by the commands that need them, so that `--help` answers at once.

Results go to standard output or to `-o`, talk goes to standard error. Exit status: 0 fine, 1 done with complaints,
2 cannot be done; an error is one line for each fault.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from functools import wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from kinegrade import __version__
from kinegrade.errors import KinegradeError, TemplateError

if TYPE_CHECKING:
    from kinegrade.exam.document import PaperSize
    from kinegrade.exam.press import Engine
    from kinegrade.grading.decimal_style import Mark as DecimalMark
    from kinegrade.problem.solving import Solution
    from kinegrade.problem.template import Language, Method

COMPLAINTS = 1
FAILURE = 2
LANGUAGE = click.option("--lang", "language", type=click.Choice(["en", "zh"]), default="en", show_default=True,
                        help="Language of the output.")
METHOD = click.option("--method", type=click.Choice(["base-point", "projection", "pole"]),
                      help="How worked solutions find velocities where several methods serve.  "
                           "[default: what the template says]")
FORCE = click.option("--force", is_flag=True, help="Replace an output that kinegrade wrote before.")
FILE = click.Path(path_type=Path)


def writable(context: click.Context, parameter: click.Parameter, seed: str | None) -> str | None:
    """A seed that can be written down and used again. Raises BadParameter for a blank one and for broken text."""
    if seed is not None and (not seed.strip() or any("\ud800" <= character <= "\udfff" for character in seed)):
        raise click.BadParameter("expected some text, like spring-2026")
    return seed


def refusing(command: Callable[..., None]) -> Callable[..., None]:
    """A command whose refusals become one line each on standard error, and status 2."""
    @wraps(command)
    def run(*arguments: Any, **options: Any) -> None:
        try:
            command(*arguments, **options)
        except KinegradeError as error:
            for problem in error.problems:
                click.echo(f"error: {' '.join(problem.split())}", err=True)
            sys.exit(FAILURE)
    return run


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="kinegrade")
def main() -> None:
    """Set, typeset and mark exams in planar kinematics.

    \b
    kinegrade generate banks/demo.toml roster.csv -o EXAM --seed spring
    kinegrade grade EXAM answers.csv -o MARKS
    """


@main.command("list")
@LANGUAGE
@refusing
def list_templates(language: Language) -> None:
    """List the problem templates.

    \b
    Example: kinegrade list --lang zh
    """
    from kinegrade.problem.library import load_template, template_names

    for name in template_names():
        template = load_template(name)
        click.echo(f"{name}\t{template.family}\t{template.title.in_language(language)}")


@main.command()
@click.argument("template_name", metavar="TEMPLATE")
@LANGUAGE
@click.option("-o", "--output", type=FILE, help="Also typeset a sample page as PDF.")
@click.option("--seed", callback=writable, default="sample", show_default=True, help="Which sample is typeset.")
@FORCE
@refusing
def show(template_name: str, language: Language, output: Path | None, seed: str, force: bool) -> None:
    """Show a template: statement, parameters, what can be asked, how many instances.

    \b
    Example: kinegrade show slider-crank -o page.pdf
    """
    from kinegrade.problem.describing import describe
    from kinegrade.problem.library import load_template

    template = load_template(template_name)
    click.echo(describe(template, language))
    if output is not None:
        from kinegrade.exam.sample import sample_page
        from kinegrade.files import write_file

        write_file(output, sample_page(template, seed, language), force=force)


@main.command()
@click.argument("template_name", metavar="TEMPLATE")
@click.option("--set", "settings", multiple=True, metavar="NAME=VALUE",
              help="A parameter's value in its unit: a number or an exact expression.")
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
@click.option("-o", "--output", type=FILE, metavar="FILE", help="Also typeset the worked solution as PDF.")
@METHOD
@LANGUAGE
@FORCE
@refusing
def solve(*, template_name: str, settings: tuple[str, ...], as_json: bool, output: Path | None, method: Method | None,
          language: Language, force: bool) -> None:
    """Solve a template exactly at given values; the rest take their published value, or the first drawable one.

    \b
    Example: kinegrade solve slider-crank --set r=1/5 --set phi=40 -o solution.pdf --method pole
    """
    from kinegrade.problem.library import load_template
    from kinegrade.problem.solving import solve_template

    solution = solve_template(load_template(template_name), read_settings(settings))
    click.echo(solution_json(solution) if as_json else solution_text(solution))
    if output is not None:
        from kinegrade.exam.sample import worked_page
        from kinegrade.files import write_file

        write_file(output, worked_page(solution, language, method), force=force)


def read_settings(settings: tuple[str, ...]) -> dict[str, str]:
    """The values of --set. Raises TemplateError for a setting without "=" or given twice."""
    values: dict[str, str] = {}
    faults = []
    for setting in settings:
        name, mark, value = setting.partition("=")
        if not mark or not name.strip() or not value.strip():
            faults.append(f'--set "{setting}": expected NAME=VALUE, like r=1/5')
        elif name.strip() in values:
            faults.append(f"--set {name.strip()}: given twice: give it once")
        values[name.strip()] = value.strip()
    if faults:
        raise TemplateError(*faults)
    return values


def solution_json(solution: Solution) -> str:
    """The solution as JSON. Raises TemplateError for values that no JSON number holds."""
    import json

    record = {
        "template": solution.template.name,
        "parameters": {name: quantity.record() for name, quantity in solution.parameters.items()},
        "answers": {name: quantity.record() for name, quantity in solution.answers.items()},
    }
    try:
        return json.dumps(record, ensure_ascii=False, indent=1, allow_nan=False)
    except ValueError as error:
        raise TemplateError("a value is beyond 1e308, which JSON numbers do not reach: give smaller ones") from error


def solution_text(solution: Solution) -> str:
    """The solution as a table: name, decimal, unit, exact."""
    lines = []
    for group in (solution.parameters, solution.answers):
        lines += [f"{name:<14} {quantity.decimal(10):>18} {quantity.measure.printed:<6}  "
                  f"{quantity.exact or '(certified enclosure)'}" for name, quantity in group.items()]
        lines.append("")
    return "\n".join(lines[:-1])


@main.command()
@click.argument("template_names", metavar="[TEMPLATE]...", nargs=-1)
@click.option("--sample", type=click.IntRange(1, 1_000_000), default=200, show_default=True,
              help="How many combinations are drawn.")
@refusing
def check(template_names: tuple[str, ...], sample: int) -> None:
    """Prove templates: published results exactly, drawn instances solvable and sensible (default: all shipped).

    \b
    Example: kinegrade check slider-crank --sample 1000
    """
    from kinegrade.problem.checking import check as prove
    from kinegrade.problem.library import load_template
    from kinegrade.problem.library import template_names as shipped_names
    from kinegrade.problem.reporting import report_lines

    sound = True
    for name in template_names or shipped_names():
        report = prove(load_template(name), sample)
        for line in report_lines(report):
            click.echo(line)
        sound &= not report.faults
    if not sound:
        sys.exit(COMPLAINTS)


@main.command()
@click.argument("name")
@click.option("-o", "--output", type=FILE, metavar="FILE", help="The file to write.  [default: NAME.toml]")
@FORCE
@refusing
def new(name: str, output: Path | None, force: bool) -> None:
    """Write a starter template, complete and sound, to put another mechanism into.

    \b
    Example: kinegrade new my-mechanism -o templates/my-mechanism.toml
    """
    from kinegrade.problem.starter import write_starter

    path = write_starter(name, output, force=force)
    click.echo(f"{path}: written; prove it with: kinegrade check {path}", err=True)


@main.command()
@click.argument("template_names", metavar="[TEMPLATE]...", nargs=-1)
@click.option("-o", "--output", type=FILE, required=True, metavar="FILE", help="The PDF to write.")
@LANGUAGE
@click.option("--draws", type=click.IntRange(1, 12), default=3, show_default=True,
              help="At how many draws each figure is shown.")
@FORCE
@refusing
def gallery(*, template_names: tuple[str, ...], output: Path, language: Language, draws: int, force: bool) -> None:
    """Typeset a contact sheet to choose templates from: what each asks, and its figure (default: all shipped).

    \b
    Example: kinegrade gallery -o gallery.pdf --lang zh --draws 2
    """
    from kinegrade.exam.gallery import contact_sheet
    from kinegrade.files import write_file
    from kinegrade.problem.library import template_names as shipped_names

    sheet = contact_sheet(template_names or shipped_names(), language, draws)
    write_file(output, sheet.pdf, force=force)
    finish(sheet.complaints)


@main.command()
@click.argument("bank", type=FILE)
@click.argument("roster", type=FILE)
@click.option("-o", "--output", type=FILE, required=True, metavar="EXAM", help="The exam folder to write.")
@click.option("--seed", callback=writable, help="The exam's secret; drawn and printed if not given.")
@LANGUAGE
@click.option("--paper-size", type=click.Choice(["a4", "letter"]), default="a4", show_default=True)
@click.option("--engine", type=click.Choice(["typst", "latex"]),
              help="What typesets the exam.  [default: what the bank says, else typst]")
@click.option("--solutions/--no-solutions", default=False, show_default=True,
              help="Also write everybody's worked solutions.")
@click.option("--jobs", type=click.IntRange(1), metavar="N",
              help="How many processes print a large class.  [default: one for each core]")
@FORCE
@refusing
def generate(*, bank: Path, roster: Path, output: Path, seed: str | None, language: Language, paper_size: PaperSize,
             engine: Engine | None, solutions: bool, jobs: int | None, force: bool) -> None:
    """Draw, solve and typeset an exam for every student of ROSTER (CSV: student, name).

    BANK is the exam's blueprint: a TOML file, or the name of one that is shipped: acceleration-midterm, demo, final,
    velocity-quiz.

    \b
    Example: kinegrade generate demo banks/demo-roster.csv -o EXAM --seed spring --lang zh
    """
    from os import cpu_count
    from secrets import token_hex

    from kinegrade.exam.bank import bank_path, read_blueprint
    from kinegrade.exam.generate import generate as write_exam
    from kinegrade.exam.roster import read_roster

    secret = seed if seed is not None else token_hex(8)
    click.echo(f"seed: {secret}", err=True)
    written = write_exam(read_blueprint(bank_path(bank)), read_roster(roster), output, secret, language, force=force,
                         paper_size=paper_size, engine=engine, solutions=solutions, jobs=jobs or cpu_count() or 1,
                         progress=progress)
    for question, template in written.drawn.items():
        click.echo(f"{question}: drawn from the bank: {template}", err=True)
    for question, combinations in written.combinations.items():
        refused = ", ".join(f"{reason} {count}" for reason, count in written.refusals[question].items())
        click.echo(f"{question}: {combinations} combinations, refused draws: {refused or 'none'}", err=True)
    click.echo(f"{output}: {written.papers} papers; give students what is under {output / 'papers'}, nothing else",
               err=True)
    finish(written.complaints)


def progress(items: Iterator[Any], count: int) -> Iterator[Any]:
    """The items with a progress bar on standard error, when that is a terminal."""
    if not sys.stderr.isatty():
        yield from items
        return
    with click.progressbar(items, length=count, label="papers", file=sys.stderr) as bar:
        yield from bar


@main.command()
@click.argument("exam", type=FILE)
@click.argument("answers", type=FILE)
@click.option("-o", "--output", type=FILE, required=True, metavar="MARKS", help="The folder of marks to write.")
@click.option("--decimal", type=click.Choice(["point", "comma"]),
              help="What 1,234 and 1.234 mean in ANSWERS.  [default: what its other cells tell]")
@FORCE
@refusing
def grade(*, exam: Path, answers: Path, output: Path, decimal: DecimalMark | None, force: bool) -> None:
    """Mark the class: ANSWERS is a CSV of the shape of EXAM/answers.csv.

    \b
    Example: kinegrade grade EXAM answers.csv -o MARKS
    """
    from kinegrade.grading.grade import grade as mark_class
    from kinegrade.lms import moodle

    marks = mark_class(exam, answers, output, force=force, exports={"moodle.csv": moodle.export}, decimal=decimal)
    click.echo(f"{output}: {len(marks.grades)} students marked, {len(marks.complaints)} complaints", err=True)
    finish(tuple(map(str, marks.complaints)))


def finish(complaints: tuple[str, ...]) -> None:
    """Print complaints on standard error; with any, end with status 1."""
    for complaint in complaints:
        click.echo(f"complaint: {' '.join(complaint.split())}", err=True)
    if complaints:
        sys.exit(COMPLAINTS)


@main.command()
@click.argument("marks", type=FILE)
@click.option("--to", "system", type=click.Choice(["moodle"]), required=True, help="The learning management system.")
@click.option("-o", "--output", type=FILE, required=True, metavar="FILE", help="The file to write.")
@FORCE
@refusing
def export(marks: Path, system: str, output: Path, force: bool) -> None:
    """Write the grades of MARKS in the form that a learning management system imports.

    \b
    Example: kinegrade export MARKS --to moodle -o moodle.csv
    """
    from kinegrade.files import write_file
    from kinegrade.lms import moodle

    writers = {"moodle": moodle.export}
    write_file(output, writers[system](marks).encode("utf-8"), force=force)
