"""Random mechanisms, grown from the ground: a driven body, then groups of bodies that add no
freedom.

All coordinates and radii are rational: arms have Pythagorean directions, so that wheels touch
exactly. Every joint kind and every driver kind occurs.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import isqrt
from typing import Any

from flint import fmpq
from hypothesis import strategies as st

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

COORDINATES = st.builds(fmpq, st.integers(-12, 12), st.integers(2, 3))
RATES = st.builds(fmpq, st.integers(-9, 9).filter(bool), st.integers(1, 2))
CHANGES = st.builds(fmpq, st.integers(-9, 9), st.integers(1, 2))
RADII = st.builds(fmpq, st.integers(1, 9), st.integers(2, 4))
TRIPLES = ((1, 0, 1), (0, 1, 1), (3, 4, 5), (-5, 12, 13), (8, -15, 17), (-4, -3, 5), (21, 20, 29))
DIRECTIONS = st.sampled_from([Vector(fmpq(x, z), fmpq(y, z)) for x, y, z in TRIPLES])


@dataclass
class Growth:
    """A mechanism while it grows; `draw` is hypothesis' own."""

    draw: Any
    points: dict[str, Vector] = field(default_factory=dict)
    bodies: dict[str, list[str]] = field(default_factory=dict)
    particles: set[str] = field(default_factory=set)
    joints: list[Joint] = field(default_factory=list)
    drivers: list[Driver] = field(default_factory=list)
    cranks: dict[str, str] = field(default_factory=dict)

    def mechanism(self) -> Mechanism:
        bodies = tuple(
            Body(name, tuple(marked), name in self.particles)
            for name, marked in self.bodies.items()
        )
        return Mechanism(self.points, bodies, tuple(self.joints), tuple(self.drivers))

    def point(self, where: Vector | None = None) -> str:
        """A new point, anywhere or somewhere."""
        name = f"P{len(self.points)}"
        self.points[name] = where or Vector(self.draw(COORDINATES), self.draw(COORDINATES))
        return name

    def body(self, *points: str, particle: bool = False) -> str:
        name = f"b{len(self.bodies)}"
        self.bodies[name] = list(points)
        if particle:
            self.particles.add(name)
        return name

    def host(self) -> tuple[str, str]:
        """A moving body that is no particle, and a new point on it."""
        body = self.draw(
            st.sampled_from([name for name in self.bodies if name not in self.particles])
        )
        point = self.point()
        self.bodies[body].append(point)
        return body, point

    def frame(self) -> str:
        """The ground, or a moving body that is no particle."""
        return self.draw(
            st.sampled_from([GROUND, *(name for name in self.bodies if name not in self.particles)])
        )

    def line(self, point: str) -> Line:
        """A line through a point."""
        return Line(self.points[point], self.draw(DIRECTIONS) * self.draw(RADII))

    def away(self, point: str, distance: Any) -> str:
        """A new point at a distance from a point."""
        return self.point(self.points[point] + self.draw(DIRECTIONS) * distance)

    def imposed(self) -> tuple[Any, Any]:
        return self.draw(RATES), self.draw(CHANGES)


def crank(growth: Growth) -> None:
    """A crank about a fixed pin, driven by its rotation or by its end's motion along the circle."""
    pivot, end = growth.point(), growth.point()
    name = growth.body(pivot, end)
    growth.cranks[name] = pivot
    growth.joints.append(Pin(pivot, (GROUND, name)))
    if growth.draw(st.booleans()) or growth.points[pivot] == growth.points[end]:
        growth.drivers.append(Rotation(name, *growth.imposed()))
    else:
        growth.drivers.append(Circulation(end, name, pivot, *growth.imposed()))


def block(growth: Growth) -> None:
    """A block in a fixed guide."""
    point = growth.point()
    name, line = growth.body(point), growth.line(point)
    growth.joints.append(Sleeve(name, line, GROUND))
    growth.drivers.append(
        Component(point, name, line.direction / length(line.direction), *growth.imposed())
    )


def wheel(growth: Growth) -> None:
    """A wheel that rolls on the ground, driven by its rotation."""
    centre = growth.point()
    name = growth.body(centre)
    roll(growth, name, centre, GROUND)
    growth.drivers.append(Rotation(name, *growth.imposed()))


def length(vector: Vector) -> Any:
    """The length of a multiple of one of the Pythagorean directions."""
    square = vector.squared()
    return fmpq(isqrt(int(square.p)), isqrt(int(square.q)))


