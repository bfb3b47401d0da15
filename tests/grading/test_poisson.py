"""How often rare events come together."""

from __future__ import annotations

from math import exp, factorial

import pytest

from kinegrade.grading.poisson import find_tail


@pytest.mark.parametrize(("count", "mean"), [(1, 0.2), (3, 0.05), (7, 2.5), (4, 3.9)])
def test_the_tail_of_the_poisson_distribution(count: int, mean: float) -> None:
    assert find_tail(count, mean) == pytest.approx(
        1 - sum(exp(-mean) * mean**each / factorial(each) for each in range(count))
    )
