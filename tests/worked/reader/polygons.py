"""Polygons of vectors as a reader sees them, from their drawing alone: arrows laid tip to tail from
a common origin to a common end, each as long as the page says of the vector that its label names.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from math import hypot
from typing import Literal

from kinegrade.figure.scene import BOLD, THIN, Disc, Label, Outline, Scene, Strokes
from kinegrade.language.math.reading import read_math
from kinegrade.mechanics.vector import Vector
from kinegrade.worked.document import Block, Picture, Pictures
from tests.worked.reader.amounts import Amount
from tests.worked.reader.formula_reader import name_magnitude, name_symbol, read_unit

_APART = 0.05  # millimetres within which two corners coincide
_TORN = 0.01  # millimetres from the start of an arrow to the tip that it follows, at most
_ROUNDED = 0.005  # of a length, what four digits leave open
_CORNER = re.compile(r"[a-z]'*(_\{\d+\})?'*")  # the small letter of a corner
_COMPONENT = re.compile(r"\^\{\\mathrm\{[nt]\}\}|,[xy]")
_FRAME = re.compile(r"\\mathrm\{e\}|'")  # leads to the moving frame's point
_RELATIVE = re.compile(r"\\mathrm\{(r|Cor)\}")  # both lead from the moving frame's point
_ROTATION = re.compile(r"_\{[A-Z]('|_\{\d+\})*[A-Z]")  # of a point about a base
_BEHIND_SCALE = re.compile(r"\s*[(（;；]")
_BETWEEN = 2.0  # millimetres by which a symbol longer than its arrow may be nearer to another
_LEAVES = 0.4  # millimetres from a label to the leader that leaves it
_UNDRAWN = 0.01  # of the longest vector: shorter ones are not drawn
_FORMULA = re.compile(r"\$[^$]*\$")
_ORIGIN = 0.4  # millimetres, radius of the dot at the origin
_WIDTH = 0.4  # millimetres: a vector no longer than a line is wide is not drawn either


@dataclass(frozen=True)
class PolygonFault:
    """What is wrong with a polygon, and where."""

    law: Literal["closed", "label", "corner"]
    line: str


@dataclass(frozen=True)
class _Arrow:
    """An arrow as it is drawn: from where to where, and its `lines`, those of its head as well."""

    start: Vector
    tip: Vector
    lines: tuple[tuple[Vector, Vector], ...]

    @property
    def length(self) -> float:
        return hypot(*(self.tip - self.start))


@dataclass(frozen=True)
class _Sizes:
    """What the symbols of a page are worth, millimetres on paper for one of SI, and how far an
    arrow may lead past vectors that are not drawn.
    """

    amounts: Mapping[str, Amount]
    scale: float
    undrawn: float

    def find(self, symbol: str) -> list[float]:
        """How long the arrow of a symbol is: as its magnitude says, and as it does itself."""
        row = read_math(symbol, "")
        told = (self.amounts.get(name) for name in (name_magnitude(row), name_symbol(row)))
        return [abs(amount.value) * self.scale for amount in told if amount is not None]


def judge_polygons(
    blocks: Iterable[Block], amounts: Mapping[str, Amount]
) -> Iterator[PolygonFault]:
    """The faults of all polygons of a page, on which symbols are worth those `amounts`."""
    for block in blocks:
        for picture in block.pictures if isinstance(block, Pictures) else ():
            origin = _find_origin(picture.scene)
            if origin is not None:
                arrows = tuple(_read_arrows(picture.scene))
                yield from _judge_chains(origin, arrows, picture.caption)
                yield from _judge_corners(origin, arrows, picture)
                scale = picture.scene.scale / _read_scale_unit(picture.caption)
                sizes = _Sizes(amounts, scale, _measure_undrawn(picture.caption, arrows))
                yield from _judge_labels(picture.scene, sizes, arrows)


def _measure_undrawn(caption: str, arrows: Iterable[_Arrow]) -> float:
    """Millimetres that the vectors named as too short to draw have together at most: an arrow next
    to them leads past them.
    """
    longest = max((arrow.length for arrow in arrows), default=0.0)
    return max(_UNDRAWN * longest, _WIDTH) * len(_FORMULA.findall(caption))


def _read_scale_unit(caption: str) -> float:
    """What the unit at the end of a caption is in SI: "1 mm corresponds to 2 cm/s", before
    arrows drawn as outlines and vectors that are too short to draw.
    """
    scale = _BEHIND_SCALE.split(caption)[0]
    return read_unit(scale.rsplit(maxsplit=1)[-1].replace("²", "^2")).value


def _find_origin(scene: Scene) -> Vector | None:
    """The dot from which both sides start; None for a picture of something else."""
    discs = [part for part in scene.primitives if isinstance(part, Disc)]
    drawn = [part.pen.width for part in scene.primitives if isinstance(part, Strokes)]
    bold = any(width >= BOLD.width for width in drawn)
    if bold or [disc.radius for disc in discs] != [_ORIGIN]:
        return None
    return discs[0].centre


def _read_arrows(scene: Scene) -> Iterator[_Arrow]:
    """A head of three corners, the tip first, ends the line before it; an outline of seven goes
    from one side of its start over its tip in the middle to the other side.
    """
    start = Vector(0.0, 0.0)
    for part in scene.primitives:
        match part:
            case Strokes(lines=((start, _),)):
                pass
            case Outline(corners=(tip, one, other)):
                yield _Arrow(start, tip, ((start, tip), (tip, one), (tip, other)))
            case Outline(corners=(left, _, _, tip, _, _, right) as corners):
                yield _Arrow((left + right) / 2, tip, tuple(pairwise(corners)))


def _judge_chains(
    origin: Vector, arrows: tuple[_Arrow, ...], caption: str
) -> Iterator[PolygonFault]:
    """Each arrow starts at the origin or at a tip; those after which none starts end together."""
    tails = [arrow.start for arrow in arrows]
    tips = [arrow.tip for arrow in arrows]
    for tail in tails:
        if not any(hypot(*(tail - place)) < _TORN for place in (origin, *tips)):
            yield PolygonFault("closed", f"{caption}: an arrow starts nowhere")
    last = [tip for tip in tips if not any(_meet(tip, tail) for tail in tails)]
    ending = [*last, *(tip for tip in tips if last and _meet(tip, last[0]))]
    if any(not _meet(tip, last[0]) for tip in last):
        yield PolygonFault("closed", f"{caption}: the sides end apart")
    if last and len(ending) == 2:
        yield PolygonFault("closed", f"{caption}: one side alone ends at the end")


def _meet(one: Vector, other: Vector) -> bool:
    return hypot(*(one - other)) <= _APART


def _judge_corners(
    origin: Vector, arrows: tuple[_Arrow, ...], picture: Picture
) -> Iterator[PolygonFault]:
    """The origin and the corners at which a vector of a point ends have letters: as many as there
    are vectors, each of its components together, unless corners coincide.
    """
    corners = [origin]
    for arrow in arrows:
        if not any(_meet(arrow.tip, corner) for corner in corners):
            corners.append(arrow.tip)
    named = list(_name_arrows(picture.scene, arrows))
    vectors = {_name_whole(symbol) for symbol, _ in named} - set(_find_early(named, origin))
    letters = sum(bool(_CORNER.fullmatch(label.symbol)) for label in picture.scene.labels)
    wanted = min(len(corners), len(vectors))
    if letters < wanted:
        yield PolygonFault("corner", f"{picture.caption}: {letters} letters for {wanted} points")


def _name_arrows(scene: Scene, arrows: tuple[_Arrow, ...]) -> Iterator[tuple[str, _Arrow]]:
    """Each symbol with the arrow that it stands at."""
    for label in scene.labels:
        if not _CORNER.fullmatch(label.symbol):
            at = _follow_leader(label, arrows, scene)
            yield label.symbol, min(at, key=partial(_measure_gap, label))


def _name_whole(symbol: str) -> str:
    """The symbol of a vector without what tells its components; those from the point of a moving
    frame to the point itself together.
    """
    return _RELATIVE.sub("r", _COMPONENT.sub("", symbol))


def _find_early(named: Sequence[tuple[str, _Arrow]], origin: Vector) -> Iterator[str]:
    """The relative vectors that do not follow that of the moving frame, or are followed by a part
    of it, and those of a rotation drawn before that of the base point: none of their corners is the
    frame's point, or the base.
    """
    for symbol, arrow in named:
        if _ROTATION.search(symbol) and _meet(arrow.start, origin):
            yield _name_whole(symbol)
    relative: dict[str, list[_Arrow]] = {}
    for symbol, arrow in named:
        if _RELATIVE.search(symbol):
            relative.setdefault(_name_whole(symbol), []).append(arrow)
    frame = [(symbol, arrow) for symbol, arrow in named if _FRAME.search(symbol)]
    for whole, parts in relative.items():
        own = whole.replace("_{r", r"_{\mathrm{e}").removesuffix("}")
        follows = any(_meet(part.start, one.tip) for part in parts for _, one in frame)
        parted = any(
            own in symbol and _meet(part.tip, one.start) for part in parts for symbol, one in frame
        )
        if not follows or parted:
            yield whole


def _judge_labels(
    scene: Scene, sizes: _Sizes, arrows: tuple[_Arrow, ...]
) -> Iterator[PolygonFault]:
    """The arrow nearest to a label is as long as the vector that the label names."""
    for label in scene.primitives:
        if not isinstance(label, Label) or _CORNER.fullmatch(label.symbol):
            continue
        told_sizes = sizes.find(label.symbol)
        named = _follow_leader(label, arrows, scene)
        if told_sizes and named and not _stands_well(label, named, told_sizes, sizes.undrawn):
            told = " or ".join(f"{size:.2f} mm" for size in told_sizes)
            yield PolygonFault("label", f"{label.symbol} is not beside an arrow of {told}")


def _follow_leader(label: Label, arrows: tuple[_Arrow, ...], scene: Scene) -> tuple[_Arrow, ...]:
    """The arrows to which a thin line leads from a label; all of them where none leaves it."""
    for part in scene.primitives:
        match part:
            case Strokes(lines=((start, end),)) if part.pen == THIN:
                if _measure_line(label, start, start) < _LEAVES:
                    dot = Label("", end, 0.0, 0.0)
                    least = min(_measure_gap(dot, arrow) for arrow in arrows)
                    near = least + _APART  # of an outline, whose edge is beside its middle
                    return tuple(arrow for arrow in arrows if _measure_gap(dot, arrow) <= near)
    return arrows


def _stands_well(
    label: Label, arrows: tuple[_Arrow, ...], sizes: Sequence[float], undrawn: float
) -> bool:
    """Whether no arrow is nearer to a label than one of such a length; a label that is longer than
    its arrow may be about as near to another.
    """
    least = min(_measure_gap(label, arrow) for arrow in arrows)
    for arrow in arrows:
        room = _APART + _ROUNDED * arrow.length + undrawn
        if any(abs(arrow.length - size) <= room for size in sizes):
            slack = _BETWEEN if arrow.length < max(label.width, label.height) else _APART
            if _measure_gap(label, arrow) <= least + slack:
                return True
    return False


def _measure_gap(label: Label, arrow: _Arrow) -> float:
    """Millimetres of paper between a label and an arrow, its shaft or its head."""
    return min(_measure_line(label, *line) for line in arrow.lines)


def _measure_line(label: Label, start: Vector, end: Vector) -> float:
    """Millimetres of paper between a label and a line."""
    points = [start + (end - start) * (place / 40) for place in range(41)]
    return min(
        hypot(
            max(abs(point.x - label.centre.x) - label.width / 2, 0.0),
            max(abs(point.y - label.centre.y) - label.height / 2, 0.0),
        )
        for point in points
    )
