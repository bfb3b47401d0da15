"""Mechanisms with slides, sleeves, slots, bent bars and plates, one posture each."""

from __future__ import annotations

from math import radians, sin, sqrt

from kinegrade.mechanics.drivers import Component, Rotation
from kinegrade.mechanics.joints import (
    GROUND,
    Arc,
    Circle,
    Line,
    Parallel,
    Pin,
    Sleeve,
    Slide,
)
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from tests.figure.mechanisms import RIGHT, UP, Case, each_once, hinted, polar

ORIGIN = Vector(0.0, 0.0)


def ellipse_trammel() -> Case:
    d = polar(0.3, 40)
    points = {"O": ORIGIN, "A": Vector(2 * d.x, 0.0), "B": Vector(0.0, 2 * d.y), "D": d}
    joints = (
        Pin("O", ("OD", GROUND)),
        Pin("D", ("OD", "AB")),
        Slide("A", "AB", Line(ORIGIN, RIGHT), GROUND),
        Slide("B", "AB", Line(ORIGIN, UP), GROUND),
    )
    bodies = (Body("OD", ("O", "D")), Body("AB", ("A", "D", "B")))
    mechanism = Mechanism(points, bodies, joints, (Rotation("OD", 2.0, 0.0),))
    return hinted(mechanism, arrows=[{"symbol": r"\omega", "turns": "OD"}], axes="aside")


def sleeve_with_arm() -> Case:
    a, b = polar(0.25, 70), Vector(0.6, 0.0)
    along = (b - a) / sqrt((b - a).squared())
    points = {"O": ORIGIN, "A": a, "B": b, "D": b + along.turned() * 0.3}
    joints = (
        Pin("O", ("OA", GROUND)),
        Pin("A", ("OA", "AC")),
        Pin("B", ("BD", GROUND)),
        Sleeve("AC", Line(a, b - a), "BD"),
    )
    bodies = (Body("OA", ("O", "A")), Body("AC", ("A", "B")), Body("BD", ("B", "D")))
    return hinted(Mechanism(points, bodies, joints, (Rotation("OA", 2.0, 0.0),)))


def swivelling_rod() -> Case:
    points = {"D": ORIGIN, "B": Vector(0.3, 0.5)}
    joints = (
        Slide("B", "rod", Line(points["B"], RIGHT), GROUND),
        Slide("D", GROUND, Line(ORIGIN, points["B"]), "rod"),
    )
    mechanism = Mechanism(
        points, (Body("rod", ("B",)),), joints, (Component("B", "rod", RIGHT, -1.0, 0.0),)
    )
    return hinted(mechanism, arrows=[{"symbol": "v_B", "moves": "B"}])


def parallelogram_with_sleeve() -> Case:
    down = polar(0.3, -40)
    points = {"C": ORIGIN, "A": UP * 0.4, "D": down, "B": down + UP * 0.4, "F": down + UP * 0.25}
    points["E"] = points["F"] + polar(0.35, 30)
    joints = (
        Pin("A", ("AB", GROUND)),
        Pin("C", ("CD", GROUND)),
        Pin("E", ("EF", GROUND)),
        Pin("B", ("AB", "BD")),
        Pin("D", ("CD", "BD")),
        Slide("F", "EF", Line(points["F"], UP), "BD"),
    )
    names = ("AB", "CD", "BD", "EF")
    bodies = tuple(Body(name, (name[0], name[1])) for name in names)
    return hinted(
        Mechanism(points, bodies, joints, (Rotation("EF", 2.0, 0.0),)), shapes={"BD": "bar"}
    )


def slotted_rings() -> Case:
    r, d = 0.3, 0.36
    m = Vector(d / 2, sqrt(r**2 - (d / 2 - r) ** 2))
    points = {
        "A": ORIGIN,
        "C": Vector(d, 0.0),
        "O2": Vector(r, 0.0),
        "O1": Vector(d - r, 0.0),
        "M": m,
    }
    joints = (
        Pin("C", ("ring1", GROUND)),
        Pin("A", ("ring2", GROUND)),
        Arc("M", "M", Circle("O1", r), "ring1"),
        Arc("M", "M", Circle("O2", r), "ring2"),
    )
    bodies = (
        Body("ring1", ("C", "O1")),
        Body("ring2", ("A", "O2")),
        Body("M", ("M",), particle=True),
    )
    return hinted(Mechanism(points, bodies, joints, ()))


def pin_in_two_slots() -> Case:
    m = Vector(0.2, 0.3)
    joints = (
        Pin("O", ("disc", "rod", GROUND)),
        Slide("M", "M", Line(m, UP), "disc"),
        Slide("M", "M", Line(ORIGIN, m), "rod"),
    )
    bodies = (Body("disc", ("O",)), Body("rod", ("O",)), Body("M", ("M",), particle=True))
    return hinted(Mechanism({"O": ORIGIN, "M": m}, bodies, joints, ()))


