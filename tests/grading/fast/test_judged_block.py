"""The contract of `fast.judged_block` with a list of decisions: what is put there is what it gives."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.grading.fast.judged_block import JudgedBlock
from kinegrade.grading.fast.typed_cells import CellReader, TypedCells
from kinegrade.grading.judging.decision import Decision
from kinegrade.grading.judging.judge import Verdict
from kinegrade.grading.typed.decimal_style import find_file_style

SIZE = 5
SHARES = st.sampled_from([Fraction(0), Fraction(1, 3), Fraction(1, 2), Fraction(1)])
VERDICTS = st.builds(
    Verdict,
    st.sampled_from(["right", "wrong", "mistake", "void"]),
    st.sampled_from(["", "key 1"]),
    mistakes=st.sampled_from([(), ("wrong-pole",)]),
    by_policy=st.booleans(),
)
COMPARED = st.lists(st.booleans(), max_size=SIZE)
PUT = st.lists(st.tuples(st.integers(0, SIZE - 1), st.tuples(VERDICTS, SHARES)), max_size=12)


@given(COMPARED, PUT)
def test_the_last_decision_that_was_put_stands(
    compared: list[bool], put: list[tuple[int, Decision]]
) -> None:
    cells = TypedCells(
        CellReader((), find_file_style([])), [""] * SIZE, np.zeros(SIZE), [""] * SIZE, {}, {}
    )
    block = JudgedBlock([], cells, ["blank"] * SIZE, [""] * SIZE, [0] * SIZE)
    expected: list[Decision] = [(Verdict("blank", ""), Fraction(0))] * SIZE
    places = np.arange(len(compared))
    block.put_compared(places, np.array(compared, dtype=np.bool_), ["key 2"] * len(compared))
    for place, right in enumerate(compared):
        kind = "right" if right else "wrong"
        expected[place] = Verdict(kind, "key 2"), Fraction(right)
    for place, decision in put:
        block.put(place, decision)
        expected[place] = decision
    assert [block.decision(place) for place in range(SIZE)] == expected


@given(st.sampled_from([None, Fraction(0), Fraction(1, 3), Fraction(1)]), st.booleans())
def test_mistakes_that_are_put_are_a_decision(share: Fraction | None, by_policy: bool) -> None:
    cells = TypedCells(CellReader((), find_file_style([])), [""], np.zeros(1), [""], {}, {})
    block = JudgedBlock([], cells, ["wrong"], ["key 2"], [0])
    block.by_policy.update({0} if by_policy else ())
    block.put_mistakes(0, ("wrong-pole",), "leads to 1", share)
    verdict = Verdict("mistake", "leads to 1", mistakes=("wrong-pole",))
    assert block.decision(0) == (verdict, share or Fraction(0))
