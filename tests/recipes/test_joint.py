"""The recipe "Add a joint or a driver" of CONTRIBUTING, followed on a copy with a joint that does not
exist: one body turns twice as fast as another. Each of its steps left out, one by one, is refused by
name.
"""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from kinegrade.language import ENGLISH
from kinegrade.language.known import known_languages
from tests.laws import position
from tests.recipes.recipe import Step, edit, follow_steps, read_titles, run, run_python

VALUE = '''from dataclasses import dataclass

from kinegrade.language.message import Message
from kinegrade.mechanics.joints.constraint import Constraint
from kinegrade.mechanics.laws import DoubledRotation


@dataclass(frozen=True)
class Doubling(Constraint):
    """`body` turns twice as fast as `of`."""

    PATTERN = r"(?P<body>\\w+) turns twice with (?P<of>\\w+)"
    FORM = "BODY turns twice with BODY"
    EXAMPLES = ("II turns twice with I",)
    SLIPS = ()

    body: str
    of: str

    @classmethod
    def make(cls, parts):
        return cls(parts.body, parts.of)

    def list_bodies(self):
        return self.body, self.of

    def list_turning_bodies(self):
        return self.body, self.of

    def list_points(self):
        return ()

    def describe(self):
        return Message("mechanics.doubling", body=self.body, of=self.of)

    def list_shapes(self):
        return ()

    def list_conditions(self):
        return ()

    def relate_rates(self, number, points, guided):
        return DoubledRotation(self.body, self.of)

    def find_misfits(self, points, arithmetic):
        return iter(())
'''
LAW = '''from dataclasses import dataclass

from kinegrade.language.message import Message
from kinegrade.mechanics.laws.reason import Reason
from kinegrade.mechanics.laws.turning import Turning, add_up
from kinegrade.mechanics.shares import Shares


@dataclass(frozen=True)
class DoubledRotation(Reason):
    """One body turns twice as fast as another."""

    body: str
    of: str

    def describe(self, element: Message) -> Message:
        return element

    @property
    def is_given(self) -> bool:
        return False

    def list_factors(self, shares: Shares) -> Turning:
        return add_up((self.body, 1), (self.of, -2))
'''
STATEMENT = """from kinegrade.language.message import Message
from kinegrade.worked.formulas.equation import Equation, equate
from kinegrade.worked.rates.speeds import Statement, name_rotation


def state_doubling(law, case, level):
    names = {"body": case.naming.body(law.body), "other": case.naming.body(law.of)}
    left, right = (name_rotation(name, case, level) for name in (law.body, law.of))
    return Statement(
        Message("solution.title-doubling", **names),
        Message("solution.doubling"),
        Equation(left, equate(right + right)),
    )
"""
WORDS = {
    "words": '\nmsgctxt "joint-doubling"\nmsgid "One turns twice as fast."\nmsgstr ""\n',
    "mechanics": '\n#, noun\nmsgctxt "doubling"\nmsgid "the doubling of <of> by <body>"\nmsgstr ""\n',
    "description": '\nmsgctxt "doubling"\nmsgid "<Body> turns twice as fast as <of>."\nmsgstr ""\n',
    "solution": '\nmsgctxt "title-doubling"\nmsgid "<body> turns with <other>"\nmsgstr ""\n'
    '\nmsgctxt "doubling"\nmsgid "Twice as fast at all times:"\nmsgstr ""\n',
}
UNTRANSLATED = re.compile(r'msgid "(.*)"\nmsgstr ""')
TRANSLATED = r'msgid "\1"\nmsgstr "\1"'  # into English: any words will do
PROOF = """
import sys
from flint import fmpq
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from pathlib import Path
from position import moving

solution = solve_template(load_template("twice", Path(".")), {})
moved = moving(solution.motion.frames.mechanism)
print([round(float(rate), 9) for rate in (moved.omega["II"], moved.alpha["II"])])
"""
DESCRIBED = """
from pathlib import Path
from kinegrade.description.description import describe
from kinegrade.language import Language
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template

solution = solve_template(load_template("twice", Path(".")), {})
print(describe(solution, Language("en")).long[2].text)
"""
TEMPLATE = """
family = "wheels"
source = "worked out by hand"
joints = ["pin O: ground I", "pin A: ground II", "II turns twice with I"]
inputs = [{ motion = "I turns", velocity = "w", acceleration = "e" }]
title = "Twice"
statement = "I turns about O with {{ w }} and {{ e }}, II about A at {{ l }} twice as fast."

[parameters]
l = { unit = "m", draw = "0.5 .. 1.5 step 0.01", means = "distance" }
w = { unit = "rad/s", draw = "2 .. 9 step 1", means = "angular velocity" }
e = { unit = "rad/s^2", draw = "2 .. 9 step 1", means = "angular acceleration" }

[points]
O = "(0, 0)"
A = "(l, 0)"
B = "(0, l)"

[bodies]
I = "O B"
II = "A B"

[asks]
omega_II = { quantity = "omega(II)", unit = "rad/s", sign = "ccw", points = 2, means = "of II" }
alpha_II = { quantity = "alpha(II)", unit = "rad/s^2", sign = "ccw", points = 2, means = "of II" }

[[published]]
source = "by hand"
gives = { omega_II = "2*w", alpha_II = "2*e" }
"""


