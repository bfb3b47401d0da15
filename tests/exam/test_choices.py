"""Of several alternatives each is given equally often, or once more at most."""

from __future__ import annotations

from collections import Counter

from hypothesis import given
from hypothesis import strategies as st

from kinegrade.exam.choices import Choice


@given(st.integers(1, 26), st.data())
def test_however_many_are_given_to_each_all_are_given_equally_often(
    count: int, data: st.DataObject
) -> None:
    number = data.draw(st.integers(1, count))
    choice = Choice(tuple(f"q1{place}" for place in range(count)), number)
    begun, papers = data.draw(st.integers(0, 3)), data.draw(st.integers(0, 60))
    held = [choice.choose("spring", begun * count + place) for place in range(papers)]
    assert [each for each in held if len(set(each)) != number] == []
    often = Counter(dict.fromkeys(choice.questions, 0))
    often.update(name for each in held for name in each)
    assert max(often.values()) - min(often.values()) <= 1