def bent_coupler() -> Case:
    a = polar(0.3, 50)
    b = a + polar(0.4, 10)
    points = {"O": ORIGIN, "A": a, "B": b, "C": b + polar(0.25, -60), "O1": b - polar(0.35, 110)}
    joints = (
        Pin("O", ("OA", GROUND)),
        Pin("A", ("OA", "ABC")),
        Pin("B", ("ABC", "O1B")),
        Pin("O1", ("O1B", GROUND)),
    )
    bodies = (Body("OA", ("O", "A")), Body("ABC", ("A", "B", "C")), Body("O1B", ("O1", "B")))
    mechanism = Mechanism(points, bodies, joints, (Rotation("OA", 2.0, 0.0),))
    return hinted(mechanism, shapes={"ABC": "bent"}, arrows=[{"symbol": r"\omega", "turns": "OA"}])


def sliding_plate() -> Case:
    points = {"B": Vector(0.0, 0.35), "C": Vector(0.5, 0.0), "A": Vector(0.45, 0.5)}
    joints = (
        Slide("B", "plate", Line(ORIGIN, UP), GROUND),
        Slide("C", "plate", Line(ORIGIN, RIGHT), GROUND),
    )
    driver = Component("C", "plate", RIGHT, 1.0, 0.0)
    mechanism = Mechanism(points, (Body("plate", ("A", "B", "C")),), joints, (driver,))
    return hinted(mechanism, arrows=[{"symbol": "v_C", "moves": "C"}])


def pointed_follower() -> Case:
    e, r, h = 0.12, 0.3, 0.1
    c = polar(e, 50)
    points = {"O": ORIGIN, "C": c, "A": Vector(h, c.y + sqrt(r**2 - (h - c.x) ** 2))}
    joints = (
        Pin("O", ("cam", GROUND)),
        Parallel("AB", GROUND),
        Slide("A", "AB", Line(points["A"], UP), GROUND),
        Arc("A", "AB", Circle("C", r), "cam"),
    )
    bodies = (Body("cam", ("O", "C")), Body("AB", ("A",)))
    mechanism = Mechanism(points, bodies, joints, (Rotation("cam", 2.0, 0.0),))
    return hinted(
        mechanism,
        radii=[{"symbol": "r", "centre": "C"}],
        lengths=[{"symbol": "e", "from": "O", "to": "C"}],
    )


def plate_on_fixed_corners() -> Case:
    half = 0.25
    corners = {"D": (-half, -half), "E": (half, -half), "F": (half, half), "G": (-half, half)}
    turned = {
        name: Vector(x * 0.866 - y * 0.5, x * 0.5 + y * 0.866) for name, (x, y) in corners.items()
    }
    points = {"O": ORIGIN, **turned}
    points["A"] = (turned["D"] + turned["G"]) / 2
    points["B"] = (turned["D"] + turned["E"]) / 2
    joints = (
        Slide("A", GROUND, Line(points["A"], turned["G"] - turned["D"]), "plate"),
        Slide("B", GROUND, Line(points["B"], turned["E"] - turned["D"]), "plate"),
    )
    return hinted(
        Mechanism(
            points,
            (Body("plate", ("O", "D", "E", "F", "G")),),
            joints,
            (Rotation("plate", 1.0, 0.0),),
        )
    )


def corner_in_two_sleeves(d: float = 0.4) -> Case:
    e, phi = 0.25, 35.0
    a, b = UP * d, ORIGIN
    end = a + polar(e, phi)
    m = polar(e + d * sin(radians(phi)), phi)
    joints = (
        Pin("A", ("arm", GROUND)),
        Parallel("rod", "arm"),
        Slide("E", "arm", Line(m, polar(1.0, phi + 90)), "rod"),
        Slide("B", GROUND, Line(m, polar(1.0, phi)), "rod"),
    )
    bodies = (Body("arm", ("A", "E")), Body("rod", ("M",)))
    mechanism = Mechanism(
        {"B": b, "A": a, "E": end, "M": m}, bodies, joints, (Rotation("arm", 2.0, 0.0),)
    )
    return hinted(mechanism, shapes={"rod": "bar"})


GUIDED = each_once(
    ellipse_trammel,
    sleeve_with_arm,
    swivelling_rod,
    parallelogram_with_sleeve,
    slotted_rings,
    pin_in_two_slots,
    bent_coupler,
    sliding_plate,
    pointed_follower,
    plate_on_fixed_corners,
    corner_in_two_sleeves,
)
