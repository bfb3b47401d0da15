"""Mechanisms with wheels, gears, racks and belts, one posture each."""

from __future__ import annotations

from math import cos, radians, sin

from kinegrade.mechanics.drivers import Circulation, Component, Rotation
from kinegrade.mechanics.joints import (
    GROUND,
    Belt,
    Circle,
    Contact,
    Line,
    Mesh,
    Parallel,
    Pin,
    Roll,
    Slide,
)
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from tests.figure.mechanisms import RIGHT, UP, Case, each_once, hinted, polar

ORIGIN = Vector(0.0, 0.0)


def towed_wheel() -> Case:
    a = polar(0.2, 60)
    b = a + Vector(0.5, 0.0)
    c, d = b - polar(0.35, 60), b + polar(0.25, 60)
    e = Vector(b.x + 0.25 / cos(radians(60)), b.y)
    points = {"O": ORIGIN, "A": a, "B": b, "C": c, "D": d, "E": e, "K": e - UP * 0.15}
    joints = (
        Pin("O", ("OA", GROUND)),
        Pin("A", ("OA", "AB")),
        Pin("B", ("AB", "CD")),
        Pin("C", ("CD", GROUND)),
        Pin("D", ("CD", "DE")),
        Pin("E", ("DE", "W")),
        Roll("W", Circle("E", 0.15), GROUND, Line(points["K"], RIGHT)),
    )
    names = {
        "OA": ("O", "A"),
        "AB": ("A", "B"),
        "CD": ("C", "B", "D"),
        "DE": ("D", "E"),
        "W": ("E", "K"),
    }
    bodies = tuple(Body(name, own) for name, own in names.items())
    return hinted(
        Mechanism(points, bodies, joints, (Rotation("OA", 2.0, 0.0),)),
        radii=[{"symbol": "R", "centre": "E"}],
    )


def wheel_in_track() -> Case:
    o, r = polar(0.35, -60), 0.15
    points = {"O1": ORIGIN, "O": o, "D": polar(0.5, -60), "B": o + polar(r, 100)}
    joints = (Roll("wheel", Circle("O", r), GROUND, Circle("O1", 0.5), inside=True),)
    mechanism = Mechanism(
        points, (Body("wheel", ("O", "D", "B")),), joints, (Rotation("wheel", 2.0, 0.0),)
    )
    return hinted(
        mechanism,
        radii=[{"symbol": "R", "centre": "O1"}, {"symbol": "r", "centre": "O"}],
        angles=[{"symbol": r"\theta", "at": "O1", "from": "down", "to": "O"}],
        arrows=[{"symbol": r"\omega", "turns": "wheel"}],
    )


def planet_in_ring() -> Case:
    points = {"O1": ORIGIN, "O2": polar(0.3, 40), "P": polar(0.45, 40)}
    joints = (
        Pin("O1", ("arm", GROUND)),
        Pin("O2", ("arm", "planet")),
        Mesh("planet", Circle("O2", 0.15), GROUND, Circle("O1", 0.45), "arm", inside=True),
    )
    bodies = (Body("arm", ("O1", "O2")), Body("planet", ("O2", "P")))
    return hinted(
        Mechanism(points, bodies, joints, (Rotation("arm", 2.0, 0.0),)),
        arrows=[{"symbol": r"\omega_3", "turns": "arm"}],
    )


def meshing_gears() -> Case:
    points = {"O": ORIGIN, "A": polar(0.4, 20)}
    joints = (
        Pin("O", ("arm", "sun", GROUND)),
        Pin("A", ("arm", "planet")),
        Mesh("planet", Circle("A", 0.15), "sun", Circle("O", 0.25), "arm"),
    )
    bodies = (Body("arm", ("O", "A")), Body("sun", ("O",)), Body("planet", ("A",)))
    drivers = (Rotation("arm", 2.0, 0.0), Rotation("sun", -1.0, 0.0))
    return hinted(
        Mechanism(points, bodies, joints, drivers), labels={"sun": "1", "planet": "2", "arm": "H"}
    )


def belt_on_arm(crossed: bool = False) -> Case:
    points = {"O": ORIGIN, "A": polar(0.6, 130)}
    joints = (
        Pin("O", ("arm", "I", GROUND)),
        Pin("A", ("arm", "II")),
        Belt("II", Circle("A", 0.1), "I", Circle("O", 0.25), "arm", crossed),
    )
    bodies = (Body("arm", ("O", "A")), Body("I", ("O",)), Body("II", ("A",)))
    drivers = (Rotation("arm", 2.0, 0.0), Rotation("I", -1.0, 0.0))
    return hinted(
        Mechanism(points, bodies, joints, drivers),
        labels={"I": "1", "II": "2"},
        radii=[{"symbol": "r_1", "centre": "O"}, {"symbol": "r_2", "centre": "A"}],
    )


