"""The key of tactile sheets: what each of their labels names, as plain text that a voice or a
Braille display reads.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import assert_never

from kinegrade.figure.marks.names import write_point_symbol
from kinegrade.figure.tactile.labels import (
    AngleName,
    AxesNames,
    BodyLabel,
    LengthName,
    MovingName,
    PointName,
    RadiusName,
    Subject,
    TurningName,
)
from kinegrade.figure.tactile.tactile import TactileFigure, TactileSheet
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.math.plain import write_plain_math
from kinegrade.language.message import Message
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.template.hints import FigureHints, Projection

Writer = Callable[[str], str]


def write_tactile_key(
    figure: TactileFigure,
    files: Sequence[str],
    write_cells: Writer,
    letters: Writer,
    language: Language,
) -> Iterator[str]:
    """Lines that say what the labels on each sheet name, and what no sheet has room for; `files`
    are the names of the sheets, `write_cells` writes a symbol in Braille, and `letters` gives that
    of a point by its name.
    """
    words = open_catalogue(language)
    for file, sheet in zip(files, figure.sheets, strict=True):
        yield words.write(_say_sheet(sheet, file))
        for named in sheet.named:
            for symbol, what in _say(named.subject, letters):
                cells = write_cells(symbol)
                yield words.text("tactile.label", cells=cells, symbol=_write(symbol), named=what)
    for named in figure.missing:
        for symbol, what in _say(named.subject, letters):
            yield words.write(Message("tactile.no-room", symbol=_write(symbol), named=what))
    if figure.missing_parts:
        yield words.write(Message("tactile.no-room-for-parts", count=figure.missing_parts))


def list_symbols(hints: FigureHints, points: Iterable[str]) -> Iterator[str]:
    """The symbols that the labels of a figure with these marks and points may have."""
    for given in (*hints.lengths, *hints.angles, *hints.radii, *hints.arrows):
        yield given.symbol
    for frame in hints.frames:
        yield from (frame.x, frame.y)
    yield from (symbol for symbol in hints.labels.values() if symbol)
    yield from map(write_point_symbol, points)
    yield from "xy"


def _say_sheet(sheet: TactileSheet, file: str) -> Message:
    if sheet.given:
        return Message("tactile.givens", file=file)
    return Message("tactile.parts", file=file)


def _write(symbol: str) -> str:
    return write_plain_math(symbol, "figure.labels")


def _say(subject: Subject, letters: Writer) -> Iterator[tuple[str, Message]]:
    """Each symbol of a label, and what it names."""
    match subject:
        case PointName(symbol):
            yield symbol, Message("tactile.point")
        case BodyLabel(_, symbol):
            yield symbol, Message("tactile.body")
        case AxesNames(x, y, frame):
            axis = Message("tactile.axis" if frame is None else "tactile.axis-of-body")
            yield from ((x, axis), (y, axis))
        case LengthName(symbol, start, end, along):
            yield symbol, _say_length(along, _write(letters(start)), _write(letters(end)))
        case AngleName(symbol, at):
            yield symbol, Message("tactile.angle", at=_write(letters(at)))
        case RadiusName(symbol, centre):
            yield symbol, Message("tactile.radius", centre=_write(letters(centre)))
        case TurningName(symbol, level):
            yield symbol, _say_turning(level)
        case MovingName(symbol, point, level):
            yield symbol, _say_moving(level, _write(letters(point)))
        case _:
            assert_never(subject)


def _say_length(along: Projection | None, start: str, end: str) -> Message:
    match along:
        case "horizontal":
            return Message("tactile.horizontal", start=start, end=end)
        case "vertical":
            return Message("tactile.vertical", start=start, end=end)
        case None:
            return Message("tactile.length", start=start, end=end)
        case _:
            assert_never(along)


def _say_turning(level: Level) -> Message:
    match level:
        case "velocity":
            return Message("tactile.turning-velocity")
        case "acceleration":
            return Message("tactile.turning-acceleration")
        case _:
            assert_never(level)


def _say_moving(level: Level, point: str) -> Message:
    match level:
        case "velocity":
            return Message("tactile.moving-velocity", point=point)
        case "acceleration":
            return Message("tactile.moving-acceleration", point=point)
        case _:
            assert_never(level)
