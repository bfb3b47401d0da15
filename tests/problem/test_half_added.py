"""A joint or an input that was added in one place alone is refused by name, and never taken for
another one.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from kinegrade.cli import main
from kinegrade.figure.joints.drivers import find_given_motion, reduce_to_sense
from kinegrade.figure.joints.table import find_symbols
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.similar_mechanisms import normalise_subject
from kinegrade.mechanics.drivers import Rotation
from kinegrade.mechanics.drivers.driving_constraint import DrivingConstraint
from kinegrade.mechanics.element import Element
from kinegrade.mechanics.joints import Joint, Parallel
from kinegrade.mechanics.joints.constraint import Constraint
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template import sentences
from kinegrade.problem.template.hints import FigureHints
from tests.problem.crank import crank_text

BELT = (
    ('joints = ["pin O: ground OA"]', 'joints = ["pin O: ground OA", "OA drives II by a belt"]'),
)
SPINS = (('motion = "OA turns"', 'motion = "OA spins"'),)


def borrow(name: str, whole: type[Element], base: type[Element], lacking: str = "") -> Any:
    """A new class of joints or drivers that borrows all that it needs from another one, but for one
    method or attribute.
    """
    needed = base.__abstractmethods__ | set(base.__annotations__)
    return type(name, (base,), {part: getattr(whole, part) for part in needed - {lacking}})


BELT_JOINT = borrow("Belt", Parallel, Constraint)
SPIN_DRIVER = borrow("Spin", Rotation, DrivingConstraint)


def mechanism(*joints: Joint) -> Mechanism:
    bodies = (Body("I", ("O", "A")), Body("II", ("O", "A")))
    points = {"O": Vector(0.0, 0.0), "A": Vector(1.0, 0.0)}
    return Mechanism(points, bodies, joints, ())


def solved(text: str, folder: Path) -> str:
    """What `solve` says of a template, with whatever ends it."""
    file = folder / "half.toml"
    file.write_text(text, encoding="utf-8")
    result = CliRunner().invoke(main, ["solve", str(file)])
    assert result.exit_code != 0
    assert "v_x =" not in result.output
    return f"{result.output}{result.exception!r}"


def state(half: Any, pattern: str) -> Any:
    """The class with a sentence of which it is made."""
    half.PATTERN, half.make = pattern, classmethod(lambda cls, parts: cls())
    return half


def test_no_answers_come_of_the_sentence_of_a_half_done_joint(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    half = state(borrow("Belt", Parallel, Constraint, "describe"), r"\w+ drives \w+ by a belt")
    monkeypatch.setattr(sentences, "JOINTS", (*sentences.JOINTS, half))
    text = crank_text(*BELT, ('OA = "O A"', 'OA = "O A"\nII = "O A"'))
    assert "abstract class Belt" in solved(text, tmp_path)


def test_no_answers_come_of_the_sentence_of_a_half_done_input(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    half = state(borrow("Spin", Rotation, DrivingConstraint, "state"), r"(?P<body>\w+) spins")
    monkeypatch.setattr(sentences, "DRIVERS", (*sentences.DRIVERS, half))
    assert "abstract class Spin" in solved(crank_text(*SPINS), tmp_path)


@pytest.mark.parametrize("method", sorted(Constraint.__abstractmethods__))
def test_a_joint_that_lacks_a_method_cannot_be_made(method: str) -> None:
    with pytest.raises(TypeError, match=f"abstract .* {method}"):
        borrow("Belt", Parallel, Constraint, method)()


@pytest.mark.parametrize("attribute", ["EXAMPLES", "FORM", "PATTERN", "SLIPS"])
def test_a_joint_that_lacks_an_attribute_is_refused_as_a_class(attribute: str) -> None:
    with pytest.raises(TypeError, match=f"Belt lacks {attribute}$"):
        borrow("Belt", Parallel, Constraint, attribute)


@pytest.mark.parametrize("attribute", ["EXAMPLES", "FORM", "PATTERN", "TURNS"])
def test_a_driver_that_lacks_an_attribute_is_refused_as_a_class(attribute: str) -> None:
    with pytest.raises(TypeError, match=f"Spin lacks {attribute}$"):
        borrow("Spin", Rotation, DrivingConstraint, attribute)


def test_what_joints_have_in_common_may_leave_the_attributes_to_them() -> None:
    pair = type("Pair", (Constraint,), {})
    assert not hasattr(pair, "PATTERN")


@pytest.mark.parametrize("method", sorted(DrivingConstraint.__abstractmethods__))
def test_a_driver_that_lacks_a_method_cannot_be_made(method: str) -> None:
    with pytest.raises(TypeError, match=f"abstract .* {method}"):
        borrow("Spin", Rotation, DrivingConstraint, method)()


@pytest.mark.parametrize(
    "uses",
    [
        lambda belt: scale_to_paper(mechanism(belt), 1000.0),
        lambda belt: normalise_subject(mechanism(belt), FigureHints()),
        lambda belt: find_symbols(mechanism(belt), {}),
    ],
)
def test_a_joint_without_a_symbol_is_not_drawn(uses: object) -> None:
    with pytest.raises(AssertionError, match="Belt"):
        uses(BELT_JOINT())  # type: ignore[operator]


@pytest.mark.parametrize(
    "uses",
    [
        lambda spin: find_given_motion({}, spin, "velocity"),
        reduce_to_sense,
    ],
)
def test_a_driver_without_an_arrow_is_not_drawn(uses: object) -> None:
    with pytest.raises(AssertionError, match="Spin"):
        uses(SPIN_DRIVER())  # type: ignore[operator]
