"""A joint or an input that was added in one place alone is refused by name, and never taken for
another one.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import pytest
from click.testing import CliRunner

from kinegrade.cli import main
from kinegrade.figure.joints.drivers import find_given_motion, reduce_to_sense
from kinegrade.figure.joints.table import find_symbols
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.similar_mechanisms import normalise_subject
from kinegrade.mechanics.configuration import require_assembled
from kinegrade.mechanics.frames import build_frames, find_guided, name_element
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.floats import Floats
from kinegrade.problem.template import sentences
from kinegrade.problem.template.hints import FigureHints
from tests.problem.crank import crank_text

BELT = (
    ('joints = ["pin O: ground OA"]', 'joints = ["pin O: ground OA", "OA drives II by a belt"]'),
)
SPINS = (('motion = "OA turns"', 'motion = "OA spins"'),)


@dataclass(frozen=True)
class Belt:
    """A joint that the package does not know."""

    body: str
    of: str


@dataclass(frozen=True)
class Spin:
    """A driver that the package does not know."""

    body: str
    velocity: float
    acceleration: float
    of: str = GROUND


def mechanism(*joints: object, drivers: tuple[object, ...] = ()) -> Mechanism:
    bodies = (Body("I", ("O", "A")), Body("II", ("O", "A")))
    points = {"O": Vector(0.0, 0.0), "A": Vector(1.0, 0.0)}
    return Mechanism(points, bodies, joints, drivers)  # type: ignore[arg-type]


def solved(text: str, folder: Path) -> str:
    """What `solve` says of a template, with whatever ends it."""
    file = folder / "half.toml"
    file.write_text(text, encoding="utf-8")
    result = CliRunner().invoke(main, ["solve", str(file)])
    assert result.exit_code != 0
    assert "v_x =" not in result.output
    return f"{result.output}{result.exception!r}"


def test_no_answers_come_of_a_sentence_that_only_the_list_of_joints_knows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pattern = re.compile(r"(?P<body>\w+) drives (?P<of>\w+) by a belt")
    monkeypatch.setitem(sentences.JOINTS, "belt", pattern)  # type: ignore[misc]
    text = crank_text(*BELT, ('OA = "O A"', 'OA = "O A"\nII = "O A"'))
    assert "'belt'" in solved(text, tmp_path)


def test_no_answers_come_of_a_sentence_that_only_the_list_of_inputs_knows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(
        sentences.DRIVERS,
        "spin",
        re.compile(r"(?P<body>\w+) spins"),
    )  # type: ignore[misc]
    assert "'spin'" in solved(crank_text(*SPINS), tmp_path)


@pytest.mark.parametrize(
    "uses",
    [
        lambda belt: find_guided(mechanism(belt), belt),
        lambda belt: build_frames(mechanism(belt), Floats()),
        lambda belt: require_assembled(mechanism(belt), Floats()),
        name_element,
        lambda belt: scale_to_paper(mechanism(belt), 1000.0),
        lambda belt: normalise_subject(mechanism(belt), FigureHints()),
        lambda belt: find_symbols(mechanism(belt), {}),
    ],
)
def test_a_joint_that_is_only_a_value_is_neither_solved_nor_drawn(uses: object) -> None:
    with pytest.raises(AssertionError, match="Belt"):
        uses(Belt("I", "II"))  # type: ignore[operator]


@pytest.mark.parametrize(
    "uses",
    [
        lambda spin: build_frames(mechanism(drivers=(spin,)), Floats()),
        lambda spin: require_assembled(mechanism(drivers=(spin,)), Floats()),
        lambda spin: find_given_motion({}, spin),
        reduce_to_sense,
        name_element,
    ],
)
def test_a_driver_that_is_only_a_value_moves_nothing(uses: object) -> None:
    with pytest.raises(AssertionError, match="Spin"):
        uses(Spin("I", 1.0, 0.0))  # type: ignore[operator]
