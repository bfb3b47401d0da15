"""The functions of the motion: a row for each, from which everything else about it follows.

The entry `words.function-NAME` of the catalogues says what each gives.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.kinds.dimension import ACCELERATION, CHANGE, LENGTH, RATE, SPEED
from kinegrade.problem.kinds.kinds import Arrow, Ring, Scalar
from kinegrade.problem.quantities.motion_function import MotionFunction, References
from kinegrade.problem.quantities.reader import MotionReader


def _read_velocity(reader: MotionReader, place: Vector, body: Any = None) -> Vector:
    """Velocity of a point."""
    point = reader.point(place)
    return reader.motion.velocity(point, reader.owner(point, body))


def _read_acceleration(reader: MotionReader, place: Vector, body: Any = None) -> Vector:
    """Acceleration of a point."""
    point = reader.point(place)
    return reader.motion.acceleration(point, reader.owner(point, body))


def _refer_to_point(names: Sequence[str], reader: MotionReader) -> References:
    body = names[1] if len(names) > 1 else reader.owner(names[0], None)
    return References(((body, names[0]),))


def _read_omega(reader: MotionReader, body: Any, of: Any = None) -> Any:
    """Angular velocity, absolute or relative to a second body."""
    return reader.motion.omega(reader.body(body), GROUND if of is None else reader.body(of))


def _read_alpha(reader: MotionReader, body: Any, of: Any = None) -> Any:
    """Angular acceleration, absolute or relative to a second body."""
    return reader.motion.alpha(reader.body(body), GROUND if of is None else reader.body(of))


def _refer_to_rotations(names: Sequence[str], reader: MotionReader) -> References:
    return References(turning=tuple(names))


def _read_relative_velocity(reader: MotionReader, place: Vector, body: Any, frame: Any) -> Vector:
    """Velocity of a body's point seen from a moving body."""
    return reader.motion.relative_velocity(
        reader.point(place), reader.body(body), reader.body(frame)
    )


def _refer_to_both_points(names: Sequence[str], reader: MotionReader) -> References:
    point, body, frame = names
    return References(((body, point), (frame, point)))


def _read_relative_acceleration(
    reader: MotionReader, place: Vector, body: Any, frame: Any
) -> Vector:
    """Acceleration of a body's point seen from a moving body."""
    return reader.motion.relative_acceleration(
        reader.point(place), reader.body(body), reader.body(frame)
    )


def _read_coriolis(reader: MotionReader, place: Vector, body: Any, frame: Any) -> Vector:
    """Coriolis acceleration of a body's point, moving frame on the second body."""
    return reader.motion.coriolis(reader.point(place), reader.body(body), reader.body(frame))


def _refer_to_turning_frame(names: Sequence[str], reader: MotionReader) -> References:
    point, body, frame = names
    return References(((body, point), (frame, point)), (frame,))


def read_normal(reader: MotionReader, place: Vector, base: Vector, body: Any) -> Vector:
    """Centripetal part of the acceleration of a point relative to a base point of the same body."""
    rate = reader.motion.omega(reader.body(body))
    acceleration: Vector = (base - place) * reader.motion.reading.square(rate)
    return acceleration


def _read_tangential(reader: MotionReader, place: Vector, base: Vector, body: Any) -> Vector:
    """Tangential part of the acceleration of a point relative to a base point of the same body."""
    acceleration: Vector = (place - base).turned() * reader.motion.alpha(reader.body(body))
    return acceleration


def _refer_about_base(names: Sequence[str], reader: MotionReader) -> References:
    return References(turning=(names[2],))


def _read_pole(reader: MotionReader, body: Any) -> Vector:
    """Velocity pole of a body."""
    return reader.motion.pole(reader.body(body), reader.arithmetic)


def _refer_to_body(names: Sequence[str], reader: MotionReader) -> References:
    body = names[0]
    return References(((body, reader.motion.frames.bases[body].point),), (body,))


MOTION_FUNCTIONS: Mapping[str, MotionFunction] = {
    "velocity": MotionFunction(
        example="velocity(B)",
        slots=("POINT", "BODY"),
        optional=1,
        gives=Arrow(SPEED),
        by_changes=False,
        read=_read_velocity,
        refer=_refer_to_point,
        derivation="point",
    ),
    "acceleration": MotionFunction(
        example="acceleration(B)",
        slots=("POINT", "BODY"),
        optional=1,
        gives=Arrow(ACCELERATION),
        by_changes=True,
        read=_read_acceleration,
        refer=_refer_to_point,
        derivation="point",
    ),
    "omega": MotionFunction(
        example="omega(AB)",
        slots=("BODY", "BODY"),
        optional=1,
        gives=Scalar(RATE),
        by_changes=False,
        read=_read_omega,
        refer=_refer_to_rotations,
        derivation="rotation",
    ),
    "alpha": MotionFunction(
        example="alpha(AB, OA)",
        slots=("BODY", "BODY"),
        optional=1,
        gives=Scalar(CHANGE),
        by_changes=True,
        read=_read_alpha,
        refer=_refer_to_rotations,
        derivation="rotation",
    ),
    "relative_velocity": MotionFunction(
        example="relative_velocity(A, OA, CB)",
        slots=("POINT", "BODY", "BODY"),
        gives=Arrow(SPEED),
        by_changes=False,
        read=_read_relative_velocity,
        refer=_refer_to_both_points,
        derivation="relative",
    ),
    "relative_acceleration": MotionFunction(
        example="relative_acceleration(A, OA, CB)",
        slots=("POINT", "BODY", "BODY"),
        gives=Arrow(ACCELERATION),
        by_changes=True,
        read=_read_relative_acceleration,
        refer=_refer_to_turning_frame,
        derivation="relative",
    ),
    "coriolis": MotionFunction(
        example="coriolis(A, OA, CB)",
        slots=("POINT", "BODY", "BODY"),
        gives=Arrow(ACCELERATION),
        by_changes=False,
        read=_read_coriolis,
        refer=_refer_to_turning_frame,
        derivation="coriolis",
    ),
    "normal_acceleration": MotionFunction(
        example="normal_acceleration(B, A, AB)",
        slots=("POINT", "POINT", "BODY"),
        gives=Arrow(ACCELERATION),
        by_changes=False,
        read=read_normal,
        refer=_refer_about_base,
        derivation="normal",
    ),
    "tangential_acceleration": MotionFunction(
        example="tangential_acceleration(B, A, AB)",
        slots=("POINT", "POINT", "BODY"),
        gives=Arrow(ACCELERATION),
        by_changes=True,
        read=_read_tangential,
        refer=_refer_about_base,
        derivation="tangential",
    ),
    "pole": MotionFunction(
        example="pole(AB)",
        slots=("BODY",),
        gives=Arrow(LENGTH),
        by_changes=False,
        read=_read_pole,
        refer=_refer_to_body,
        derivation="pole",
    ),
    "circle_of_poles": MotionFunction(
        example="circle_of_poles(AB, phi)",
        slots=("BODY", "PARAMETER"),
        gives=Ring(),
        by_changes=False,
        read=None,
        refer=_refer_to_body,
        derivation="centrode",
    ),
}
