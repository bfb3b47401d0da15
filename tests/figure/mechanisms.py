"""The first eight mechanisms with float values, as a template would assemble them, and their
hints.
"""

from __future__ import annotations

from collections.abc import Callable
from math import cos, radians, sin, sqrt, tan
from typing import Any

from kinegrade.files.fields.document import parsed_table
from kinegrade.mechanics.drivers import Component, Rotation
from kinegrade.mechanics.joints import (
    GROUND,
    Circle,
    Contact,
    Line,
    Parallel,
    Pin,
    Roll,
    Sleeve,
    Slide,
)
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import FigureHints
from kinegrade.problem.template.sections.figure import Names, read_figure
from kinegrade.problem.template.sections.opening import TEMPLATE

RIGHT, UP = Vector(1.0, 0.0), Vector(0.0, 1.0)
Case = tuple[Mechanism, FigureHints]
Postures = dict[str, tuple[Callable[..., Case], list[tuple[float, ...]]]]


def hinted(mechanism: Mechanism, **table: Any) -> Case:
    bodies = {body.name for body in mechanism.bodies}
    file = parsed_table("case.toml", {"figure": table}, TEMPLATE)
    hints = read_figure(file, Names(set(mechanism.points), bodies))
    file.faults.require_none()
    return mechanism, hints


def each_once(*builds: Callable[..., Case]) -> Postures:
    """Each mechanism in its one posture."""
    return {build.__name__: (build, [()]) for build in builds}


def polar(radius: float, degrees: float) -> Vector:
    return Vector(radius * cos(radians(degrees)), radius * sin(radians(degrees)))


def slider_crank(r: float, k: float, phi: float) -> Case:
    o, a = Vector(0.0, 0.0), polar(r, phi)
    b = Vector(a.x + sqrt((k * r) ** 2 - a.y**2), 0.0)
    joints = (
        Pin("O", ("OA", GROUND)),
        Pin("A", ("OA", "AB")),
        Slide("B", "AB", Line(o, RIGHT), GROUND),
    )
    bodies = (Body("OA", ("O", "A")), Body("AB", ("A", "B")))
    mechanism = Mechanism({"O": o, "A": a, "B": b}, bodies, joints, (Rotation("OA", -3.0, 0.0),))
    return hinted(
        mechanism,
        lengths=[
            {"symbol": "r", "from": "O", "to": "A"},
            {"symbol": "k r", "from": "A", "to": "B"},
        ],
        angles=[{"symbol": r"\varphi", "at": "O", "from": "right", "to": "A"}],
        arrows=[{"symbol": r"\omega", "turns": "OA"}],
    )


def planetary_velocities(r1: float, r2: float, phi: float) -> Case:
    e = polar(1.0, phi)
    points = {"O": Vector(0.0, 0.0), "A": e * (r1 + r2), "D": e * r1, "C": e * (r1 + 2 * r2)}
    points["B"] = points["A"] + e.turned() * r2
    joints = (
        Pin("O", ("OA", GROUND)),
        Pin("A", ("OA", "II")),
        Roll("II", Circle("A", r2), GROUND, Circle("O", r1)),
    )
    bodies = (Body("OA", ("O", "A")), Body("II", ("A", "B", "C", "D")))
    return hinted(
        Mechanism(points, bodies, joints, (Rotation("OA", 2.0, 1.0),)),
        radii=[{"symbol": "r_1", "centre": "O"}, {"symbol": "r_2", "centre": "A"}],
        angles=[{"symbol": r"\varphi", "at": "O", "from": "right", "to": "A", "sense": "ccw"}],
        arrows=[{"symbol": r"\omega_0", "turns": "OA", "sense": "ccw"}],
        shapes={"II": "gear"},
        labels={"II": r"\mathrm{II}", "ground": r"\mathrm{I}"},
    )


