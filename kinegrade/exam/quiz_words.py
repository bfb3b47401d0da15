"""The fixed words of a quiz on screen: what a figure is called, and when an answer is right."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction

from kinegrade.exam.rules import EXCEPTION, FEWEST_DIGITS, write_marking_rule
from kinegrade.language import Language
from kinegrade.problem.tolerance import Tolerance

FIGURE = {"en": "Figure to scale: {}", "zh": "附图（按比例绘制）：{}"}
BETWEEN = {"en": " ", "zh": ""}


def count_digits_to_type(tolerances: Iterable[Tolerance]) -> int:
    """The fewest significant digits with which every answer can be judged right or wrong."""
    return max(FEWEST_DIGITS, *(tolerance.carried(Fraction(0)) for tolerance in tolerances))


@dataclass(frozen=True)
class AskRule:
    """How far from right an ask's answer may be, and the unit in which that is stated: a quiz has
    no table of units.
    """

    tolerance: Tolerance
    unit: str

    def text(self, language: Language) -> str:
        """When the answer is right."""
        return write_marking_rule(self.tolerance, language, self.unit)


def write_marking_rules(asks: Mapping[str, AskRule], language: Language) -> str:
    """When the answers of a question are right; `asks` holds the rules by symbol (math)."""
    texts = {symbol: rule.text(language) for symbol, rule in asks.items()}
    distinct = set(texts.values())
    if len(distinct) == 1:
        return distinct.pop()
    return BETWEEN[language].join(
        EXCEPTION[language].format(what=f"${symbol}$", rule=rule[0].lower() + rule[1:])
        for symbol, rule in texts.items()
    )
