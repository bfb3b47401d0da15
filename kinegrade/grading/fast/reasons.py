"""The fast twin of the reasons of `judging.judge.judge` and `judging.decision.decide`: the same
words in a language, filled in with many numbers in a single step.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from itertools import chain

from kinegrade.files.csv_writing import neutralise, write_csv_cell
from kinegrade.grading.fast.bounds import Numbers
from kinegrade.grading.fast.number_texts import write_numbers
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

    def fill(self, numbers: Sequence[Numbers]) -> list[str]:
        """A text for each row of these five columns of numbers."""
        columns = [write_numbers(numbers[number]) for number in self.order]
        texts = f"{self.text}\n".encode() * len(columns[0])
        filled = texts % tuple(chain.from_iterable(zip(*columns, strict=True)))
        return filled.decode("utf-8").split("\n")[:-1]


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


@cache
def read_cells(language: Language, *, by_policy: bool) -> Forms:
    """The same reasons as cells of a CSV file; numbers need no quotation marks."""
    forms = read_reasons(language, by_policy=by_policy)
    return Forms(_make_cell(forms.within), _make_cell(forms.to_figures))


@cache
def surround_comparison(mistakes: tuple[str, ...], language: Language) -> tuple[str, str]:
    """What stands before and behind the comparison in the reason of an answer that these mistakes
    lead to.
    """
    text = open_catalogue(language).write(explain_mistakes(mistakes, _VALUE))
    before, _, after = text.partition(_VALUE)
    return before, after


def _make_form(message: Message, language: Language) -> Form:
    text = open_catalogue(language).write(message)
    order = tuple(int(number) for number in _HOLE.findall(text))
    return Form(_HOLE.sub("%s", text.replace("%", "%%")), order)


def _make_cell(form: Form) -> Form:
    return Form(write_csv_cell(neutralise(form.text)), form.order)
