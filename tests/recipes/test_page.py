"""The recipe "Add a page" of CONTRIBUTING, followed on a copy with a list of seats that no exam has;
each of its steps left out, one by one, is refused by name.
"""

from __future__ import annotations

import inspect
import shutil
import subprocess
from pathlib import Path

import pytest

from tests.press import unshared
from tests.recipes.recipe import Step, edit, follow_steps, read_titles, run, run_python

VALUE = '''

@dataclass(frozen=True)
class SeatSheet:
    """Where the students sit."""

    language: Language
    title: str  # prose
    students: tuple[str, ...]  # plain
'''
METHOD = '''
    @abstractmethod
    def seats(self, sheet: SeatSheet) -> Printout:
        """Where the students sit."""
'''
TYPST = """from kinegrade.language.prose.typst import write_line
from kinegrade.press.typst.layout_call import write_layout_call


def write_seats_source(sheet):
    title = write_line(sheet.title, "the seats", sheet.language)
    return write_layout_call("seats", {"title": title, "students": sheet.students})
"""
TYPST_METHOD = """    def seats(self, sheet: SeatSheet) -> Printout:
        return Printout(self._explaining(write_seats_source(sheet), "the seats"))

    def gallery("""
LAYOUT = """#let seats(sheet) = {
  set text(font: "New Computer Modern")
  set document(title: "seats", date: datetime(year: 2000, month: 1, day: 1))
  heading(eval(sheet.title, mode: "code"))
  for student in sheet.students [+ #student]
}
"""
LATEX = """from kinegrade.language.math.latex_text import write_plain
from kinegrade.language.prose.latex import write_line


def write_seats_body(sheet):
    students = "".join(f"\\\\par {write_plain(student)}" for student in sheet.students)
    return write_line(sheet.title, "the seats") + students
"""
LATEX_METHOD = """    def seats(self, sheet: SeatSheet) -> Printout:
        return self._print_one("seats", write_seats_body(sheet), sheet.language, "the seats")

    def _print_one("""
COMMAND = """from pathlib import Path

import click

from kinegrade.cli.options import refusing


@click.command()
@click.argument("exam", type=Path)
@click.argument("engine")
@click.argument("output", type=Path)
@refusing
def seats(exam, engine, output):
    from kinegrade.exam.folder.exam_folder import open_exam
    from kinegrade.exam.printing.printing import PressOrder
    from kinegrade.press.sheet import SeatSheet

    head = open_exam(exam).head
    students = tuple(student.student for student in head.students)
    press = PressOrder(engine, "a4").press()
    output.write_bytes(press.seats(SeatSheet(head.language, "Seats, $x_1$", students)).pdf)
"""


def add_value(room: Path) -> None:
    file = room / "kinegrade/press/sheet.py"
    file.write_text(file.read_text(encoding="utf-8") + VALUE, encoding="utf-8")


def add_method(room: Path) -> None:
    edit(
        room / "kinegrade/press/protocol.py",
        ("import KeyBook, Paper,", "import KeyBook, Paper, SeatSheet,"),
        (
            "\n    @abstractmethod\n    def unprintable",
            f"{METHOD}\n    @abstractmethod\n    def unprintable",
        ),
    )


def print_by_typst(room: Path) -> None:
    (room / "kinegrade/press/typst/seats.py").write_text(TYPST, encoding="utf-8")
    edit(
        room / "kinegrade/press/typst/press.py",
        (
            "from kinegrade.press.typst.paper import",
            "from kinegrade.press.typst.seats import write_seats_source\n"
            "from kinegrade.press.typst.paper import",
        ),
        ("    def gallery(", TYPST_METHOD),
    )


def add_layout(room: Path) -> None:
    (room / "kinegrade/press/typst/layouts/seats.typ").write_text(LAYOUT, encoding="utf-8")


def print_by_latex(room: Path) -> None:
    (room / "kinegrade/press/latex/seats.py").write_text(LATEX, encoding="utf-8")
    edit(
        room / "kinegrade/press/latex/press.py",
        (
            "from kinegrade.press.latex.key import",
            "from kinegrade.press.latex.seats import write_seats_body\n"
            "from kinegrade.press.latex.key import",
        ),
        ("    def _print_one(", LATEX_METHOD),
    )


def add_command(room: Path) -> None:
    (room / "kinegrade/cli/seats.py").write_text(COMMAND, encoding="utf-8")
    edit(
        room / "kinegrade/cli/__init__.py",
        (
            "from kinegrade.cli.sharing import",
            "from kinegrade.cli.seats import seats\nfrom kinegrade.cli.sharing import",
        ),
        ("    sharing,\n", "    sharing,\n    seats,\n"),
    )


def print_seats(room: Path, engine: str) -> str:
    return run(room, "seats", "EXAM", engine, f"{engine}.pdf").stderr


def compare_presses(room: Path) -> str:
    return run_python(room, "-c", inspect.getsource(unshared)).stdout


def typst(room: Path) -> str:
    return print_seats(room, "typst")


def latex(room: Path) -> str:
    return print_seats(room, "latex")


STEPS = (
    Step("Its value", add_value, "cannot import name 'SeatSheet'", typst),
    Step(
        "What every press has to print",
        add_method,
        "Press.seats: missing",
        compare_presses,
    ),
    Step(
        "In Typst",
        print_by_typst,
        "abstract class TypstPress",
        typst,
    ),
    Step("Its Typst layout", add_layout, "seats.typ", typst),
    Step(
        "In LaTeX",
        print_by_latex,
        "abstract class LatexPress",
        latex,
    ),
    Step("What prints it", add_command, "No such command 'seats'", typst),
)


@pytest.fixture
def room(tmp_path: Path, small_class: Path) -> Path:
    """A folder with an EXAM, into which the package will be copied."""
    shutil.copytree(small_class / "EXAM", tmp_path / "EXAM")
    return tmp_path


def test_the_steps_are_those_of_the_recipe() -> None:
    assert [step.title for step in STEPS] == read_titles("Add a page")


@pytest.mark.needs_tex
def test_the_new_page_is_printed_by_every_typesetter(room: Path) -> None:
    follow_steps(room, STEPS)
    for engine in ("typst", "latex"):
        assert print_seats(room, engine) == ""
        pages = subprocess.run(
            ["pdftotext", f"{engine}.pdf", "-"],
            cwd=room,
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        assert "Seats" in pages
        assert "0012" in pages


@pytest.mark.sampled(3, by="missing")
@pytest.mark.parametrize("missing", STEPS, ids=lambda step: step.title)
def test_a_page_without_a_step(room: Path, missing: Step) -> None:
    assert missing.refused in missing.ask(follow_steps(room, STEPS, missing))
