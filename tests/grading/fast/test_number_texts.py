"""The contract of `fast.number_texts` with the % operator: the same six digits for every number."""

from __future__ import annotations

import numpy as np
from hypothesis import example, given
from hypothesis import strategies as st

from kinegrade.grading.fast.number_texts import FORMAT, write_numbers

ROUND = st.builds(
    lambda digits, power: float(f"{digits}e{power}"),
    st.integers(-(10**7), 10**7),
    st.integers(-13, 9),
)
# Where six digits become one more, where the exponent begins, and halves of the last digit
ENDS = [999999.5, 999999.4999999, 99999.95, 9.999995e-5, 1e-4, 1e-5, 100000.0, 1e6, 1.000005]
NO_NUMBERS = [0.0, -0.0, float("inf"), float("-inf"), float("nan"), 5e-324, 1.7e308]


@given(st.lists(st.floats() | ROUND | st.sampled_from(ENDS), max_size=30))
@example(ENDS)
@example([-each for each in ENDS])
@example(NO_NUMBERS)
def test_numbers_are_written_as_the_operator_writes_them(numbers: list[float]) -> None:
    written = write_numbers(np.array(numbers, dtype=np.float64))
    assert written == [(FORMAT % number).encode() for number in numbers]


def test_so_are_numbers_of_all_sizes() -> None:
    random = np.random.default_rng(7)
    numbers = random.choice([-1, 1], 20_000) * 10 ** random.uniform(-22, 22, 20_000)
    numbers[::3] = np.round(numbers[::3], 4)
    written = write_numbers(numbers)
    assert written == [(FORMAT % number).encode() for number in numbers.tolist()]
