"""The contract of `fast.mistaken` with `judging.decision.find_mistaken`."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.exam.folder.columns.gathering import LedTo
from kinegrade.exam.folder.keys import Key
from kinegrade.grading.fast.bounds import tabulate_rules
from kinegrade.grading.fast.mistaken import Leading, Mistakes, find_best
from kinegrade.grading.fast.reasons import Sentence, read_reasons
from kinegrade.grading.judging.decision import find_mistaken, name_mistakes
from kinegrade.grading.policy.policy import Ruling
from kinegrade.grading.typed.answers import read
from kinegrade.language import ENGLISH
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.stated_marking import find_identifier
from tests.grading.fast.rule_cases import RULES, VALUES, is_short, typed_numbers
from tests.said import said

NAMES = ("sense-reversed", "coriolis-dropped", "wrong-pole", "=odd", "angle.phi", "angle.psi")
# Several mistakes at one place, next to each other, within the tolerance of each other, and apart
FACTORS = st.sampled_from([Fraction(1), Fraction(1), Fraction(1003, 1000), 1 + Fraction(1, 10**12)])
CREDITS = st.dictionaries(
    st.sampled_from([*NAMES[:4], "angle"]), st.sampled_from([Fraction(1, 2), Fraction(1, 4)])
)


@st.composite
def answers(draw: st.DrawFn) -> tuple[Key, str]:
    """A key with mistakes, and what a student typed, as a rule what one of them leads to."""
    rule, wrong = draw(RULES), draw(VALUES)
    names = draw(st.lists(st.sampled_from(NAMES), min_size=1, unique=True))
    # As in key.jsonl: to double precision
    mistakes = {name: Fraction(repr(float(wrong * draw(FACTORS)))) for name in names}
    return Key(1000 + wrong, rule, None, mistakes), draw(typed_numbers(wrong, rule))


@given(answers(), CREDITS)
def test_the_best_mistake_is_the_one_that_deciding_exactly_finds(
    answer: tuple[Key, str], credits: Mapping[str, Fraction]
) -> None:
    key, typed = answer
    expected = find_mistaken(read(typed, "1"), key, Ruling(mistakes=credits))
    written = {name: float(wrong) for name, wrong in key.mistakes.items()}
    mistakes = Mistakes.of(np.array([0]), LedTo.of([written]))
    decimals = np.array([is_short(float(typed), typed)])
    rules = tabulate_rules([(key.rule,)])
    leading = mistakes.leading(np.array([float(typed)]), rules, decimals)
    ways = dict(leading.group_others()).get(0, [])
    if leading.single.any():
        assert leading.single.tolist() == [True]
        assert not ways
        assert expected is not None
        assert expected[0].mistakes == (find_identifier(leading.known[leading.names[0]]),)
        assert reason(leading, 0, expected[0].mistakes) == said(expected[0].reason)
        return
    if expected is not None:
        assert set(expected[0].mistakes) <= {find_identifier(way.name) for way in ways}
    best = find_best(ways, credits) if ways else None
    if best is not None:
        names = name_mistakes(best.name, [way.name for way in ways])
        assert expected is not None
        assert (names, credits.get(names[0], 0)) == (expected[0].mistakes, expected[1])
        assert reason(leading, best.number, names) == said(expected[0].reason)


def reason(leading: Leading, way: int, names: tuple[str, ...]) -> str:
    """What is said of an answer to which a way leads."""
    forms = read_reasons(ENGLISH, Sentence(names))
    (filled,) = forms.choose(to_figures=bool(leading.to_figures[way])).fill(
        leading.stated[:, [way]]
    )
    return filled


def test_a_single_mistake_is_certain() -> None:
    mistakes = Mistakes.of(np.array([1]), LedTo.of([{"wrong-pole": 2.5}]))
    rules = tabulate_rules([(Tolerance(), Tolerance(Fraction(1, 100)))])
    leading = mistakes.leading(np.array([9.0, 2.51]), rules, np.array([True, True]))
    assert (leading.single.tolist(), leading.places.tolist()) == ([True], [1])
    assert [leading.known[name] for name in leading.names] == ["wrong-pole"]
    assert list(leading.group_others()) == []


def test_a_mistake_that_leads_there_by_two_givens_is_named_once() -> None:
    wrong = {"angle.phi": Fraction(3), "coriolis-dropped": Fraction(3), "angle.psi": Fraction(3)}
    key = Key(Fraction(1), Tolerance(Fraction(1, 100)), None, wrong)
    ruling = Ruling(mistakes={"angle": Fraction(1, 2)})
    verdict, share = find_mistaken(read("3", "1"), key, ruling) or (None, None)
    assert verdict is not None
    assert (verdict.mistakes, share) == (("angle", "coriolis-dropped"), Fraction(1, 2))
