"""Where cases are many and alike, a run of the suite tries its sample of them, and `make prove` all."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.sampling import Sample

NUMBERS = tuple(range(9))
TRIED = {1, 4, 6, 7}
LEFT_TEST = re.compile(r"(?m)^@pytest\.mark\.left\([^)]*\)\n(?:@.*\n|[ )\]].*\n)*def (\w+)\(")


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


@pytest.mark.left(beside="test_samples_of_two_parameters_are_taken_together")
def test_what_is_left_is_run_by_the_proofs_alone(request: pytest.FixtureRequest) -> None:
    assert request.config.getoption("--hypothesis-profile") == "prove"


@pytest.mark.sampled(2, by="letter")
@pytest.mark.parametrize("letter", [pytest.param("a", id="first"), pytest.param("b", id="second")])
def test_cases_with_names_are_sampled(letter: str, request: pytest.FixtureRequest) -> None:
    assert letter == "a" or request.config.getoption("--hypothesis-profile") == "prove"


def test_what_is_left_names_a_test_of_its_file_that_is_not() -> None:
    marked = re.compile(r"""mark\.left\(\s*beside=["'](\w+)["']""")
    named = 0
    for path in sorted(Path(__file__).parent.rglob("test_*.py")):
        text = path.read_text(encoding="utf-8")
        left = {each[1] for each in LEFT_TEST.finditer(text)}
        for beside in marked.findall(text):
            named += 1
            assert f"def {beside}(" in text, f"{path.name}: there is no {beside}"
            assert beside not in left, f"{path.name}: {beside} is left as well"
    assert named


@pytest.mark.parametrize("every", [1, 2, 5, 7])
def test_tests_that_take_turns_leave_nothing_out(every: int) -> None:
    samples = [Sample(every, first) for first in range(every)]
    tried = [number for sample in samples for number in NUMBERS if sample.has(number, number)]
    assert sorted(tried) == list(NUMBERS)
