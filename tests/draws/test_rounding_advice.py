"""Where honest rounding refuses most draws, the message says what helps, and it does help."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction
from functools import partial

import pytest

from kinegrade.draws.deal import deal, look_here
from kinegrade.draws.draw_filter import DrawFilter
from kinegrade.errors import DrawError
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.problem.template.library.library import load_template
from tests.problem.crank import crank
from tests.problem.draws import dealt, draw_filter
from tests.said import said

SLEEVE = load_template("bar-through-swivelling-sleeve")
PLACES = 4


def strict(relative: str, *asks: str) -> DrawFilter:
    """The filter of a question in which these asks, or all, have that tolerance, and others 2 %."""
    rules = {ask: Tolerance(Fraction(1, 50)) for ask in SLEEVE.asked()}
    rules |= {ask: Tolerance(Fraction(relative)) for ask in asks or SLEEVE.asked()}
    return draw_filter(SLEEVE, tolerances=rules)


def refusal(question: DrawFilter) -> str:
    """Why nothing is dealt."""
    filters = {"q1": question}
    with pytest.raises(DrawError) as caught:
        deal(filters, PLACES, partial(look_here, filters))
    return caught.value.problems[0]


def test_more_figures_or_wider_tolerances_are_advised() -> None:
    said_of_it = refusal(strict("1/1000"))
    assert re.search(
        r"expected one for each student - state carry = 5 or tolerance = \"honest\" or wider for "
        r"a_cor \(1 %\), alpha_AB \(1\.5 %\), omega_AB \(1 %\) and v_O \(1 %\)$",
        said_of_it,
    )


def test_what_is_advised_helps() -> None:
    question = strict("1/1000")
    wide = {ask: Tolerance(Fraction(share)) for ask, share in WIDER.items()}
    for helped in (
        replace(question, carry=5),
        replace(question, honest=frozenset(SLEEVE.asked())),
        replace(question, tolerances=wide),
    ):
        assert dealt(helped, PLACES).lasting


WIDER = {"a_cor": "1/100", "alpha_AB": "1/50", "omega_AB": "1/100", "v_O": "1/100"}


def test_only_the_asks_that_rounding_leaves_are_named() -> None:
    assert refusal(strict("1/5000", "omega_AB", "alpha_AB")).endswith(
        'state carry = 6 or tolerance = "honest" or wider for alpha_AB (1.5 %) and omega_AB (1 %)'
    )


def test_where_six_figures_are_too_few_only_tolerances_are_advised() -> None:
    assert "state tolerance = " in refusal(strict("1/10000000"))


def test_where_honest_tolerances_do_not_help_figures_are_advised(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("kinegrade.students.rounding.accuracy.WIDEST", Fraction(1, 10**9))
    three = replace(strict("1/1000"), carry=3)
    assert refusal(three).endswith(" - state carry = 5")
    beyond = replace(strict("1/10000000"), carry=3)
    assert refusal(beyond).endswith("or ask for another quantity")


def test_some_with_the_same_numbers_hear_the_same_advice() -> None:
    question = strict("1/250")
    found = dealt(question, PLACES * 200)
    assert not found.lasting
    assert "rounding" in found.refused
    assert "some have the same numbers - expected one for each - state carry = 5 or" in said(
        found.shortage("q1", "students", question)
    )


def test_figures_are_advised_where_mistakes_refuse_more() -> None:
    rules = {
        "v_B": Tolerance(Fraction(1, 50)),
        "omega_AB": Tolerance(Fraction(1, 100), Fraction(1, 20)),
        "a_B": Tolerance(Fraction(1, 50), figures=2),
    }
    coarse = replace(
        draw_filter(load_template("slider-crank"), asks=tuple(rules), tolerances=rules), carry=3
    )
    said_of_it = refusal(coarse)
    refused = {reason: int(count) for reason, count in re.findall(r"(\w+) (\d+)", said_of_it)}
    assert refused["mistake"] > refused["rounding"] >= 2 * PLACES
    assert "state carry = " in said_of_it
    carry = int(re.findall(r"carry = (\d)", said_of_it)[0])
    assert dealt(replace(coarse, carry=carry), PLACES).lasting


def test_other_reasons_keep_their_advice() -> None:
    few = draw_filter(crank(), asks=("v_x",))
    assert said(dealt(few, 30).shortage("q1", "students", few)).endswith("widen the domains")
