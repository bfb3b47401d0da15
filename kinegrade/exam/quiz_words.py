"""The fixed words of a quiz on screen: what a figure is called, and when an answer is right."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from kinegrade.exam.rules import EXCEPTION, FEWEST_DIGITS, marking_rule
from kinegrade.language import Language
from kinegrade.problem.tolerance import Tolerance

FIGURE = {"en": "Figure to scale: {}", "zh": "附图（按比例绘制）：{}"}
BETWEEN = {"en": " ", "zh": ""}


def digits_to_type(tolerances: Mapping[str, Tolerance]) -> int:
    """The fewest significant digits with which every answer can be told right from wrong."""
    return max(
        FEWEST_DIGITS, *(tolerance.carried(Fraction(0)) for tolerance in tolerances.values())
    )


def marking_rules(tolerances: Mapping[str, Tolerance], language: Language) -> str:
    """When the answers of a question are right; tolerances go by the asks' symbols (math)."""
    return BETWEEN[language].join(_marking(tolerances, language))


def _marking(tolerances: Mapping[str, Tolerance], language: Language) -> list[str]:
    """One rule for all asks, or one for each."""
    distinct = set(tolerances.values())
    if len(distinct) == 1:
        return [marking_rule(distinct.pop(), language)]
    rules = {symbol: marking_rule(tolerance, language) for symbol, tolerance in tolerances.items()}
    return [
        EXCEPTION[language].format(what=f"${symbol}$", rule=rule[0].lower() + rule[1:])
        for symbol, rule in rules.items()
    ]
