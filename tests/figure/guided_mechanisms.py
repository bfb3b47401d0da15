"""Further mechanisms of the catalogue, one posture each: every joint kind and every way a body can
look.
"""

from __future__ import annotations

from collections.abc import Callable
from math import cos, radians, sin, sqrt

from kinegrade.mechanics.drivers import Circulation, Component, Rotation
from kinegrade.mechanics.joints import (
    GROUND,
    Arc,
    Belt,
    Circle,
    Contact,
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
from tests.figure.mechanisms import RIGHT, UP, Case, hinted, polar

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


MORE: dict[str, tuple[Callable[..., Case], list[tuple[float, ...]]]] = {
    build.__name__: (build, [()])
    for build in (
        ellipse_trammel,
        towed_wheel,
        wheel_in_track,
        planet_in_ring,
        meshing_gears,
        belt_on_arm,
        crossed_belt_on_arm,
        belt_about_fixed_pulley,
        bar_pushing_disc,
        sleeve_with_arm,
        swivelling_rod,
        parallelogram_with_sleeve,
        slotted_rings,
        pin_in_two_slots,
        bent_coupler,
        sliding_plate,
        rack_and_gear,
        pointed_follower,
        plate_on_fixed_corners,
        corner_in_two_sleeves,
        wheels_on_cylinder,
    )
}
