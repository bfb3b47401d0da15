"""The fast twin of the reasons of `judging.judge.judge` and `judging.decision.decide`: the same
words in a language, filled in with many numbers in a single step.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache, lru_cache
from itertools import chain
from typing import NamedTuple

from kinegrade.files.csv_writing import neutralise, write_csv_cell
from kinegrade.grading.fast.bounds import Numbers
from kinegrade.grading.fast.number_texts import write_numbers
from kinegrade.grading.judging.decision import explain_mistakes, name_mistakes
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message

_HOLE = re.compile("\x00([0-4])")
_VALUE, _DIFFERENCE, _ALLOWED, _LOW, _HIGH = (f"\x00{number}" for number in range(5))
_WITHIN = Message("marking.allowed", value=_VALUE, difference=_DIFFERENCE, allowed=_ALLOWED)
_TO_FIGURES = Message(
    "marking.to-figures", value=_VALUE, difference=_DIFFERENCE, low=_LOW, high=_HIGH
)


class Sentence(NamedTuple):
    """What a reason says beside the comparison: the mistakes that lead to the answer, none where it
    is compared with the key, and then whether that is by the policy's rule.
    """

    mistakes: tuple[str, ...] = ()
    by_policy: bool = False


@lru_cache(maxsize=4096)
def say_together(best: str, labels: tuple[str, ...]) -> Sentence:
    """What is said where mistakes with these labels lead to an answer, the best before others."""
    return Sentence(name_mistakes(best, labels))


@dataclass(frozen=True, slots=True)
class Form:
    """The texts between which numbers stand, and which numbers these are: 0 for the right value,
    then the difference, what is allowed, the lowest and the highest right value.
    """

    texts: tuple[str, ...]
    order: tuple[int, ...]

    def fill(self, numbers: Numbers) -> list[str]:
        """A text for each column of these five rows of numbers."""
        columns = [write_numbers(numbers[number]) for number in self.order]
        form = "%s".join(text.replace("%", "%%") for text in self.texts)
        texts = f"{form}\n".encode() * len(columns[0])
        filled = texts % tuple(chain.from_iterable(zip(*columns, strict=True)))
        return filled.decode("utf-8").split("\n")[:-1]


@dataclass(frozen=True, slots=True)
class Forms:
    """How an answer is compared with a value: within a tolerance, or to significant figures."""

    within: Form
    to_figures: Form

    def choose(self, *, to_figures: bool) -> Form:
        """One of them."""
        return self.to_figures if to_figures else self.within


@cache
def read_reasons(language: Language, sentence: Sentence) -> Forms:
    """The reasons that say this."""
    within, to_figures = (
        _split(open_catalogue(language).write(_say(sentence, comparison)))
        for comparison in (_WITHIN, _TO_FIGURES)
    )
    return Forms(within, to_figures)


@cache
def read_cells(language: Language, sentence: Sentence) -> Forms:
    """The same reasons as cells of a CSV file; numbers need no quotation marks."""
    forms = read_reasons(language, sentence)
    return Forms(_make_cell(forms.within), _make_cell(forms.to_figures))


def _say(sentence: Sentence, comparison: Message) -> Message:
    if sentence.mistakes:
        return explain_mistakes(sentence.mistakes, comparison)
    reason = Message("marking.key", comparison=comparison)
    return Message("marking.by-policy", reason=reason) if sentence.by_policy else reason


def _split(text: str) -> Form:
    pieces = _HOLE.split(text)
    return Form(tuple(pieces[::2]), tuple(map(int, pieces[1::2])))


def _make_cell(form: Form) -> Form:
    holes = [*(f"\x00{number}" for number in form.order), ""]
    whole = "".join(chain.from_iterable(zip(form.texts, holes, strict=True)))
    return _split(write_csv_cell(neutralise(whole)))
