"""The recipe "Add an ask" of CONTRIBUTING, followed on a copy with the point of a body that has no
acceleration; each of its steps left out, one by one, is refused by name.
"""

from __future__ import annotations

import csv
import json
import subprocess
from pathlib import Path
from typing import Any

import pytest

from kinegrade.problem.template.library.library import find_shipped
from tests.recipes.recipe import Step, edit, follow_steps, read_titles, run, run_python

READ = """def _read_acceleration_pole(reader, body):
    motion, name = reader.motion, reader.body(body)
    base = motion.frames.bases[name].point
    acceleration, omega, alpha = motion.acceleration(base, name), motion.omega(name), motion.alpha(name)
    turned = acceleration * (omega * omega) + acceleration.turned() * alpha
    return motion.points[base] + turned / (omega * omega * omega * omega + alpha * alpha)


"""
REFER = """def _refer_to_acceleration_pole(names, reader):
    return References(((names[0], reader.motion.frames.bases[names[0]].point),), (names[0],))


"""
FIELDS = {
    "example": '"acceleration_pole(AB)"',
    "slots": '("BODY",)',
    "gives": "Arrow(LENGTH)",
    "by_changes": "True",
    "read": "_read_acceleration_pole",
    "refer": "_refer_to_acceleration_pole",
    "derivation": '"value"',
}
WORDS = """
msgctxt "function-acceleration_pole"
msgid "The point of a body that has no acceleration."
msgstr ""
"""
ASK = """
x_Q = { quantity = "x(acceleration_pole(AB))", unit = "m", sign = "+x", points = 2, means = { en = "$x$ of $Q$", zh = "$Q$" } }
q_x = { quantity = "x(acceleration_pole(AB) - B)", unit = "m", sign = "+x", means = { en = "of $BQ$", zh = "$BQ$" } }
q_y = { quantity = "y(acceleration_pole(AB) - B)", unit = "m", sign = "+y", means = { en = "up $BQ$", zh = "$BQ$ y" } }
"""
BANK = 'title = "T"\ncourse = "C"\n[[questions]]\ntemplate = "crank.toml"\nasks = { omega_AB = 1, x_Q = 2 }\n'
REPEATED = ("--reproducible", "words", "--jobs", 1, "--solutions")
VERDICTS = ["right", "right", "mistake", "follow-through"]  # the last follows from the one before


def row(*left_out: str) -> str:
    fields = ", ".join(f"{name}={text}" for name, text in FIELDS.items() if name not in left_out)
    return f'    "acceleration_pole": MotionFunction({fields}),\n'


def functions(room: Path) -> Path:
    return room / "kinegrade/problem/quantities/motion_functions.py"


def add_reading(room: Path) -> None:
    edit(functions(room), ("MOTION_FUNCTIONS: Mapping", f"{READ}MOTION_FUNCTIONS: Mapping"))


def add_references(room: Path) -> None:
    edit(functions(room), ("MOTION_FUNCTIONS: Mapping", f"{REFER}MOTION_FUNCTIONS: Mapping"))


def add_row(room: Path) -> None:
    append(room, row())


def append(room: Path, text: str) -> None:
    whole = functions(room).read_text(encoding="utf-8").removesuffix("}\n")
    functions(room).write_text(f"{whole}{text}}}\n", encoding="utf-8")


def add_words(room: Path) -> None:
    file = room / "kinegrade/language/catalogues/en/words.po"
    file.write_text(file.read_text(encoding="utf-8") + WORDS, encoding="utf-8")


def check(room: Path) -> str:
    return run(room, "check", "crank.toml", "--sample", "20").stderr


def list_words(room: Path) -> str:
    done = run(room, "words", "quantities")
    return done.stdout + done.stderr


STEPS = (
    Step("How it is read", add_reading, "'_read_acceleration_pole' is not defined", check),
    Step("What it refers to", add_references, "'_refer_to_acceleration_pole' is not", check),
    Step("Its row", add_row, 'unknown function "acceleration_pole"', check),
    Step("Its words", add_words, "no entry words.function-acceleration_pole", list_words),
)


