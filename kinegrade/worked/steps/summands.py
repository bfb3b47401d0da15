"""Components of vectors as sums: in symbols, in numbers, with their value."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

from kinegrade.mechanics.relations import add_vectors
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.formulas.numbers import write_bracketed, write_number, write_short
from kinegrade.worked.steps.deductions import UNITS

NUMBER = re.compile(r"-?[0-9.]+")


@dataclass(frozen=True)
class Summand:
    """A summand with its sign, in symbols and in numbers."""

    sign: str
    symbol: str
    number: str

    @property
    def counts(self) -> bool:
        """Whether none of its factors is zero."""
        return not any(factor.strip("(){}") == "0" for factor in self.number.split(r"\cdot "))


def write_sum(summands: Sequence[Summand], what: Literal["symbol", "number"]) -> str:
    """Summands written one after the other, the first without a plus sign; 0 where there are
    none.
    """
    text = " ".join(f"{one.sign} {getattr(one, what)}" for one in summands)
    return text[2:] if text.startswith("+") else "-" + text[2:] if text else "0"


def write_component(name: str, axis: str) -> str:
    """The symbol of a component: v_{B} becomes v_{B,x}; a superscript stays."""
    head, _, rest = name.partition("_{")
    depth, end = 1, 0
    while depth:
        depth += {"{": 1, "}": -1}.get(rest[end], 0)
        end += 1
    return f"{head}_{{{rest[: end - 1]},{axis}}}{rest[end:]}"


def write_sum_line(
    axis: str,
    name: str,
    parts: list[tuple[str, Vector]],
    level: Level,
    sign: Literal["+", "-"] = "+",
) -> str:
    """One component of a sum of vectors, or of what remains of the first without the others."""
    along = 0 if axis == "x" else 1
    summands = [
        Summand(sign if place else "+", write_component(symbol, axis), write_short(value[along]))
        for place, (symbol, value) in enumerate(parts)
    ]
    summands[1:] = [replace(one, number=write_bracketed(one.number)) for one in summands[1:]]
    rest = add_vectors(value for _, value in parts[1:])[along]
    whole = {"+": parts[0][1][along] + rest, "-": parts[0][1][along] - rest}[sign]
    result = write_number(whole, UNITS[level, False])
    numbers = write_sum([one for one in summands if one.counts], "number")
    written = [] if NUMBER.fullmatch(numbers) else [numbers]
    return f"{write_component(name, axis)} &= " + " = ".join(
        [write_sum(summands, "symbol"), *written, result]
    )
