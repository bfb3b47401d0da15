"""Mechanisms whose cycles are known in closed form, in doubles."""

from __future__ import annotations

import math

from kinegrade.mechanics.drivers import Component, Rotation
from kinegrade.mechanics.joints import GROUND, Line, Pin, Slide
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.motion import Motion, solve_motion
from kinegrade.mechanics.vector import Vector
from kinegrade.motion.path import MotionPath, find_path
from kinegrade.numbers.doubles import Doubles


def follow(motion: Motion) -> MotionPath:
    """The path of a motion that has one."""
    path = find_path(motion)
    assert isinstance(path, MotionPath), path
    return path


def four_bar(crank: float, coupler: float, rocker: float, frame: float, at: float) -> Motion:
    """OA drives ABC at 2 rad/s; the rocker turns about C at (frame, 0), B above AC."""
    a = Vector(crank * math.cos(at), crank * math.sin(at))
    diagonal = math.hypot(frame - a.x, a.y)
    along = math.atan2(-a.y, frame - a.x)
    opening = math.acos((coupler**2 + diagonal**2 - rocker**2) / (2 * coupler * diagonal))
    b = a + Vector(math.cos(along + opening), math.sin(along + opening)) * coupler
    mechanism = Mechanism(
        {"O": Vector(0.0, 0.0), "A": a, "B": b, "C": Vector(frame, 0.0)},
        (Body("OA", ("O", "A")), Body("AB", ("A", "B")), Body("BC", ("B", "C"))),
        (
            Pin("O", (GROUND, "OA")),
            Pin("A", ("OA", "AB")),
            Pin("B", ("AB", "BC")),
            Pin("C", (GROUND, "BC")),
        ),
        (Rotation("OA", 2.0, 0.0),),
    )
    return solve_motion(mechanism, Doubles())


def slider_crank(crank: float, rod: float, offset: float, at: float) -> Motion:
    """OA drives AB at 2 rad/s; B slides on y = offset, on the right."""
    a = Vector(crank * math.cos(at), crank * math.sin(at))
    b = Vector(a.x + math.sqrt(rod**2 - (a.y - offset) ** 2), offset)
    mechanism = Mechanism(
        {"O": Vector(0.0, 0.0), "A": a, "B": b},
        (Body("OA", ("O", "A")), Body("AB", ("A", "B"))),
        (
            Pin("O", (GROUND, "OA")),
            Pin("A", ("OA", "AB")),
            Slide("B", "AB", Line(b, Vector(1.0, 0.0)), GROUND),
        ),
        (Rotation("OA", 2.0, 0.0),),
    )
    return solve_motion(mechanism, Doubles())


def block_on_turning_bar(speed: float, omega: float) -> Motion:
    """P starts at the pivot O of a bar and moves outwards along it while the bar turns."""
    mechanism = Mechanism(
        {"O": Vector(0.0, 0.0), "E": Vector(1.0, 0.0), "P": Vector(0.0, 0.0)},
        (Body("bar", ("O", "E")), Body("block", ("P",), particle=True)),
        (
            Pin("O", (GROUND, "bar")),
            Slide("P", "block", Line(Vector(0.0, 0.0), Vector(1.0, 0.0)), "bar"),
        ),
        (
            Rotation("bar", omega, 0.0),
            Component("P", "block", Vector(1.0, 0.0), speed, 0.0, "bar"),
        ),
    )
    return solve_motion(mechanism, Doubles())


def bar_held_thrice(centre: Vector) -> Motion:
    """A bar with its ends on two axes and a crank from its middle to `centre`: redundant if that is
    (0, 0), and a contradiction beyond the instant elsewhere.
    """
    mechanism = Mechanism(
        {
            "A": Vector(1.0, 0.0),
            "B": Vector(0.0, 1.0),
            "D": Vector(0.5, 0.5),
            "C": centre,
        },
        (Body("AB", ("A", "B", "D")), Body("CD", ("C", "D"))),
        (
            Slide("A", "AB", Line(Vector(0.0, 0.0), Vector(1.0, 0.0)), GROUND),
            Slide("B", "AB", Line(Vector(0.0, 0.0), Vector(0.0, 1.0)), GROUND),
            Pin("D", ("AB", "CD")),
            Pin("C", (GROUND, "CD")),
        ),
        (Component("A", "AB", Vector(1.0, 0.0), 1.0, 0.0),),
    )
    return solve_motion(mechanism, Doubles())