def planetary_accelerations(size: float, r: float, phi: float) -> Case:
    e = polar(1.0, phi)
    points = {"O1": Vector(0.0, 0.0), "O": e * size, "A": e * (size + r), "C": e * (size - r)}
    points["B"] = points["O"] + e.turned() * r
    joints = (
        Pin("O1", ("arm", GROUND)),
        Pin("O", ("arm", "I")),
        Roll("I", Circle("O", r), GROUND, Circle("O1", size - r)),
    )
    bodies = (Body("arm", ("O1", "O")), Body("I", ("O", "A", "B", "C")))
    return hinted(
        Mechanism(points, bodies, joints, (Rotation("arm", 2.0, 0.0),)),
        lengths=[{"symbol": "l", "from": "O1", "to": "O"}],
        radii=[{"symbol": "r", "centre": "O"}],
        angles=[{"symbol": r"\varphi", "at": "O1", "from": "right", "to": "O", "sense": "ccw"}],
        arrows=[{"symbol": r"\omega_1", "turns": "arm", "sense": "ccw"}],
        shapes={"I": "gear"},
        labels={"I": r"\mathrm{I}", "ground": r"\mathrm{II}"},
    )


def follower_joints(
    centre: str, radius: float, contact: Vector, of_curvature: bool = False
) -> tuple[Any, ...]:
    return (
        Pin("O", ("cam", GROUND)),
        Parallel("BC", GROUND),
        Slide("A", "BC", Line(contact, UP), GROUND),
        Contact(
            "cam", Circle(centre, radius), "BC", Line(contact, RIGHT), of_curvature=of_curvature
        ),
    )


def follower_curvature(r: float, theta: float, rho: float) -> Case:
    a = polar(r, 90 - theta)
    points = {"O": Vector(0.0, 0.0), "A": a, "K": a - UP * rho}
    bodies = (Body("cam", ("O", "K")), Body("BC", ("A",)))
    joints = follower_joints("K", rho, a, of_curvature=True)
    return hinted(
        Mechanism(points, bodies, joints, (Rotation("cam", 2.0, 0.0),)),
        lengths=[
            {"symbol": "r", "from": "O", "to": "A"},
            {"symbol": r"\rho", "from": "K", "to": "A"},
        ],
        angles=[{"symbol": r"\theta", "at": "O", "from": "up", "to": "A"}],
        arrows=[{"symbol": r"\omega", "turns": "cam", "sense": "ccw"}],
    )


def follower_circle(big: float, e: float, theta_1: float) -> Case:
    c = polar(e, 90 - theta_1)
    a = c + UP * big
    points = {"O": Vector(0.0, 0.0), "C": c, "A": a}
    bodies = (Body("cam", ("O", "C")), Body("BC", ("A",)))
    return hinted(
        Mechanism(points, bodies, follower_joints("C", big, a), (Rotation("cam", 2.0, 0.0),)),
        lengths=[{"symbol": "e", "from": "O", "to": "C"}],
        radii=[{"symbol": "R", "centre": "C"}],
        angles=[{"symbol": r"\theta_1", "at": "O", "from": "up", "to": "C"}],
        arrows=[{"symbol": r"\omega", "turns": "cam", "sense": "ccw"}],
    )


def swivelling_sleeve(size: float, phi: float) -> Case:
    o, a = Vector(0.0, 0.0), Vector(size / tan(radians(phi)), size)
    joints = (
        Parallel("AC", GROUND),
        Slide("A", "AC", Line(a, RIGHT), GROUND),
        Pin("A", ("AC", "AB")),
        Pin("O", ("sleeve", GROUND)),
        Sleeve("AB", Line(o, a - o), "sleeve"),
    )
    bodies = (Body("AC", ("A",)), Body("AB", ("A", "O")), Body("sleeve", ("O",)))
    return hinted(
        Mechanism({"O": o, "A": a}, bodies, joints, (Component("A", "AC", -RIGHT, 0.5, 0.0),)),
        lengths=[{"symbol": "l", "from": "O", "to": "A", "along": "vertical"}],
        angles=[{"symbol": r"\varphi", "at": "O", "from": "right", "to": "A"}],
        arrows=[{"symbol": "v", "moves": "A"}],
    )


