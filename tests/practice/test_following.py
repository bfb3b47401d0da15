"""The page tells what follows from a wrong answer wherever `kinegrade grade` does, or says that it
cannot tell.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from kinegrade.practice.document import PracticeQuestion
from tests.laws.cases import moving_templates
from tests.practice.graded import Carrying, Pair, mark_typed
from tests.practice.node import judge_in_node

STEPS = """title = "T"
course = "C"

[[questions]]
name = "car-from-rest"
title = "A car that starts"
statement = "A car starts from rest with the acceleration {{ a }}. How fast is it after {{ t }}?"
parameters.a = { unit = "m/s^2", draw = [2, 3] }
parameters.t = { unit = "s", draw = "4 .. 12 step 1" }
steps.v = "a*t"
steps.s = "v*t/2"
steps.root = "sqrt(v**2 + s**2*a/(v*t))"
asks.v = { unit = "m/s", points = 3, means = "its speed" }
asks.s = { unit = "m", points = 2, means = "the distance" }
asks.root = { unit = "m/s", points = 2, means = "a speed" }
"""


BELT = """title = "T"
course = "C"

[[questions]]
template = "crossed-belt-drive"
asks = { omega_II = 2, v_B = 2 }
draw = { r1 = "0.39", r2 = "0.12", l = "0.65", phi = 135, omega1 = 2, omega0 = 4 }
repeats = true
"""
SHARES = (1.2, 0.7, 1.3, 2.5, -1.3)  # of the right answers, that the wrong ones are


def type_carried_on(question: PracticeQuestion, number: int, carrying: Carrying) -> Iterator[str]:
    """A wrong answer to one ask, another one at each draw, and what follows from it for the others;
    those that do not depend on it are right.
    """
    right = {ask.name: float(key[0]) for ask, key in zip(
        question.asks, question.draws[number].keys, strict=True
    )}  # fmt: skip
    names = list(right)
    wrong = names[number % len(names)]
    own = {wrong: right[wrong] * SHARES[number // len(names) % len(SHARES)]}
    for name in names:
        follows = next(carrying.list_values(own, name), right[name])
        yield f"{own.get(name, follows):.8g}"


def compare(bank: str, folder: Path, draws: int) -> list[Pair]:
    """What the page and the marks say of answers that follow from a wrong one."""
    path = folder / "bank.toml"
    path.write_text(bank, encoding="utf-8")
    return mark_typed(path, folder, draws, type_carried_on).compare(judge_in_node)


def require_told(pairs: list[Pair]) -> None:
    """That something follows on the page too, and what does not is said not to be told."""
    assert [pair for pair in pairs if not pair.agrees] == []
    assert any(pair.marked == pair.shown == "follow-through" for pair in pairs), pairs


def test_what_follows_in_steps_is_told(tmp_path: Path) -> None:
    require_told(compare(STEPS, tmp_path, draws=15))


def test_a_speed_that_follows_as_the_root_of_a_quadratic_is_told(tmp_path: Path) -> None:
    require_told(compare(BELT, tmp_path, draws=1))


@pytest.mark.sampled(24, by="template")
@pytest.mark.parametrize("template", moving_templates())
def test_what_follows_on_any_template_is_told_or_said_not_to_be_told(
    template: str, tmp_path: Path
) -> None:
    bank = f'title = "T"\ncourse = "C"\n\n[[questions]]\ntemplate = "{template}"\n'
    assert [pair for pair in compare(bank, tmp_path, draws=4) if not pair.agrees] == []