def crossed_belt_on_arm() -> Case:
    return belt_on_arm(crossed=True)


def belt_about_fixed_pulley() -> Case:
    points = {"O": ORIGIN, "A": polar(0.5, -20)}
    joints = (
        Pin("O", ("arm", GROUND)),
        Pin("A", ("arm", "II")),
        Belt("II", Circle("A", 0.15), GROUND, Circle("O", 0.15), "arm"),
    )
    bodies = (Body("arm", ("O", "A")), Body("II", ("A",)))
    return hinted(Mechanism(points, bodies, joints, (Rotation("arm", 2.0, 0.0),)))


def bar_pushing_disc() -> Case:
    r, phi = 0.3, 60.0
    c = Vector(r / sin(radians(phi / 2)) * cos(radians(phi / 2)), r)
    b = c + polar(0.75, 20)
    points = {"O1": ORIGIN, "C": c, "B": b, "O": b - polar(0.6, 80)}
    joints = (
        Pin("O1", ("O1A", GROUND)),
        Roll("disc", Circle("C", r), GROUND, Line(ORIGIN, RIGHT)),
        Contact("disc", Circle("C", r), "O1A", Line(ORIGIN, polar(1.0, phi))),
        Pin("C", ("disc", "BC")),
        Pin("B", ("BC", "OB")),
        Pin("O", ("OB", GROUND)),
    )
    bodies = (
        Body("O1A", ("O1",)),
        Body("disc", ("C",)),
        Body("BC", ("C", "B")),
        Body("OB", ("O", "B")),
    )
    mechanism = Mechanism(points, bodies, joints, (Rotation("O1A", -2.0, 0.0),))
    return hinted(
        mechanism, angles=[{"symbol": r"\varphi", "at": "O1", "from": "right", "to": "C"}]
    )


def rack_and_gear() -> Case:
    r, phi, reach, drop = 0.25, 30.0, 0.7, 0.0
    c = polar(r, 90 - phi)
    a = c + polar(reach, -phi)
    points = {"O": ORIGIN, "C": c, "A": Vector(a.x, a.y - drop)}
    joints = (
        Slide("A", "rack", Line(points["A"], RIGHT), GROUND),
        Pin("O", ("gear", GROUND)),
        Roll("gear", Circle("O", r), "rack", Line(c, a - c)),
    )
    bodies = (Body("rack", ("A", "C")), Body("gear", ("O", "C")))
    mechanism = Mechanism(points, bodies, joints, (Component("A", "rack", RIGHT, 1.0, 0.0),))
    return hinted(mechanism, shapes={"gear": "gear"}, arrows=[{"symbol": "v_A", "moves": "A"}])


def rack_in_a_guide() -> Case:
    r = 0.2
    points = {"C": ORIGIN, "A": Vector(-2 * r, -r)}
    along = Line(points["A"], RIGHT)
    joints = (
        Parallel("rack", GROUND),
        Slide("A", "rack", along, GROUND),
        Pin("C", ("gear", GROUND)),
        Roll("gear", Circle("C", r), "rack", along),
    )
    bodies = (Body("rack", ("A",)), Body("gear", ("C",)))
    mechanism = Mechanism(points, bodies, joints, (Component("A", "rack", RIGHT, -1.0, 0.0),))
    return hinted(mechanism, shapes={"gear": "gear"}, arrows=[{"symbol": "u", "moves": "A"}])


def wheels_on_cylinder() -> Case:
    a, b = polar(0.4, 130), polar(0.45, 60)
    joints = (
        Pin("A", ("AB", "W1")),
        Pin("B", ("AB", "W2")),
        Roll("W1", Circle("A", 0.1), GROUND, Circle("O", 0.3)),
        Roll("W2", Circle("B", 0.15), GROUND, Circle("O", 0.3)),
    )
    bodies = (Body("AB", ("A", "B")), Body("W1", ("A",)), Body("W2", ("B",)))
    mechanism = Mechanism(
        {"O": ORIGIN, "A": a, "B": b}, bodies, joints, (Circulation("A", "W1", "O", -1.0, 0.0),)
    )
    return hinted(
        mechanism, arrows=[{"symbol": "v_A", "moves": "A"}], radii=[{"symbol": "R", "centre": "O"}]
    )


WITH_WHEELS = each_once(
    towed_wheel,
    wheel_in_track,
    planet_in_ring,
    meshing_gears,
    belt_on_arm,
    crossed_belt_on_arm,
    belt_about_fixed_pulley,
    bar_pushing_disc,
    rack_and_gear,
    rack_in_a_guide,
    wheels_on_cylinder,
)
