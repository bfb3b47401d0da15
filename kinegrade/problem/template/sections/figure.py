"""The table `[figure]`: what an author wants marked in the figure."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Set
from dataclasses import dataclass
from typing import TypeVar

from kinegrade.errors import FieldError, suggest_examples
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import Read, choice, found
from kinegrade.language.message import Message, Quoted
from kinegrade.mechanics.joints import GROUND
from kinegrade.problem.template.hints import (
    AXES,
    LEVELS,
    PLACES_OF_AXES,
    PROJECTIONS,
    ROPES,
    SENSES,
    SHAPES,
    SIDES,
    Angle,
    Axes,
    BodyFrame,
    FigureHints,
    Length,
    Moving,
    Radius,
    Rimmed,
    Shape,
    Side,
    Turning,
)
from kinegrade.problem.template.sections import keys
from kinegrade.problem.template.sections.values import named
from kinegrade.problem.template.symbols import find_symbol_fault

_Mark = TypeVar("_Mark")


@dataclass(frozen=True)
class Names:
    """The points and bodies that marks can name, as readers of their names."""

    points: Set[str]
    bodies: Set[str]

    @property
    def point(self) -> Read[str]:
        """A point."""
        return named("point", self.points)

    @property
    def body(self) -> Read[str]:
        """A body or the ground."""
        return named("body", self.bodies | {GROUND})

    @property
    def moving_body(self) -> Read[str]:
        """A body other than the ground."""
        return named("body", self.bodies)

    @property
    def direction(self) -> Read[str]:
        """A point or a side of the paper."""
        return named("point-or-side", self.points | set(SIDES))

    @property
    def labelled(self) -> Set[str]:
        """What can have a label."""
        return self.points | self.bodies | {GROUND}


def read_figure(table: Table, names: Names) -> FigureHints:
    """The marks of the figure that can be read."""
    figure = table.table("figure").only(*keys.FIGURE, hint=_suggest_marks)
    return FigureHints(
        lengths=_read_marks(figure, "lengths", _read_length, names),
        angles=_read_marks(figure, "angles", _read_angle, names),
        radii=_read_marks(figure, "radii", _read_radius, names),
        circles=_read_marks(figure, "circles", _read_circle, names),
        lines=figure.listing("lines", lambda value: _read_line(value, names)),
        right_angles=figure.listing("right_angles", lambda value: _read_right_angle(value, names)),
        arrows=_read_marks(figure, "arrows", _read_arrow, names),
        labels=_read_labels(figure, names),
        shapes=_read_shapes(figure, names),
        supports=_read_supports(figure, names),
        frames=_read_marks(figure, "frames", _read_frame, names),
        axes=figure.optional("axes", _read_axes),
    )


def _read_axes(value: object) -> Axes:
    """Where the axes are drawn. Exams of version 0.2.0 keep templates that say so by `true`: that
    they are drawn, at the origin.
    """
    return "origin" if value is True else choice(PLACES_OF_AXES)(value)


def _suggest_marks(key: str) -> Message:
    return suggest_examples(key, keys.FIGURE_EXAMPLES, "figure")


def _read_marks(
    figure: Table, key: str, read: Callable[[Table, Names], _Mark | None], names: Names
) -> tuple[_Mark, ...]:
    marks = [read(row, names) for row in figure.tables(key, '{ symbol = "r", ... }')]
    return tuple(mark for mark in marks if mark is not None)


def _read_length(table: Table, names: Names) -> Length | None:
    row = table.only(*keys.LENGTH)
    symbol = row.required("symbol", _read_symbol)
    start, end = row.required("from", names.point), row.required("to", names.point)
    along = row.optional("along", choice(PROJECTIONS))
    if symbol is None or start is None or end is None:
        return None
    return Length(symbol, start, end, along)


def _read_angle(table: Table, names: Names) -> Angle | None:
    row = table.only(*keys.ANGLE)
    symbol, at = row.required("symbol", _read_symbol), row.required("at", names.point)
    start, end = row.required("from", names.direction), row.required("to", names.direction)
    sense = row.optional("sense", choice(SENSES))
    if symbol is None or at is None or start is None or end is None:
        return None
    return Angle(symbol, at, start, end, sense)


def _read_radius(table: Table, names: Names) -> Radius | None:
    row = table.only(*keys.RADIUS)
    symbol, centre = row.required("symbol", _read_symbol), row.required("centre", names.point)
    of, through = row.optional("of", names.body), row.optional("through", names.point)
    if symbol is None or centre is None:
        return None
    return Radius(symbol, centre, of, through)


def _read_circle(table: Table, names: Names) -> Rimmed | None:
    row = table.only(*keys.CIRCLE)
    body, centre = row.required("body", names.body), row.required("centre", names.point)
    through = row.required("through", names.point)
    if body is None or centre is None or through is None:
        return None
    if centre == through:
        row.fault(
            "through",
            Message("template.circle-through-itself", centre=Quoted(centre)),
            Message("template.another-point"),
        )
    return Rimmed(body, centre, through)


def _read_arrow(table: Table, names: Names) -> Turning | Moving | None:
    return _read_moving(table, names) if "moves" in table else _read_turning(table, names)


def _read_moving(table: Table, names: Names) -> Moving | None:
    row = table.only(*keys.MOVING)
    symbol, point = row.required("symbol", _read_symbol), row.required("moves", names.point)
    along = row.optional("along", names.direction)
    level = row.optional("rate", choice(LEVELS)) or "velocity"
    if symbol is None or point is None:
        return None
    return Moving(symbol, point, along, level)


def _read_turning(table: Table, names: Names) -> Turning | None:
    row = table.only(*keys.TURNING)
    symbol, body = row.required("symbol", _read_symbol), row.required("turns", names.moving_body)
    sense = row.optional("sense", choice(SENSES))
    level = row.optional("rate", choice(LEVELS)) or "velocity"
    if symbol is None or body is None:
        return None
    return Turning(symbol, body, sense, level)


def _read_frame(table: Table, names: Names) -> BodyFrame | None:
    row = table.only(*keys.FRAME)
    x, y = row.required("x", _read_symbol), row.required("y", _read_symbol)
    at, end = row.required("at", names.point), row.required("to", names.direction)
    start, along = row.optional("from", names.point), row.optional("along", choice(AXES))
    if x is None or y is None or at is None or end is None:
        return None
    return BodyFrame(x, y, at, start or at, end, along or "x")


def _read_line(value: object, names: Names) -> tuple[str, str]:
    """Two different points."""
    match value:
        case [start, end] if start == end:
            what = Message("template.line-to-itself", point=found(start))
            raise FieldError(what, Message("template.two-points"))
        case [start, end]:
            return names.point(start), names.point(end)
        case _:
            raise FieldError(found(value), Message("template.two-points-like"))


def _read_right_angle(value: object, names: Names) -> tuple[str, str, str]:
    """Three different points."""
    match value:
        case [start, at, end] if len({names.point(name) for name in (start, at, end)}) == 3:
            return names.point(start), names.point(at), names.point(end)
        case _:
            raise FieldError(found(value), Message("template.three-points-like"))


def _read_labels(figure: Table, names: Names) -> Mapping[str, str | None]:
    """Text for points and bodies; None where there is to be none."""
    texts = figure.table("labels", "{ O = 'O_1' }").only(
        *names.labelled, unknown=Message("fields.unknown-point-or-body")
    )
    return {name: text or None for name, text in texts.entries(_label).items()}


def _read_shapes(figure: Table, names: Names) -> Mapping[str, Shape]:
    bodies = names.bodies | {GROUND}
    shapes = figure.table("shapes", '{ OA = "bent" }').only(
        *bodies, unknown=Message("fields.unknown-body")
    )
    found = shapes.entries(choice(SHAPES))
    if found.get(GROUND) in ROPES:
        shapes.fault(GROUND, Message("template.rope-of-ground"), do=Message("template.fixed-rope"))
    return found


def _read_supports(figure: Table, names: Names) -> Mapping[str, Side]:
    supports = figure.table("supports", '{ O = "up" }').only(
        *names.points, unknown=Message("fields.unknown-point")
    )
    return supports.entries(choice(SIDES))


def _label(value: object) -> str:
    """A symbol; "" for none."""
    return "" if value is False or value == "" else _read_symbol(value)


def _read_symbol(value: object) -> str:
    """LaTeX math from a small alphabet, without dollar signs."""
    if not isinstance(value, str):
        raise FieldError(found(value), Message("template.a-symbol"))
    fault = find_symbol_fault(value)
    if fault:
        raise FieldError(fault)
    return str(value)
