"""The fixed words of a quiz on screen: how answers are typed, and when one is right."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from kinegrade.exam.quiz_document import Language
from kinegrade.exam.rules import EXCEPTION, FEWEST_DIGITS, NUMERALS, marking_rule
from kinegrade.problem.tolerance import Tolerance

FIGURE = {"en": "Figure to scale: {}", "zh": "附图（按比例绘制）：{}"}
TYPING = {
    "en": "Type plain numbers with a decimal point, in the unit beside the box and with at least {} significant "
    "digits: -0.8660 or 1.25e-3.",
    "zh": "填写一个数，单位见输入框旁，小数点用半角句点，至少保留{}位有效数字，如 -0.8660 或 1.25e-3。",
}
BETWEEN = {"en": " ", "zh": ""}


def answer_rules(tolerances: Mapping[str, Tolerance], language: Language) -> str:
    """How to type the answers of a question, and when one is right; tolerances go by the asks' symbols (math)."""
    digits = max(
        FEWEST_DIGITS, *(tolerance.carried(Fraction(0)) for tolerance in tolerances.values())
    )
    numerals = NUMERALS[language][digits - FEWEST_DIGITS :]
    typing = TYPING[language].format(numerals[0] if numerals else digits)
    return BETWEEN[language].join((typing, *_marking(tolerances, language)))


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
