"""The table of joints and drivers is the only place in the figure that knows one from another."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import get_args

import pytest
from msgspec import structs

import kinegrade.figure
from kinegrade.figure.joints.drivers import (
    MovingPoint,
    TurningBody,
    find_given_motion,
    reduce_to_sense,
)
from kinegrade.figure.joints.symbol import Symbol
from kinegrade.figure.joints.table import find_symbols
from kinegrade.mechanics.drivers import Circulation, Component, Driver, Rotation
from kinegrade.mechanics.joints import (
    GROUND,
    Arc,
    Belt,
    Circle,
    Contact,
    Joint,
    Line,
    Mesh,
    Parallel,
    Pin,
    Roll,
    Sleeve,
    Slide,
)
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector

ROOM = Path(kinegrade.figure.__file__).parent
KINDS = {kind.__name__ for kind in (*get_args(Joint), *get_args(Driver))}
ORIGIN, RIGHT, UP = Vector(0.0, 0.0), Vector(1.0, 0.0), Vector(0.0, 1.0)
POINTS = {"O": ORIGIN, "A": RIGHT * 3.0, "B": UP * 4.0}
LEVEL = Line(ORIGIN, RIGHT * 2.0)
BELOW = Line(Vector(0.0, -1.0), RIGHT)
SMALL, LARGE = Circle("O", 1.0), Circle("A", 2.0)


def names_from_mechanics(source: str) -> Iterator[str]:
    """The names that a module takes from `mechanics`."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith(
            "kinegrade.mechanics"
        ):
            yield from (each.name for each in node.names)


@pytest.mark.parametrize(
    "file", [file for file in ROOM.rglob("*.py") if file.parent.name != "joints"], ids=str
)
def test_a_figure_asks_the_table_and_no_joint(file: Path) -> None:
    assert KINDS.isdisjoint(names_from_mechanics(file.read_text(encoding="utf-8")))


def layers(symbol: Symbol) -> set[str]:
    """The layers to which a joint adds."""
    return {name for name, value in structs.asdict(symbol).items() if value}


PIN = {"point", "pinned"}
ADDED: tuple[tuple[Joint, set[str]], ...] = (
    (Pin("O", ("I", "II")), PIN | {"turning"}),
    (Pin("O", ("I", GROUND)), PIN | {"turning", "fixed"}),
    (Slide("O", "I", LEVEL, GROUND), PIN | {"guide"}),
    (Slide("O", "I", LEVEL, "II"), PIN | {"features", "block"}),
    (Slide("O", GROUND, LEVEL, "II"), PIN | {"features", "sleeve", "fixed"}),
    (Sleeve("I", LEVEL, GROUND), {"guide", "translating"}),
    (Sleeve("I", LEVEL, "II"), {"features", "sleeve", "carrier"}),
    (Arc("B", "I", LARGE, "II"), {"point", "rims", "edge"}),
    (Contact("I", SMALL, "II", BELOW), {"rims", "features"}),
    (Contact("I", SMALL, "II", LARGE), {"rims"}),
    (Roll("I", SMALL, GROUND, BELOW), {"rims", "foot"}),
    (Mesh("I", SMALL, "II", LARGE, GROUND), {"rims"}),
    (Belt("I", SMALL, "II", Circle("A", 1.5), GROUND, crossed=True), {"rims", "strands"}),
    (Parallel("I", GROUND), {"translating"}),
    (Parallel("I", "II"), set()),
)


@pytest.mark.parametrize(("joint", "expected"), ADDED, ids=lambda part: type(part).__name__)
def test_a_joint_adds_to_its_layers(joint: Joint, expected: set[str]) -> None:
    bodies = (Body("I", ("O", "A")), Body("II", ("O", "B")))
    (symbol,) = find_symbols(Mechanism(POINTS, bodies, (joint,), ()), {})
    assert layers(symbol) == expected


def test_every_joint_is_looked_at() -> None:
    assert {type(joint) for joint, _ in ADDED} == set(get_args(Joint))


@dataclass(frozen=True)
class Shown:
    """A driver with what the figure shows of its velocity and of its acceleration."""

    driver: Driver
    velocity: TurningBody | MovingPoint
    acceleration: TurningBody | MovingPoint


SHOWN = (
    Shown(
        Rotation("I", -2.0, 3.0),
        TurningBody("I", "ground", "cw"),
        TurningBody("I", "ground", "ccw"),
    ),
    Shown(
        Rotation("I", 2.0, 0.0, "II"), TurningBody("I", "II", "ccw"), TurningBody("I", "II", None)
    ),
    Shown(Component("A", "I", UP * 2.0, -0.5, 0.0), MovingPoint("A", -UP), MovingPoint("A", None)),
    Shown(Circulation("A", "I", "O", 0.5, -0.3), MovingPoint("A", UP), MovingPoint("A", -UP)),
    Shown(Circulation("A", "I", "O", 0.0, 0.3), MovingPoint("A", None), MovingPoint("A", UP)),
)


@pytest.mark.parametrize("shown", SHOWN, ids=lambda shown: type(shown.driver).__name__)
def test_the_arrows_of_a_driver_show_its_sense_and_no_amount(shown: Shown) -> None:
    reduced = reduce_to_sense(shown.driver)
    for driver in (shown.driver, reduced):
        assert find_given_motion(POINTS, driver, "velocity") == shown.velocity
        assert find_given_motion(POINTS, driver, "acceleration") == shown.acceleration
    assert {reduced.velocity, reduced.acceleration} <= {-1.0, 0.0, 1.0}


def test_every_driver_is_looked_at() -> None:
    assert {type(shown.driver) for shown in SHOWN} == set(get_args(Driver))
