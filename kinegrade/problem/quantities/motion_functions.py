"""The functions of the motion: a row for each, from which everything else about it follows.

The comments that begin with `#:` say what each gives; the reference of docs/ prints them.
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
    #: The velocity of a point, of the body named where it belongs to several.
    "velocity": MotionFunction(
        slots=("POINT", "BODY"),
        optional=1,
        gives=Arrow(SPEED),
        by_changes=False,
        read=_read_velocity,
        refer=_refer_to_point,
        derivation="point",
    ),
    #: The acceleration of a point, in the same way.
    "acceleration": MotionFunction(
        slots=("POINT", "BODY"),
        optional=1,
        gives=Arrow(ACCELERATION),
        by_changes=True,
        read=_read_acceleration,
        refer=_refer_to_point,
        derivation="point",
    ),
    #: The angular velocity of a body, or relative to a second body.
    "omega": MotionFunction(
        slots=("BODY", "BODY"),
        optional=1,
        gives=Scalar(RATE),
        by_changes=False,
        read=_read_omega,
        refer=_refer_to_rotations,
        derivation="rotation",
    ),
    #: The angular acceleration of a body, or relative to a second body.
    "alpha": MotionFunction(
        slots=("BODY", "BODY"),
        optional=1,
        gives=Scalar(CHANGE),
        by_changes=True,
        read=_read_alpha,
        refer=_refer_to_rotations,
        derivation="rotation",
    ),
    #: The velocity of a point of the first body as seen from the second.
    "relative_velocity": MotionFunction(
        slots=("POINT", "BODY", "BODY"),
        gives=Arrow(SPEED),
        by_changes=False,
        read=_read_relative_velocity,
        refer=_refer_to_both_points,
        derivation="relative",
    ),
    #: The acceleration of a point of the first body as seen from the second.
    "relative_acceleration": MotionFunction(
        slots=("POINT", "BODY", "BODY"),
        gives=Arrow(ACCELERATION),
        by_changes=True,
        read=_read_relative_acceleration,
        refer=_refer_to_turning_frame,
        derivation="relative",
    ),
    #: The Coriolis acceleration of a point of the first body, the moving frame being the second.
    "coriolis": MotionFunction(
        slots=("POINT", "BODY", "BODY"),
        gives=Arrow(ACCELERATION),
        by_changes=False,
        read=_read_coriolis,
        refer=_refer_to_turning_frame,
        derivation="coriolis",
    ),
    #: The normal part of the acceleration of the first point relative to the second, both on the
    #: body.
    "normal_acceleration": MotionFunction(
        slots=("POINT", "POINT", "BODY"),
        gives=Arrow(ACCELERATION),
        by_changes=False,
        read=read_normal,
        refer=_refer_about_base,
        derivation="normal",
    ),
    #: The tangential part of the acceleration of the first point relative to the second, both on
    #: the body.
    "tangential_acceleration": MotionFunction(
        slots=("POINT", "POINT", "BODY"),
        gives=Arrow(ACCELERATION),
        by_changes=True,
        read=_read_tangential,
        refer=_refer_about_base,
        derivation="tangential",
    ),
    #: The velocity pole (instantaneous centre) of a body.
    "pole": MotionFunction(
        slots=("BODY",),
        gives=Arrow(LENGTH),
        by_changes=False,
        read=_read_pole,
        refer=_refer_to_body,
        derivation="pole",
    ),
    #: The fixed centrode of a body while the parameter changes, where it is a circle.
    "circle_of_poles": MotionFunction(
        slots=("BODY", "PARAMETER"),
        gives=Ring(),
        by_changes=False,
        read=None,
        refer=_refer_to_body,
        derivation="centrode",
    ),
}
