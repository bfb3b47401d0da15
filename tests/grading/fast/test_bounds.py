"""The contract of `fast.bounds` with `numbers.tolerance`."""

from __future__ import annotations

from fractions import Fraction
from math import isclose

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.grading.fast.bounds import tabulate_rules
from kinegrade.numbers.tolerance import Tolerance
from tests.grading.fast.rule_cases import RULES, VALUES

CASES = st.lists(st.tuples(RULES, VALUES, VALUES), min_size=10, max_size=30)


@given(CASES)
def test_bounds_that_are_settled_are_those_of_the_rule(
    cases: list[tuple[Tolerance, Fraction, Fraction]],
) -> None:
    rules, rights, typed = zip(*cases, strict=True)
    centres, values = (np.array([float(each) for each in numbers]) for numbers in (rights, typed))
    table = tabulate_rules([rules])
    bounds, near = table.bounds(centres), table.may_agree(values, np.arange(len(values)), centres)
    for place, (rule, right, value) in enumerate(cases):
        low, high = rule.interval(right)
        if bounds.settled[place]:
            assert isclose(bounds.low[place], low, rel_tol=1e-12, abs_tol=1e-12 * abs(right))
            assert isclose(bounds.high[place], high, rel_tol=1e-12, abs_tol=1e-12 * abs(right))
        if low <= value <= high:
            assert near[place]
        assert bounds.to_figures[place] == rule.goes_by_figures(right)