def slotted_rocker(size: float, theta: float, psi: float) -> Case:
    height = size * sin(radians(theta))
    o, a = Vector(0.0, 0.0), Vector(height / tan(radians(psi)), height)
    b = Vector(a.x + size * cos(radians(theta)), 0.0)
    joints = (
        Pin("O", ("OC", GROUND)),
        Slide("A", "AB", Line(o, a - o), "OC"),
        Slide("B", "AB", Line(o, RIGHT), GROUND),
    )
    bodies = (Body("OC", ("O",)), Body("AB", ("A", "B")))
    drivers = (Rotation("OC", -2.0, 0.0), Component("B", "AB", RIGHT, 1.0, 0.0))
    return hinted(
        Mechanism({"O": o, "A": a, "B": b}, bodies, joints, drivers),
        lengths=[{"symbol": "l", "from": "A", "to": "B"}],
        angles=[
            {"symbol": r"\theta", "at": "B", "from": "left", "to": "A"},
            {"symbol": r"\psi", "at": "O", "from": "right", "to": "A"},
        ],
        arrows=[{"symbol": r"\omega", "turns": "OC"}, {"symbol": "v_B", "moves": "B"}],
    )


def slotted_bar(size: float, theta: float) -> Case:
    a, b = Vector(0.0, 0.0), Vector(-size * sin(radians(theta)), -size * cos(radians(theta)))
    joints = (
        Parallel("AC", GROUND),
        Slide("A", "AC", Line(a, UP), GROUND),
        Parallel("BD", GROUND),
        Slide("B", "BD", Line(b, RIGHT), GROUND),
        Pin("A", ("AC", "AE")),
        Slide("B", "BD", Line(a, b - a), "AE"),
    )
    bodies = (Body("AC", ("A",)), Body("BD", ("B",)), Body("AE", ("A",)))
    drivers = (Component("A", "AC", UP, 1.0, 0.0), Component("B", "BD", RIGHT, 1.0, 0.0))
    return hinted(
        Mechanism({"A": a, "B": b}, bodies, joints, drivers),
        lengths=[{"symbol": "l_{AB}", "from": "A", "to": "B"}],
        angles=[{"symbol": r"\theta", "at": "A", "from": "down", "to": "B"}],
        arrows=[{"symbol": "v_A", "moves": "A"}, {"symbol": "v_B", "moves": "B"}],
    )


EIGHT: Postures = {
    "slider-crank": (slider_crank, [(0.2, 1.75, 60), (0.5, 1.5, 150), (0.1, 4, 25), (0.3, 2, 90)]),
    "planetary-velocities": (
        planetary_velocities,
        [(0.3, 0.2, 30), (0.5, 0.05, 200), (0.1, 0.3, 100), (0.4, 0.15, 330)],
    ),
    "planetary-accelerations": (
        planetary_accelerations,
        [(0.6, 0.2, 40), (0.3, 0.25, 150), (0.9, 0.1, 270), (0.5, 0.15, 0)],
    ),
    "follower-curvature": (
        follower_curvature,
        [(0.3, 30, 0.25), (0.1, -40, 0.6), (0.5, 20, 0.05), (0.4, -15, 0.45), (0.3, 0, 0.2)],
    ),
    "follower-circle": (
        follower_circle,
        [(0.3, 0.09, 40), (0.1, 0.08, -120), (0.4, 0.03, 180), (0.2, 0.09, 90)],
    ),
    "swivelling-sleeve": (
        swivelling_sleeve,
        [(0.5, 60), (1.5, 25), (0.2, 155), (1.0, 90), (0.8, 110)],
    ),
    "slotted-rocker": (
        slotted_rocker,
        [(0.6, 30, 90), (1.0, 20, 105), (0.3, 60, 75), (0.5, 45, 100)],
    ),
    "slotted-bar": (slotted_bar, [(0.06, 30), (0.12, 15), (0.04, 70), (0.08, 50)]),
}
