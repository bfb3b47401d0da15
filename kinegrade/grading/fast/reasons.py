"""The fast twin of the reasons of `judging.judge.judge` and `judging.decision.decide`: the same
words in a language, filled in with many numbers in a single step.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache

from kinegrade.grading.judging.decision import explain_mistakes
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message

_HOLE = re.compile("\x00([0-4])")
_VALUE, _DIFFERENCE, _ALLOWED, _LOW, _HIGH = (f"\x00{number}" for number in range(5))
_WITHIN = Message("marking.allowed", value=_VALUE, difference=_DIFFERENCE, allowed=_ALLOWED)
_TO_FIGURES = Message(
    "marking.to-figures", value=_VALUE, difference=_DIFFERENCE, low=_LOW, high=_HIGH
)


@dataclass(frozen=True, slots=True)
class Form:
    """A text for the % operator, and which number stands at each of its places: 0 for the right
    value, then the difference, what is allowed, the lowest and the highest right value.
    """

    text: str
    order: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Forms:
    """How an answer is compared with a value: within a tolerance, or to significant figures."""

    within: Form
    to_figures: Form


@cache
def read_comparisons(language: Language) -> Forms:
    """The comparisons alone, as reasons quote them."""
    return Forms(_make_form(_WITHIN, language), _make_form(_TO_FIGURES, language))


@cache
def read_reasons(language: Language, *, by_policy: bool) -> Forms:
    """The reasons of answers compared with the key, by the paper's rule or by the policy's."""
    within, to_figures = (
        Message("marking.key", comparison=comparison) for comparison in (_WITHIN, _TO_FIGURES)
    )
    if by_policy:
        within = Message("marking.by-policy", reason=within)
        to_figures = Message("marking.by-policy", reason=to_figures)
    return Forms(_make_form(within, language), _make_form(to_figures, language))


def write_mistakes(mistakes: tuple[str, ...], comparison: str, language: Language) -> str:
    """The reason of an answer that these mistakes lead to."""
    before, after = _surround_comparison(mistakes, language)
    return f"{before}{comparison}{after}"


@cache
def _surround_comparison(mistakes: tuple[str, ...], language: Language) -> tuple[str, str]:
    text = open_catalogue(language).write(explain_mistakes(mistakes, _VALUE))
    before, _, after = text.partition(_VALUE)
    return before, after


def _make_form(message: Message, language: Language) -> Form:
    text = open_catalogue(language).write(message)
    order = tuple(int(number) for number in _HOLE.findall(text))
    return Form(_HOLE.sub("%.6g", text.replace("%", "%%")), order)