@pytest.fixture
def room(tmp_path: Path) -> Path:
    """A folder with a template that asks for the new thing and a bank, for the copy."""
    text = (find_shipped("templates") / "slider-crank.toml").read_text(encoding="utf-8")
    asking = text.replace("\n[asks]\n", f"\n[asks]{ASK}")
    (tmp_path / "crank.toml").write_text(asking, encoding="utf-8")
    (tmp_path / "bank.toml").write_text(BANK, encoding="utf-8")
    (tmp_path / "roster.csv").write_text("student,name\n1,Ann\n2,Bo\n", encoding="utf-8")
    return tmp_path


def test_the_steps_are_those_of_the_recipe() -> None:
    assert [step.title for step in STEPS] == read_titles("Add an ask")


@pytest.mark.left(beside="test_an_ask_without_a_step")
def test_the_new_ask_is_proved_set_explained_and_marked(room: Path) -> None:
    follow_steps(room, STEPS)
    checked = run(room, "check", "crank.toml", "--sample", "20")
    assert checked.stdout.startswith("crank: sound"), checked.stderr
    assert_no_acceleration(room)
    made = run(room, "generate", "bank.toml", "roster.csv", "-o", "EXAM", *REPEATED)
    assert made.returncode == 0, made.stderr
    assert "𝑥𝑄" in read_solution(room)
    first, second = find_asks(room, "1"), find_asks(room, "2")
    right = [str(ask["value"]) for ask in first.values()]
    wrong = [ask["mistakes"]["wrong-pole"] for ask in second.values()]
    assert mark(room, ["1", "Ann", *right], ["2", "Bo", *wrong]).returncode == 0
    marks = (room / "MARKS/marks.csv").read_text(encoding="utf-8").splitlines()
    assert [line.split(",")[6] for line in marks[1:]] == VERDICTS


def read_solution(room: Path) -> str:
    """The worked solution of a student, as text."""
    pdf = min((room / "EXAM/solutions").glob("*.pdf"))
    done = subprocess.run(["pdftotext", pdf, "-"], capture_output=True, text=True, check=True)
    return done.stdout


def find_asks(room: Path, student: str) -> dict[str, Any]:
    """The key of a student's question."""
    lines = (room / "EXAM/key.jsonl").read_text(encoding="utf-8").splitlines()
    keys = {key["student"]: key for key in map(json.loads, lines)}
    asks: dict[str, Any] = keys[student]["questions"][0]["asks"]
    return asks


def mark(room: Path, *rows: list[str]) -> subprocess.CompletedProcess[str]:
    """The class marked by these rows of answers."""
    with (room / "EXAM/answers.csv").open(encoding="utf-8-sig", newline="") as stream:
        header = next(csv.reader(stream))
    with (room / "answers.csv").open("w", encoding="utf-8", newline="") as stream:
        csv.writer(stream).writerows([header, *rows])
    return run(room, "grade", "EXAM", "answers.csv", "-o", "MARKS")


def assert_no_acceleration(room: Path) -> None:
    """By the motion of B, the point that was found has none."""
    solved = run(room, "solve", "crank.toml", "--set", "phi=45", "--set", "alpha=5", "--json")
    answers = {name: found["value"] for name, found in json.loads(solved.stdout)["answers"].items()}
    x, y, square = answers["q_x"], answers["q_y"], answers["omega_AB"] ** 2
    along = answers["a_B"] - answers["alpha_AB"] * y - square * x
    assert abs(along) + abs(answers["alpha_AB"] * x - square * y) < 1e-9


@pytest.mark.sampled(3, by="missing")
@pytest.mark.parametrize("missing", STEPS, ids=lambda step: step.title)
def test_an_ask_without_a_step(room: Path, missing: Step) -> None:
    assert missing.refused in missing.ask(follow_steps(room, STEPS, missing))


def test_a_row_that_leaves_something_open_cannot_be_imported(room: Path) -> None:
    follow_steps(room, STEPS[:2])
    before = functions(room).read_text(encoding="utf-8")
    for name in FIELDS:
        functions(room).write_text(before, encoding="utf-8")
        append(room, row(name))
        done = run_python(room, "-c", "import kinegrade.problem.quantities.motion_functions")
        assert f"Missing required argument '{name}'" in done.stderr