def track(growth: Growth, centre: str, radius: Any) -> tuple[Line | Circle, bool]:
    """A line or circle that a circle about `centre` touches, and whether one lies within the
    other.
    """
    kind = growth.draw(st.sampled_from(["line", "outside", "inside"]))
    if kind == "line":
        normal = growth.draw(DIRECTIONS)
        return Line(
            growth.points[centre] + normal * radius, normal.turned() * growth.draw(RADII)
        ), False
    other = growth.draw(RADII.filter(lambda other: other != radius))
    distance = radius + other if kind == "outside" else other - radius
    return Circle(growth.away(centre, distance), other), kind == "inside"


def roll(growth: Growth, body: str, centre: str, of: str) -> None:
    """A wheel rolls on a line or circle of a body."""
    radius = growth.draw(RADII)
    on, inside = track(growth, centre, radius)
    growth.joints.append(Roll(body, Circle(centre, radius), of, on, inside))


def rod(growth: Growth) -> tuple[str, str]:
    """A rod pinned to a host, and a new point on it."""
    host, joint = growth.host()
    end = growth.point()
    name = growth.body(joint, end)
    growth.joints.append(Pin(joint, (host, name)))
    return name, end


def rod_and_slider(growth: Growth) -> None:
    """A rod whose end slides on a line of the ground or of a moving body."""
    frame = growth.frame()
    name, end = rod(growth)
    growth.joints.append(Slide(end, name, growth.line(end), frame))


def rod_and_rocker(growth: Growth) -> None:
    """A rod and a rocker that turns about a fixed pin or a pin of a moving body."""
    frame = growth.frame()
    name, end = rod(growth)
    pivot = growth.point()
    rocker = growth.body(end, pivot)
    growth.joints += [Pin(pivot, (frame, rocker)), Pin(end, (name, rocker))]


def three_at_a_pin(growth: Growth) -> None:
    """Two bars and a driven arm at one pin of a host."""
    host, joint = growth.host()
    fixed, end = growth.point(), growth.point()
    first, second, third = (
        growth.body(joint),
        growth.body(joint, end),
        growth.body(joint, growth.point()),
    )
    growth.joints += [
        Pin(joint, (host, first, second, third)),
        Slide(end, second, growth.line(end), GROUND),
        Slide(fixed, GROUND, growth.line(fixed), first),
    ]
    growth.drivers.append(Rotation(third, *growth.imposed(), of=first))


def slotted_rocker(growth: Growth) -> None:
    """A point of a host runs in the slot of a rocker; the slot need not pass through the pin."""
    host, joint = growth.host()
    frame = growth.frame()
    pivot = growth.point()
    rocker = growth.body(pivot)
    growth.joints += [Pin(pivot, (frame, rocker)), Slide(joint, host, growth.line(joint), rocker)]


def bar_past_a_fixed_point(growth: Growth) -> None:
    """A line of a rod passes through a fixed point."""
    name, _ = rod(growth)
    fixed = growth.point()
    growth.joints.append(Slide(fixed, GROUND, growth.line(fixed), name))


def bar_through_a_sleeve(growth: Growth) -> None:
    """A rod slides through a swivelling sleeve."""
    frame = growth.frame()
    name, _ = rod(growth)
    pivot = growth.point()
    sleeve = growth.body(pivot)
    growth.joints += [Pin(pivot, (frame, sleeve)), Sleeve(name, growth.line(pivot), sleeve)]


def arc_slot(growth: Growth) -> None:
    """A point of a host stays on a circle of a rocker."""
    host, joint = growth.host()
    pivot, radius = growth.point(), growth.draw(RADII)
    rocker = growth.body(pivot)
    growth.joints += [
        Pin(pivot, (GROUND, rocker)),
        Arc(joint, host, Circle(growth.away(joint, radius), radius), rocker),
    ]


def pushed_rocker(growth: Growth) -> None:
    """A circle of a host touches a line or circle of a rocker, or a circle of the rocker one of the
    host.
    """
    host, centre = growth.host()
    pivot, radius = growth.point(), growth.draw(RADII)
    rocker = growth.body(pivot)
    on, inside = track(growth, centre, radius)
    growth.joints += [
        Pin(pivot, (GROUND, rocker)),
        Contact(host, Circle(centre, radius), rocker, on, inside),
    ]


def flat_follower(growth: Growth) -> None:
    """A translating follower with a flat face on a circle of a host."""
    host, centre = growth.host()
    point, radius, normal = growth.point(), growth.draw(RADII), growth.draw(DIRECTIONS)
    follower = growth.body(point)
    face = Line(growth.points[centre] + normal * radius, normal.turned())
    growth.joints += [
        Parallel(follower, GROUND),
        Slide(point, follower, growth.line(point), GROUND),
        Contact(host, Circle(centre, radius), follower, face),
    ]


