"""What printed equations are worth: each side from its LaTeX alone, its symbols by what was printed
for them before, with the room that rounded numbers leave.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import permutations
from math import floor, hypot, log10

from kinegrade.problem.solving import Solution
from kinegrade.worked.document import Block, Prose
from tests.worked.chains import chains
from tests.worked.latex_value import Unreadable, value_of

DIGITS = 4
UNIT = re.compile(r"\\,\\unit\{([^}]+)\}")
ASIDE = re.compile(r",?\\quad.*|,\\quad.*")
PREFIX = {"cm": 0.01, "mm": 0.001}
NUMBER = re.compile(r"(?<![\w.])(\d+(?:\.\d+)?)(\^\\circ)?")


@dataclass(frozen=True)
class Rounded:
    """A value and how far from it the number may be that was rounded to it."""

    value: float
    room: float = 0.0


def room_of(digits: str, degrees: bool) -> float:
    """Half a unit of the last place to which a number is rounded; short whole numbers are exact."""
    if "." not in digits and len(digits) < DIGITS:
        return 0.0
    if degrees:
        return 0.005
    return 0.5 * 10.0 ** (floor(log10(float(digits) or 1)) - DIGITS + 1)


def worth(part: str, known: Mapping[str, Rounded]) -> Rounded:
    """The value of a part in SI; raises Unreadable where a symbol is unknown."""
    unit = UNIT.search(part)
    factor = PREFIX.get(re.split(r"/|\^", unit[1])[0], 1.0) if unit else 1.0
    text = UNIT.sub("", ASIDE.sub("", part))
    text, names = _name_symbols(text, known)
    held = {symbol: value.value for symbol, value in names.items()}
    value = value_of(text, held)
    moved = [held | {symbol: one.value + one.room} for symbol, one in names.items()]
    room = sum(abs(value_of(text, values) - value) for values in moved)
    room += sum(abs(value_of(changed, held) - value) for changed in _move_numbers(text))
    return Rounded(value * factor, room * factor)


def _name_symbols(text: str, known: Mapping[str, Rounded]) -> tuple[str, dict[str, Rounded]]:
    """The text with q_{0}, q_{1}, ... in place of its known symbols, and what these are worth."""
    names: dict[str, Rounded] = {}
    for place, symbol in enumerate(sorted(known, key=len, reverse=True)):
        before = "" if symbol.startswith("\\") else r"(?<![A-Za-z\\{,])"
        pattern = before + re.escape(symbol) + r"(?![A-Za-z_'(,}]|\^\{\\mathrm)"
        name = f"q_{{{place}}}"
        text, count = re.subn(pattern, name, text)
        if count:
            names[name] = known[symbol]
    return text, names


def _move_numbers(text: str) -> Iterator[str]:
    """The text with one of its rounded numbers moved as far as rounding may have moved it."""
    for number in NUMBER.finditer(text):
        change = room_of(number[1], bool(number[2]))
        if change:
            moved = f"{float(number[1]) + change:.12f}"
            yield text[: number.start(1)] + moved + text[number.end(1) :]


def given_symbols(solution: Solution) -> dict[str, Rounded]:
    """The symbols of the statement, and the distances of points, in SI."""
    letters = {name: re.sub(r"(\d+)$", r"_{\1}", name) for name in solution.motion.points}
    places = {name: (float(at.x), float(at.y)) for name, at in solution.motion.points.items()}
    distances = {
        letters[one] + letters[other]: Rounded(
            hypot(places[one][0] - places[other][0], places[one][1] - places[other][1])
        )
        for one, other in permutations(places, 2)
    }
    parameters = {
        solution.template.parameters[name].symbol: Rounded(
            quantity.value * float(quantity.measure.factor)
        )
        for name, quantity in solution.parameters.items()
        if not quantity.measure.degrees
    }
    return distances | parameters


def compared(
    blocks: Iterable[Block], solution: Solution
) -> Iterator[tuple[str, str, Rounded, Rounded]]:
    """Every printed part that has a value, beside the end of its equation: the equation, the part,
    both values. Where prose says what is relative to what, relative vectors are new ones.
    """
    known = given_symbols(solution)
    for block in blocks:
        if isinstance(block, Prose) and r"_{\mathrm{r}}" in block.text:
            known = {symbol: value for symbol, value in known.items() if "mathrm" not in symbol}
        for left, parts in chains([block]):
            values = list(_find_values(parts, known))
            for part, value in values[:-1]:
                yield f"{left} = {' = '.join(parts)}", part, value, values[-1][1]
            if values and values[-1][0] == parts[-1]:
                known[left] = values[-1][1]


def _find_values(
    parts: Iterable[str], known: Mapping[str, Rounded]
) -> Iterator[tuple[str, Rounded]]:
    """The parts that have a value."""
    for part in parts:
        try:
            yield part, worth(part, known)
        except Unreadable:
            continue