def package(room: Path, name: str) -> Path:
    return room / "kinegrade" / name


def add_file(room: Path) -> None:
    package(room, "mechanics/joints/doubling.py").write_text(VALUE, encoding="utf-8")


def add_law(room: Path) -> None:
    package(room, "mechanics/laws/doubling.py").write_text(LAW, encoding="utf-8")
    edit(
        package(room, "mechanics/laws/__init__.py"),
        (
            "from kinegrade.mechanics.laws.imposed",
            "from kinegrade.mechanics.laws.doubling import DoubledRotation\n"
            "from kinegrade.mechanics.laws.imposed",
        ),
        ("\nLaw = (", "\nLaw = (\n    DoubledRotation |"),
    )


def add_name(room: Path) -> None:
    edit(
        package(room, "mechanics/joints/__init__.py"),
        (
            "from kinegrade.mechanics.joints.mesh",
            "from kinegrade.mechanics.joints.doubling import Doubling\n"
            "from kinegrade.mechanics.joints.mesh",
        ),
        ("\nJoint = ", "\nJoint = Doubling | "),
    )


def add_statement(room: Path) -> None:
    package(room, "worked/rates/doubling.py").write_text(STATEMENT, encoding="utf-8")
    edit(
        package(room, "worked/rates/scalars.py"),
        ("    EqualRotation,\n", "    DoubledRotation,\n    EqualRotation,\n"),
        (
            "from kinegrade.worked.rates.driven",
            "from kinegrade.worked.rates.doubling import state_doubling\n"
            "from kinegrade.worked.rates.driven",
        ),
        (
            "        case EqualRotation():\n            return",
            "        case DoubledRotation():\n            return state_doubling(source, case, level)\n"
            "        case EqualRotation():\n            return",
        ),
        (
            "        case SharedPoint() | GuidedPoint() | None:\n            yield",
            "        case DoubledRotation() | SharedPoint() | GuidedPoint() | None:\n            yield",
        ),
    )


def add_symbol(room: Path) -> None:
    edit(
        package(room, "figure/joints/table.py"),
        (
            "from kinegrade.mechanics.mechanism",
            "from kinegrade.mechanics.joints.doubling import Doubling\n"
            "from kinegrade.mechanics.mechanism",
        ),
        (
            "        case Parallel(body=body, of=of):",
            "        case Doubling():\n            return Symbol()\n"
            "        case Parallel(body=body, of=of):",
        ),
        ("        case Pin() | Parallel():", "        case Pin() | Parallel() | Doubling():"),
    )


