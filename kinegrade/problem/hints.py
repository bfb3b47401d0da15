"""What a template author wants marked in the figure: the `[figure]` table of a template, read and
checked.

The shape of the mechanism itself is never a hint: it follows from bodies and joints.
"""

from __future__ import annotations

from collections.abc import Mapping
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, field, replace
from typing import Any, Literal, cast

from kinegrade.errors import TemplateError, did_you_mean
from kinegrade.mechanics.joints import GROUND
from kinegrade.problem.symbols import symbol_fault

Sense = Literal["ccw", "cw"]
Side = Literal["right", "up", "left", "down"]
Shape = Literal["gear", "cam", "bent", "bar", "through"]

SENSES = ("ccw", "cw")
TURN: Mapping[Sense, float] = {"ccw": 1.0, "cw": -1.0}  # counter-clockwise is positive
SIDES = ("right", "up", "left", "down")
SHAPES = ("gear", "cam", "bent", "bar", "through")


@dataclass(frozen=True)
class Length:
    """A dimension between two points; along "horizontal" or "vertical" it is the projected
    distance.
    """

    symbol: str
    start: str
    end: str
    along: str | None = None


@dataclass(frozen=True)
class Angle:
    """An angle at a point between two directions, each a side of the paper or another point.

    Drawn the shorter way, or in the given sense from `start` to `end`.
    """

    symbol: str
    at: str
    start: str
    end: str
    sense: Sense | None = None


@dataclass(frozen=True)
class Radius:
    """The radius of a circle about `centre`; `of` names its body, `through` a point on it, where
    several share it.
    """

    symbol: str
    centre: str
    of: str | None = None
    through: str | None = None


@dataclass(frozen=True)
class Rimmed:
    """A circle of a body that no joint knows of (the flange of a wheel), about one point through
    another.
    """

    body: str
    centre: str
    through: str


@dataclass(frozen=True)
class Turning:
    """A curved arrow about the pivot of a body; without a sense it follows the sign of the imposed
    motion.
    """

    symbol: str
    body: str
    sense: Sense | None = None


@dataclass(frozen=True)
class Moving:
    """A straight arrow at a point, towards a side or a point; else as the imposed velocity has
    it.
    """

    symbol: str
    point: str
    along: str | None = None


@dataclass(frozen=True)
class FigureHints:
    """Everything an author may ask of a figure.

    `labels` gives other text for a point, or text for a body ("ground": its fixed circle); None: no
    label. A point that is only constructed appears when it has a label. `lines` are thin, between
    two points. `shapes` overrides: "gear" (pitch circle), "cam" (only the curvature at the contact
    is known), "bent" (a rod through its points in order, not a plate), "bar" (sliders run on it in
    sleeves, not in a slot), "through" (a translating rod that goes on beyond its point).
    """

    lengths: tuple[Length, ...] = ()
    angles: tuple[Angle, ...] = ()
    radii: tuple[Radius, ...] = ()
    circles: tuple[Rimmed, ...] = ()
    lines: tuple[tuple[str, str], ...] = ()
    arrows: tuple[Turning | Moving, ...] = ()
    labels: Mapping[str, str | None] = field(default_factory=dict)
    shapes: Mapping[str, Shape] = field(default_factory=dict)
    axes: bool = False


def read_hints(
    table: Mapping[str, Any], where: str, points: AbstractSet[str], bodies: AbstractSet[str]
) -> FigureHints:
    """The hints in the `[figure]` table of the template `where`.

    Raises TemplateError with all faults of the table at once.

    >>> read_hints({"axes": True}, "a.toml", {"O"}, {"OA"}).axes
    True
    """
    reader = _Reader(f"{where}: figure", frozenset(points), frozenset(bodies) | {GROUND})
    hints = FigureHints()
    for key, value in table.items():
        hints = reader.merge(hints, key, value)
    if reader.faults:
        raise TemplateError(*reader.faults)
    return hints


