"""The circles of a mechanism: wheels, gears, tracks, discs, slotted rings, each derived from the
joints; and those that only a hint knows.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from msgspec.structs import replace

from kinegrade.figure.joints.symbol import Rim, Symbol
from kinegrade.figure.plane import NEAR, angle_of, length, polar
from kinegrade.figure.teeth import find_tooth_angle
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Rimmed

_Key = tuple[str, str, float]  # the body, the centre and the radius of a circle


def find_rims(
    mechanism: Mechanism, symbols: Iterable[Symbol], circles: Iterable[Rimmed]
) -> tuple[Rim, ...]:
    """Every circle once: those of the joints, then those of the hints."""
    found: dict[_Key, Rim] = {}
    pairs = [symbol.rims for symbol in symbols]
    alone = [(_find_edge(mechanism, circle),) for circle in circles]
    for rims in (*pairs, *alone):
        for rim in _engage(rims, found):
            found.setdefault(_make_key(rim), rim)
        for rim in rims:
            known = found[_make_key(rim)]
            contacts = dict.fromkeys((*known.contacts, *rim.contacts))
            found[_make_key(rim)] = replace(known, contacts=tuple(contacts))
    return tuple(found.values())


def _make_key(rim: Rim) -> _Key:
    return rim.body, rim.centre, round(rim.radius, 6)


def _engage(rims: tuple[Rim, ...], found: Mapping[_Key, Rim]) -> tuple[Rim, ...]:
    """The circles of a joint, with the teeth of the second in the gaps of the first, as far as a
    circle is not engaged already.
    """
    if len(rims) < 2:
        return rims
    one, other = sorted(rims, key=lambda rim: _make_key(rim) not in found)
    one = found.get(_make_key(one), one)
    return one, replace(other, tooth=_find_next_tooth(one, other))


def _find_next_tooth(one: Rim, other: Rim) -> Vector:
    """Where the other circle has a tooth, half a tooth beside one of the first at their contact."""
    step = find_tooth_angle(one.radius)
    ahead = (angle_of(one.tooth - one.at) - angle_of(other.touch - one.at)) % step
    along = ahead * one.radius / other.radius * (1.0 if one.ring != other.ring else -1.0)
    turn = angle_of(other.touch - other.at) + along + find_tooth_angle(other.radius) / 2
    return other.at + polar(turn, other.radius)


def find_gap_of_rack(rims: Iterable[Rim], contact: Vector) -> Vector:
    """Where a rack has a gap on its pitch line: at the tooth of its gear that is nearest to their
    contact, rolled out from there.
    """
    gear = next(rim for rim in rims if _touches(rim, contact))
    step, outward = find_tooth_angle(gear.radius), contact - gear.at
    behind = (angle_of(gear.tooth - gear.at) - angle_of(outward) + step / 2) % step
    return contact + outward.turned() * (behind - step / 2)


def _touches(rim: Rim, contact: Vector) -> bool:
    return rim.kind == "gear" and abs(length(contact - rim.at) - rim.radius) < NEAR


def _find_edge(mechanism: Mechanism, circle: Rimmed) -> Rim:
    at, touched = mechanism.points[circle.centre], mechanism.points[circle.through]
    return Rim(
        circle.body, circle.centre, at, length(touched - at), "edge", False, touched, touched
    )


def order_rims(found: tuple[Rim, ...]) -> tuple[Rim, ...]:
    """Rims from the largest to the smallest, so that none hides another; those of the ground
    first, but for those that a larger wheel about their centre would cover.
    """
    above = {_make_key(rim) for rim in found if rim.body != GROUND or _is_covered(rim, found)}
    return tuple(sorted(found, key=lambda rim: (_make_key(rim) in above, -rim.radius)))


def _is_covered(rim: Rim, found: Iterable[Rim]) -> bool:
    """Whether a larger disc of a moving body is about the centre of a wheel."""
    return not rim.ring and any(
        other.body != GROUND
        and not other.ring
        and other.kind != "slot"
        and other.radius > rim.radius
        and length(other.at - rim.at) < NEAR
        for other in found
    )
