"""What a figure has to mark of what is given: an arrow for each rate that an input imposes, and of
the author's marks those whose letters are printed.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence, Set
from dataclasses import replace
from math import radians
from typing import assert_never

from kinegrade.expressions.reading import read_expression
from kinegrade.expressions.tree import Expression, Name, find_names
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Number as Digits
from kinegrade.language.math.tree import Row
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.template.domain import find_doubles
from kinegrade.problem.template.hints import Axes, FigureHints, Moving, Turning
from kinegrade.problem.template.sentences import DriverSentence
from kinegrade.problem.template.template import Parameter, Template
from kinegrade.problem.template.texts import find_unsigned_givens
from kinegrade.sign_conventions import ALONG_AXES

_HALF_TURN = 180
_X_AXIS = "$x$"  # as a statement names the axis from which an angle is measured


def mark_givens(
    template: Template, printed: Set[str] | None = None, asked: Collection[str] | None = None
) -> FigureHints:
    """What the figure of a template shows when the parameters `printed` (all: None) are given and
    the quantities `asked` (those with points: None) are asked.

    An input whose rate is a parameter, or its negative, has an arrow with the parameter's symbol; a
    hint of the author replaces it. An arrow follows the input, so it has the sense of each
    instance. A measure whose letters are all of parameters that are not printed is left out. Axes
    stand where they are needed. A length whose side the statement says in words is no coordinate.
    """
    hidden = _list_hidden_symbols(template, printed)
    author = template.figure
    arrows = _list_arrows(template)
    signed = {_read(given.symbol) for given in template.parameters.values() if given.has_sign}
    coordinates = {_read(template.parameters[name].symbol) for name in _list_coordinates(template)}
    return replace(
        author,
        lengths=tuple(
            replace(mark, signed=_read(mark.symbol) in coordinates)
            for mark in author.lengths
            if _is_printed(mark.symbol, hidden)
        ),
        angles=tuple(
            replace(
                mark, signed=_read(mark.symbol) in signed, least=_find_least(template, mark.symbol)
            )
            for mark in author.angles
            if _is_printed(mark.symbol, hidden)
        ),
        radii=tuple(mark for mark in author.radii if _is_printed(mark.symbol, hidden)),
        arrows=tuple(arrow for arrow in arrows if _is_printed(arrow.symbol, hidden)),
        axes=_place_axes(template, printed, template.asked() if asked is None else asked),
    )


def _place_axes(
    template: Template, printed: Set[str] | None, asked: Collection[str]
) -> Axes | None:
    """At the origin for coordinates that are given or asked and where the author wants them, aside
    for components of vectors and where the statement names the x axis.
    """
    along_axes = [ask for name in asked if (ask := template.asks[name]).sign in ALONG_AXES]
    if any(ask.unit.is_length for ask in along_axes) or any(
        printed is None or name in printed for name in _list_coordinates(template)
    ):
        return "origin"
    named = any(_X_AXIS in text for text in template.words.statement.texts)
    return template.figure.axes or ("aside" if along_axes or named else None)


def _list_coordinates(template: Template) -> list[str]:
    """The given lengths that are printed with their sign."""
    unsigned = find_unsigned_givens(template)
    given = template.parameters.items()
    return [name for name, x in given if x.unit.is_length and x.has_sign and name not in unsigned]


def _list_hidden_symbols(template: Template, printed: Set[str] | None) -> Set[Row]:
    if printed is None:
        return frozenset()
    symbols = {name: _read(given.symbol) for name, given in template.parameters.items()}
    return set(symbols.values()) - {symbols[name] for name in printed}


def _is_printed(symbol: str, hidden: Set[Row]) -> bool:
    """Whether a symbol is given, or some letter of a product like `2 k r` is."""
    row = _read(symbol)
    letters = {(node,) for node in row if not isinstance(node, Digits)}
    return row not in hidden and not (hidden and letters <= hidden)


def _find_least(template: Template, symbol: str) -> float | None:
    """The least value drawn, in radians, of a given angle of that symbol that statements print with
    its sign and some values of which are beyond half a turn.
    """
    for name, given in template.parameters.items():
        if given.unit.degrees and _read(given.symbol) == _read(symbol):
            values = find_doubles(given.choices)
            if max(map(abs, values)) > _HALF_TURN and name not in find_unsigned_givens(template):
                return radians(min(values))
    return None


def _read(symbol: str) -> Row:
    return read_math(symbol, "figure")


def _list_arrows(template: Template) -> Iterator[Turning | Moving]:
    """The arrows of the inputs, each with the symbol of the author's hint where there is one, then
    the author's other arrows.
    """
    imposed = [
        _make_arrow(_name_rate(rate, template.parameters), sentence, level, number)
        for number, sentence in enumerate(template.scheme.drivers)
        for level, rate in _list_rates(sentence)
    ]
    hints, others = _match_hints(imposed, template.figure.arrows)
    for number, arrow in enumerate(imposed):
        symbol = hints.get(number, arrow).symbol
        if symbol:
            yield replace(arrow, symbol=symbol)
    yield from others


def _match_hints(
    imposed: Sequence[Turning | Moving], hints: Sequence[Turning | Moving]
) -> tuple[dict[int, Turning | Moving], list[Turning | Moving]]:
    """The hint for each arrow of an input by its number, and the hints for none: of several inputs
    that move one point a hint belongs to that whose symbol it has, any other to the first without.
    """
    found: dict[int, Turning | Moving] = {}
    left = list(hints)
    for by_symbol in (True, False):
        for number, arrow in enumerate(imposed):
            if number in found:
                continue
            fitting = (
                hint
                for hint in left
                if _identify(hint) == _identify(arrow)
                and (not by_symbol or _read(hint.symbol) == _read(arrow.symbol))
            )
            hint = next(fitting, None)
            if hint is not None:
                found[number] = hint
                left.remove(hint)
    return found, left


def _identify(arrow: Turning | Moving) -> tuple[str, Level]:
    """What an arrow is about: bodies and points never share a name."""
    match arrow:
        case Turning(body=name) | Moving(point=name):
            return name, arrow.level
        case _:
            assert_never(arrow)


def _list_rates(sentence: DriverSentence) -> tuple[tuple[Level, Expression], ...]:
    return ("velocity", sentence.velocity), ("acceleration", sentence.acceleration)


def _name_rate(rate: Expression, parameters: Mapping[str, Parameter]) -> str:
    """The symbol of a rate that is a parameter or its negative; empty for any other."""
    for name in find_names(rate):
        if name in parameters and rate in (Name(name), read_expression(f"-{name}")):
            return parameters[name].symbol
    return ""


def _make_arrow(
    symbol: str, sentence: DriverSentence, level: Level, driver: int
) -> Turning | Moving:
    if sentence.stated.TURNS:
        return Turning(symbol, sentence.body, None, level, sentence.of)
    return Moving(symbol, sentence.point, None, level, driver)