class _Reader:
    """Reads the entries of one table and gathers what is wrong with them."""

    def __init__(self, where: str, points: frozenset[str], bodies: frozenset[str]) -> None:
        self.where = where
        self.points = points
        self.bodies = bodies
        self.faults: list[str] = []

    def merge(self, hints: FigureHints, key: str, value: object) -> FigureHints:
        """The hints with one more entry of the table."""
        readers = {
            "lengths": self.length,
            "angles": self.angle,
            "radii": self.radius,
            "circles": self.circle,
            "arrows": self.arrow,
        }
        if key in readers:
            rows = enumerate(self.rows(key, value), start=1)
            entries = tuple(readers[key](row, f"{key}[{number}]") for number, row in rows)
            return replace(hints, **cast(dict[str, Any], {key: entries}))
        if key == "lines":
            return replace(hints, lines=self.lines(value))
        if key == "labels":
            return replace(hints, labels=self.labels(value))
        if key == "shapes":
            return replace(hints, shapes=self.shapes(value))
        if key == "axes" and isinstance(value, bool):
            return replace(hints, axes=value)
        known = (*readers, "lines", "labels", "shapes", "axes")
        problem = (
            "expected true or false"
            if key == "axes"
            else f"unknown entry; {did_you_mean(key, known)}"
        )
        self.fault(key, problem)
        return hints

    def fault(self, place: str, problem: str) -> None:
        self.faults.append(f"{self.where}.{place}: {problem}")

    def rows(self, key: str, value: object) -> list[dict[str, Any]]:
        if isinstance(value, list) and all(isinstance(row, dict) for row in value):
            return value
        self.fault(key, 'expected a list of tables; write [{ symbol = "r", ... }]')
        return []

    def length(self, row: dict[str, Any], place: str) -> Length:
        self.keys(row, place, ("symbol", "from", "to"), ("along",))
        start, end = self.point(row, place, "from"), self.point(row, place, "to")
        along = self.choice(row, place, "along", ("horizontal", "vertical"))
        return Length(self.symbol(row, place), start, end, along)

    def angle(self, row: dict[str, Any], place: str) -> Angle:
        self.keys(row, place, ("symbol", "at", "from", "to"), ("sense",))
        start, end = (
            self.name(row, place, key, self.points | set(SIDES), "point or side")
            for key in ("from", "to")
        )
        sense = cast(Sense | None, self.choice(row, place, "sense", SENSES))
        return Angle(self.symbol(row, place), self.point(row, place, "at"), start, end, sense)

    def radius(self, row: dict[str, Any], place: str) -> Radius:
        self.keys(row, place, ("symbol", "centre"), ("of", "through"))
        of = self.name(row, place, "of", self.bodies, "body") if "of" in row else None
        through = self.point(row, place, "through") if "through" in row else None
        return Radius(self.symbol(row, place), self.point(row, place, "centre"), of, through)

    def circle(self, row: dict[str, Any], place: str) -> Rimmed:
        self.keys(row, place, ("body", "centre", "through"), ())
        centre, through = (self.point(row, place, key) for key in ("centre", "through"))
        if centre and centre == through:
            self.fault(
                place, f"a circle about {centre!r} through itself; name another point for 'through'"
            )
        return Rimmed(self.name(row, place, "body", self.bodies, "body"), centre, through)

    def arrow(self, row: dict[str, Any], place: str) -> Turning | Moving:
        if "moves" in row:
            self.keys(row, place, ("symbol", "moves"), ("along",))
            choices = self.points | set(SIDES)
            along = (
                self.name(row, place, "along", choices, "point or side") if "along" in row else None
            )
            return Moving(self.symbol(row, place), self.point(row, place, "moves"), along)
        self.keys(row, place, ("symbol", "turns"), ("sense",))
        sense = cast(Sense | None, self.choice(row, place, "sense", SENSES))
        return Turning(
            self.symbol(row, place),
            self.name(row, place, "turns", self.bodies - {GROUND}, "body"),
            sense,
        )

    def lines(self, value: object) -> tuple[tuple[str, str], ...]:
        rows: list[Any] = value if isinstance(value, list) else [None]
        for number, row in enumerate(rows, start=1):
            if not isinstance(row, list) or len(row) != 2 or row[0] == row[1]:
                self.fault(f"lines[{number}]", 'expected two points; write lines = [["O", "B"]]')
                return ()
            for name in row:
                if name not in self.points:
                    self.fault(
                        f"lines[{number}]",
                        f"no point {name!r}; {did_you_mean(str(name), self.points)}",
                    )
        return tuple((str(start), str(end)) for start, end in rows)

    def labels(self, value: object) -> Mapping[str, str | None]:
        found: dict[str, str | None] = {}
        for name, text in self.pairs("labels", value, self.points | self.bodies):
            problem = None if text is False or text == "" else symbol_fault(text)
            if problem:
                self.fault(f"labels.{name}", problem)
            found[name] = text if text and problem is None else None
        return found

    def shapes(self, value: object) -> Mapping[str, Shape]:
        found: dict[str, Shape] = {}
        for name, shape in self.pairs("shapes", value, self.bodies):
            if shape in SHAPES:
                found[name] = cast(Shape, shape)
            else:
                self.fault(
                    f"shapes.{name}", f"no shape {shape!r}; {did_you_mean(str(shape), SHAPES)}"
                )
        return found

    def pairs(self, key: str, value: object, names: AbstractSet[str]) -> list[tuple[str, Any]]:
        if not isinstance(value, dict):
            self.fault(key, "expected a table of names and values; write { O = 'O_1' }")
            return []
        for name in sorted(set(value) - names):
            self.fault(f"{key}.{name}", f"nothing has this name; {did_you_mean(name, names)}")
        return [(name, entry) for name, entry in value.items() if name in names]

    def keys(
        self, row: dict[str, Any], place: str, needed: tuple[str, ...], allowed: tuple[str, ...]
    ) -> None:
        for key in sorted(set(row) - set(needed) - set(allowed)):
            self.fault(place, f"unknown entry {key!r}; {did_you_mean(key, needed + allowed)}")
        for key in needed:
            if key not in row:
                self.fault(place, f"{key!r} is missing; needed here: {', '.join(needed)}")

    def symbol(self, row: dict[str, Any], place: str) -> str:
        problem = symbol_fault(row["symbol"]) if "symbol" in row else None
        if problem:
            self.fault(f"{place}.symbol", problem)
        return str(row.get("symbol", ""))

    def point(self, row: dict[str, Any], place: str, key: str) -> str:
        return self.name(row, place, key, self.points, "point")

    def name(
        self, row: dict[str, Any], place: str, key: str, names: AbstractSet[str], kind: str
    ) -> str:
        name = row.get(key, "")
        if key in row and name not in names:
            self.fault(f"{place}.{key}", f"no {kind} {name!r}; {did_you_mean(str(name), names)}")
        return str(name)

    def choice(
        self, row: dict[str, Any], place: str, key: str, choices: tuple[str, ...]
    ) -> str | None:
        return self.name(row, place, key, frozenset(choices), "choice") if key in row else None