def rod_and_wheel(growth: Growth) -> None:
    """A rod pulls a wheel that rolls on the ground or on a moving body."""
    frame = growth.frame()
    name, centre = rod(growth)
    rolling = growth.body(centre)
    growth.joints.append(Pin(centre, (name, rolling)))
    roll(growth, rolling, centre, frame)


def planet(growth: Growth) -> None:
    """A planet on a crank, rolling on a fixed circle about the crank's pin."""
    if not growth.cranks:
        rod_and_wheel(growth)
        return
    arm = growth.draw(st.sampled_from(sorted(growth.cranks)))
    sun, own = growth.draw(RADII), growth.draw(RADII)
    inside = growth.draw(st.booleans()) and sun != own
    centre = growth.away(growth.cranks[arm], sun - own if inside else sun + own)
    growth.bodies[arm].append(centre)
    gear = growth.body(centre)
    growth.joints += [
        Pin(centre, (arm, gear)),
        Roll(gear, Circle(centre, own), GROUND, Circle(growth.cranks[arm], sun), inside),
    ]


def geared_pair(growth: Growth) -> None:
    """Two gears on a carrier, one of them driven relative to it."""
    carrier, first = growth.host()
    own, other = growth.draw(RADII), growth.draw(RADII)
    inside = growth.draw(st.booleans()) and own != other
    second = growth.away(first, other - own if inside else other + own)
    growth.bodies[carrier].append(second)
    driven, gear = growth.body(first), growth.body(second, growth.point())
    growth.joints += [
        Pin(first, (carrier, driven)),
        Pin(second, (carrier, gear)),
        Mesh(gear, Circle(second, own), driven, Circle(first, other), carrier, inside),
    ]
    growth.drivers.append(
        Rotation(driven, *growth.imposed(), of=growth.draw(st.sampled_from([carrier, GROUND])))
    )


def belted_pair(growth: Growth) -> None:
    """Two pulleys on a carrier, one of them driven relative to it."""
    carrier, first = growth.host()
    own, other = growth.draw(RADII), growth.draw(RADII)
    second = growth.away(first, own + other + growth.draw(RADII))
    growth.bodies[carrier].append(second)
    driven, pulley = growth.body(first), growth.body(second, growth.point())
    circles = Circle(second, own), Circle(first, other)
    growth.joints += [
        Pin(first, (carrier, driven)),
        Pin(second, (carrier, pulley)),
        Belt(pulley, circles[0], driven, circles[1], carrier, growth.draw(st.booleans())),
    ]
    growth.drivers.append(
        Rotation(driven, *growth.imposed(), of=growth.draw(st.sampled_from([carrier, GROUND])))
    )


def platform(growth: Growth) -> None:
    """A bar carried by a host that does not turn relative to the ground or a moving body."""
    frame = growth.frame()
    name, _ = rod(growth)
    growth.joints.append(Parallel(name, frame))


def driven_arm(growth: Growth) -> None:
    """A bar on a host with its own motor."""
    host, joint = growth.host()
    name = growth.body(joint, growth.point())
    growth.joints.append(Pin(joint, (host, name)))
    growth.drivers.append(Rotation(name, *growth.imposed(), of=host))


def particle_in_a_slot(growth: Growth) -> None:
    """A particle driven along a slot of a host."""
    host, point = growth.host()
    name, line = growth.body(point, particle=True), growth.line(point)
    growth.joints.append(Slide(point, name, line, host))
    growth.drivers.append(
        Component(point, name, line.direction / length(line.direction), *growth.imposed(), of=host)
    )


def steered_particle(growth: Growth) -> None:
    """A particle without a slot, steered along two directions seen from a host."""
    host, point = growth.host()
    name = growth.body(point, particle=True)
    for direction in (growth.draw(DIRECTIONS), growth.draw(DIRECTIONS)):
        growth.drivers.append(Component(point, name, direction, *growth.imposed(), of=host))


STARTS = (crank, block, wheel)
GROUPS = (
    rod_and_slider,
    rod_and_rocker,
    slotted_rocker,
    bar_past_a_fixed_point,
    bar_through_a_sleeve,
    arc_slot,
    pushed_rocker,
    flat_follower,
    rod_and_wheel,
    planet,
    geared_pair,
    belted_pair,
    platform,
    driven_arm,
    particle_in_a_slot,
    steered_particle,
    three_at_a_pin,
)


@st.composite
def mechanisms(draw: Any, groups: int = 2) -> Mechanism:
    """A mechanism of a driven body and up to `groups` groups; some stand at a dead point."""
    growth = Growth(draw)
    draw(st.sampled_from(STARTS))(growth)
    for group in draw(st.lists(st.sampled_from(GROUPS), min_size=1, max_size=groups)):
        group(growth)
    return growth.mechanism()
