"""Where cases are many and alike, a run of the suite tries its sample of them, and `make prove` all."""

from __future__ import annotations

import pytest

from tests.sampling import Sample

NUMBERS = tuple(range(9))
TRIED = {1, 4, 6, 7}


@pytest.mark.sampled(3, first=1, also=(6,))
@pytest.mark.parametrize("name", NUMBERS)
def test_a_sample_alone_is_tried(name: int, request: pytest.FixtureRequest) -> None:
    proves = request.config.getoption("--hypothesis-profile") == "prove"
    assert name in (NUMBERS if proves else TRIED)


@pytest.mark.sampled(3, by="number")
@pytest.mark.sampled(2, by="letter", first=1)
@pytest.mark.parametrize("letter", "ab")
@pytest.mark.parametrize("number", NUMBERS)
def test_samples_of_two_parameters_are_taken_together(
    letter: str, number: int, request: pytest.FixtureRequest
) -> None:
    proves = request.config.getoption("--hypothesis-profile") == "prove"
    assert proves or (letter, number % 3) == ("b", 0)


@pytest.mark.parametrize("every", [1, 2, 5, 7])
def test_tests_that_take_turns_leave_nothing_out(every: int) -> None:
    samples = [Sample(every, first) for first in range(every)]
    tried = [number for sample in samples for number in NUMBERS if sample.has(number, number)]
    assert sorted(tried) == list(NUMBERS)