def add_sentence(room: Path) -> None:
    joined = (
        "from kinegrade.problem.template.sentences",
        "from kinegrade.mechanics.joints.doubling import Doubling\n"
        "from kinegrade.problem.template.sentences",
    )
    edit(
        package(room, "description/joints.py"),
        joined,
        (
            "        case Parallel(body=body, of=of) if",
            "        case Doubling(body=body, of=of):\n"
            "            names = {'body': subject.body(body), 'of': subject.body(of)}\n"
            "            yield Message('description.doubling', **names)\n"
            "        case Parallel(body=body, of=of) if",
        ),
    )
    edit(
        package(room, "description/determined.py"),
        joined,
        ("        case Pin() | Parallel()", "        case Doubling() | Pin() | Parallel()"),
    )


def add_words(room: Path) -> None:
    for language in known_languages():
        for domain, entries in WORDS.items():
            file = package(room, f"language/catalogues/{language}/{domain}.po")
            said = entries if language == ENGLISH else UNTRANSLATED.sub(TRANSLATED, entries)
            file.write_text(file.read_text(encoding="utf-8") + said, encoding="utf-8")


def add_proof(room: Path) -> None:
    edit(
        room / "position.py",
        (
            "            case Parallel(body, of):",
            "            case _ if type(joint).__name__ == 'Doubling':\n"
            "                yield turn[joint.body] - 2 * turn[joint.of]\n"
            "            case Parallel(body, of):",
        ),
    )


def check(room: Path) -> str:
    return run(room, "check", "twice.toml", "--sample", "20").stderr


def show(room: Path) -> str:
    return run(room, "show", "twice.toml", "-o", "page.pdf", "--force").stderr


def solve(room: Path) -> str:
    return run(room, "solve", "twice.toml", "-o", "solution.pdf", "--force").stderr


def describe(room: Path) -> str:
    done = run_python(room, "-c", DESCRIBED)
    return done.stderr + done.stdout


def prove(room: Path) -> str:
    done = run_python(room, "-c", PROOF)
    return done.stderr + done.stdout


STEPS = (
    Step("Its file", add_file, "No module named 'kinegrade.mechanics.joints.doubling'", check),
    Step("Its law", add_law, "cannot import name 'DoubledRotation'", check),
    Step("Its name in the room", add_name, '"II turns twice with I": no such joint', check),
    Step("Its step in worked solutions", add_statement, "DoubledRotation(", solve),
    Step("How it is drawn", add_symbol, "Doubling(", show),
    Step("How it is said", add_sentence, "Doubling(", describe),
    Step("Its words", add_words, "no entry solution.doubling", solve),
    Step("Its proof", add_proof, "Doubling(", prove),
)


@pytest.fixture
def room(tmp_path: Path) -> Path:
    """A folder with a template that states the joint, and the model of positions."""
    (tmp_path / "twice.toml").write_text(TEMPLATE, encoding="utf-8")
    shutil.copy(position.__file__, tmp_path / "position.py")
    return tmp_path


def test_the_steps_are_those_of_the_recipe() -> None:
    assert [step.title for step in STEPS] == read_titles("Add a joint or a driver")


@pytest.mark.left(beside="test_a_joint_without_a_step")
def test_the_new_joint_is_proved_drawn_and_explained(room: Path) -> None:
    follow_steps(room, STEPS)
    checked = run(room, "check", "twice.toml", "--sample", "20")
    assert checked.stdout.startswith("twice: sound"), checked.stderr
    assert show(room) == solve(room) == ""
    assert " turns twice as fast as " in describe(room)
    assert prove(room) == "[4.0, 4.0]\n"
    listed = run(room, "words", "joints").stdout
    assert "BODY turns twice with BODY\n    One turns twice as fast." in listed


@pytest.mark.sampled(3, by="missing")
@pytest.mark.parametrize("missing", STEPS, ids=lambda step: step.title)
def test_a_joint_without_a_step(room: Path, missing: Step) -> None:
    assert missing.refused in missing.ask(follow_steps(room, STEPS, missing))
