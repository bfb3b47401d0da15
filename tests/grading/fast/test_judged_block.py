"""The contract of `fast.judged_block` with a list of decisions: what is put there is what it gives."""

from __future__ import annotations

from fractions import Fraction
from math import nan
from typing import get_args

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.exam.folder.columns.gathering import LedTo
from kinegrade.files.csv_writing import neutralise, write_csv_cell
from kinegrade.grading.fast.bounds import tabulate_rules
from kinegrade.grading.fast.comparison import compare
from kinegrade.grading.fast.judged_block import JudgedBlock
from kinegrade.grading.fast.mistaken import Mistakes
from kinegrade.grading.fast.reasons import Sentence, read_cells, read_reasons
from kinegrade.grading.fast.typed_cells import CellReader, TypedCells
from kinegrade.grading.judging.decision import Decision, explain_mistakes
from kinegrade.grading.judging.judge import Verdict
from kinegrade.grading.typed.decimal_style import find_file_style
from kinegrade.language import ENGLISH, Language
from kinegrade.language.known import known_languages
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.students.mistaking.mistake_names import MistakeName
from tests.said import said as said_in

SIZE = 5
WITHIN = Tolerance(Fraction(1, 100))
SHARES = st.sampled_from([Fraction(0), Fraction(1, 3), Fraction(1, 2), Fraction(1)])
VERDICTS = st.builds(
    Verdict,
    st.sampled_from(["right", "wrong", "mistake", "void"]),
    st.sampled_from(["", "key 1"]),
    mistakes=st.sampled_from([(), ("wrong-pole",)]),
    by_policy=st.booleans(),
)
SENTENCES = [
    Sentence(),
    Sentence(by_policy=True),
    Sentence(("wrong-pole", "sense-reversed")),
    *(Sentence((name,)) for name in get_args(MistakeName)),
]
COMPARED = st.lists(st.booleans(), max_size=SIZE)
PUT = st.lists(st.tuples(st.integers(0, SIZE - 1), st.tuples(VERDICTS, SHARES)), max_size=12)


def begin(right: list[bool], size: int) -> JudgedBlock:
    """A block in whose first places these answers are compared with 2, the others are blank."""
    nothing = [""] * size
    typed = np.array([2.0 if each else 9.0 for each in right] + [nan] * (size - len(right)))
    reader, decimals = CellReader((), find_file_style([])), np.ones(size, dtype=np.bool_)
    cells = TypedCells(reader, nothing, typed, typed, decimals, nothing, {}, {})
    rules = tabulate_rules([(WITHIN,) * size])
    comparison = compare(typed, np.full(size, 2.0), rules, decimals.__getitem__)
    return JudgedBlock.begin([], cells, comparison, ENGLISH)


@given(COMPARED, PUT, st.booleans())
def test_the_last_decision_that_was_put_stands(
    compared: list[bool], put: list[tuple[int, Decision]], by_policy: bool
) -> None:
    block = begin(compared, SIZE)
    expected: list[Decision] = [(Verdict("blank", ""), Fraction(0))] * SIZE
    places = np.arange(len(compared))
    block.put_compared(places, np.full(len(compared), by_policy))
    for place, right in enumerate(compared):
        reason = f"key 2, difference {0 if right else 7}, allowed 0.02"
        reason += " by the policy" if by_policy else ""
        kind = "right" if right else "wrong"
        expected[place] = Verdict(kind, reason, by_policy=by_policy), Fraction(right)
    for place, decision in put:
        block.put(place, decision)
        expected[place] = decision
    assert [block.decision(place) for place in range(SIZE)] == expected


@given(st.sampled_from([None, Fraction(0), Fraction(1, 3), Fraction(1)]), st.booleans())
def test_mistakes_that_are_put_are_a_decision(share: Fraction | None, by_policy: bool) -> None:
    block = begin([False], 1)
    block.put_compared(np.array([0]), np.array([by_policy]))
    mistakes = Mistakes.of(np.array([0]), LedTo.of([{"wrong-pole": 8.95}]))
    rules, decimals = tabulate_rules([(WITHIN,)]), np.array([True])
    leading = mistakes.leading(np.array([9.0]), rules, decimals)
    said = block.find_sentence(Sentence(("wrong-pole",)))
    block.put_mistakes(leading, np.array([0]), np.array([said]))
    if share is not None:
        block.put_share(0, share)
    reason = explain_mistakes(("wrong-pole",), "8.95, difference 0.05, allowed 0.0895")
    verdict = Verdict("mistake", said_in(reason), mistakes=("wrong-pole",))
    assert block.decision(0) == (verdict, share or Fraction(0))


@pytest.mark.parametrize("language", known_languages())
@pytest.mark.parametrize("sentence", SENTENCES)
def test_reasons_begin_with_words(language: Language, sentence: Sentence) -> None:
    # Else a number at the beginning would decide whether a spreadsheet takes it for a formula
    forms = read_reasons(language, sentence)
    assert forms.within.texts[0][0].isalpha()
    assert forms.to_figures.texts[0][0].isalpha()


@pytest.mark.parametrize("language", known_languages())
@pytest.mark.parametrize("sentence", SENTENCES)
def test_cells_are_the_reasons_made_safe(language: Language, sentence: Sentence) -> None:
    numbers = np.array([[2.5], [-0.125], [1e-7], [3.0], [4.0]])
    reasons, cells = (read(language, sentence) for read in (read_reasons, read_cells))
    for reason, cell in ((reasons.within, cells.within), (reasons.to_figures, cells.to_figures)):
        assert cell.fill(numbers) == [write_csv_cell(neutralise(*reason.fill(numbers)))]


@given(COMPARED, st.booleans())
def test_what_is_put_in_words_at_once_reads_as_one_by_one(
    compared: list[bool], by_policy: bool
) -> None:
    places = np.arange(len(compared))
    alone, together = (begin(compared, SIZE) for _ in range(2))
    for block in (alone, together):
        block.put_compared(places, np.array([by_policy] * len(compared), dtype=bool))
    together.word(np.arange(SIZE))
    assert set(together.worded) == set(places.tolist())
    for place in range(SIZE):
        assert together.decision(place) == alone.decision(place)
