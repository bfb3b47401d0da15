"""The contracts of `fast.comparison` and `fast.reasons` with `judging.judge`."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.exam.folder.keys import Key
from kinegrade.grading.fast.bounds import Flags, Places, tabulate_rules
from kinegrade.grading.fast.comparison import compare
from kinegrade.grading.fast.reasons import Sentence, read_reasons
from kinegrade.grading.judging.judge import judge
from kinegrade.grading.typed.answers import read
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message
from kinegrade.numbers.tolerance import Tolerance
from tests.grading.fast.rule_cases import RULES, VALUES, is_short, typed_numbers

Case = tuple[Tolerance, Fraction, str]


def always(places: Places) -> Flags:
    return np.ones(len(places), dtype=np.bool_)


def never(places: Places) -> Flags:
    return np.zeros(len(places), dtype=np.bool_)


RELATIVE = Tolerance(Fraction(1, 100))


@st.composite
def cases(draw: st.DrawFn) -> Case:
    """A rule, the right answer, and what was typed."""
    rule, right = draw(RULES), draw(VALUES)
    return rule, right, draw(typed_numbers(right, rule))


@given(
    st.lists(cases(), min_size=10, max_size=30),
    st.booleans(),
    st.sampled_from(["en", "zh", "de"]),
)
def test_what_is_certain_is_what_judging_one_by_one_says(
    several: list[Case], by_policy: bool, language: str
) -> None:
    rules, rights, typed = zip(*several, strict=True)
    values, centres = (np.array([float(each) for each in numbers]) for numbers in (typed, rights))
    written = zip(values.tolist(), typed, centres.tolist(), rights, strict=True)
    decimals = [is_short(a, number) and is_short(b, right) for a, number, b, right in written]
    found = compare(values, centres, tabulate_rules([rules]), np.array(decimals).__getitem__)
    places = np.flatnonzero(found.certain)
    forms = read_reasons(Language(language), Sentence(by_policy=by_policy))
    said: dict[int, str] = {}
    for place in places.tolist():
        form = forms.choose(to_figures=bool(found.bounds.to_figures[place]))
        (said[place],) = form.fill(found.stated[:, [place]])
    words = open_catalogue(Language(language))
    for place, (rule, right, number) in enumerate(several):
        verdict = judge(read(number, "1"), Key(right, rule))
        if found.decided[place]:
            assert found.right[place] == (verdict.kind == "right")
        if place in said:
            reason = verdict.reason
            expected = Message("marking.by-policy", reason=reason) if by_policy else reason
            assert said[place] == words.write(expected)


@pytest.mark.parametrize(
    ("rule", "typed"),
    [(Tolerance(Fraction(1, 100)), "1.25"), (Tolerance(figures=3), "1.226"), (Tolerance(), "7")],
)
def test_an_ordinary_answer_is_certain(rule: Tolerance, typed: str) -> None:
    values, centres = np.array([float(typed)]), np.array([1.2304])
    assert compare(values, centres, tabulate_rules([(rule,)]), never).certain.all()


@pytest.mark.parametrize(
    ("typed", "right", "difference"),
    [(13.5, 13.5, "0"), (-1.20, -1.2, "0"), (0.3, 0.1, "0.2"), (0.3, 0.1000003, "0.2"),
     (-1.204, -1.2040001234565, "1.23457e-07"), (1e6, 0.5, "1e+06")],
)  # fmt: skip
def test_decimals_are_subtracted_exactly(typed: float, right: float, difference: str) -> None:
    values, centres, rules = np.array([typed]), np.array([right]), tabulate_rules([(RELATIVE,)])
    found = compare(values, centres, rules, always)
    assert found.certain.all()
    assert f"{found.difference[0]:.6g}" == difference


def test_numbers_that_are_no_decimals_are_not_said_to_be_equal() -> None:
    values = np.array([13.5])
    found = compare(values, values.copy(), tabulate_rules([(RELATIVE,)]), never)
    assert found.decided.all()
    assert not found.certain.any()
