"""A chapter whose checks are all long ends with the shortest of them."""

from __future__ import annotations

import pytest

from kinegrade.language.known import known_languages
from kinegrade.language.message import Message
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.checks.check import Check, choose_check
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.formulas.atoms import Number, add_terms
from kinegrade.worked.formulas.symbols import read_symbol
from tests.worked.draws import kept, stated, told
from tests.worked.telling import displayed, proses

_DRAWS = {
    # eight and eight vectors stand in every projection: there was no check at all
    "pin-in-two-rings": {},
    "two-wheels-on-cylinder": {"r1": "0.17", "r2": "0.15", "R": "0.46", "L": "0.52", "a_A": "4"},
}


@pytest.mark.parametrize("name", _DRAWS)
def test_accelerations_of_many_vectors_are_checked_too(name: str) -> None:
    *_, last = proses(told(solve_template(load_template(name), _DRAWS[name])))
    assert last.startswith("Check by ")
    assert "; they agree" in last


def make_check(terms: int, *, same: bool = False, symbol: str = "omega") -> Check:
    side = add_terms(read_symbol(symbol) for _ in range(terms))
    other = side if same else Number("0")
    first, second = (Side(Number("1"), 1, letters) for letters in (other, side))
    return Check(Message("solution.projection-x"), (first, second), "m")


def test_a_short_check_goes_before_longer_ones_wherever_it_stands() -> None:
    short, long = make_check(3), make_check(30)
    assert choose_check([long, short]) is short


def test_the_shortest_of_long_ones_is_taken_and_none_that_nobody_reads() -> None:
    long, longer, endless = make_check(30), make_check(35), make_check(1000)
    assert choose_check([longer, long, endless]) is long
    assert choose_check([endless]) is None
    assert choose_check([make_check(3, same=True)]) is None


def test_a_check_is_as_long_in_every_language() -> None:
    """The German page had none of accelerations: Kurve has more letters than cam."""
    pages = (stated("oscillating-flat-faced-follower", language) for language in known_languages())
    checks = [[one for one in page if getattr(one, "on_check", False)] for page in pages]
    assert [len(found) for found in checks] == [2] * len(checks)
    short, long = (
        make_check(30, symbol=rf"\frac{{r\omega_{{\text{{{word}}}}}}}{{2}}")
        for word in ("cam", "Nockenwelle")
    )
    assert short.letters == long.letters


def test_the_normal_acceleration_that_a_check_goes_by_stands_on_the_page() -> None:
    (normal,) = [
        line
        for line in displayed(kept("two-wheels-on-cylinder"))
        if "a_{A}^{\\mathrm{n}} &=" in line
    ]
    assert normal.startswith(r"a_{A}^{\mathrm{n}} &= \frac{v_{A}^{2}}{OA} = ")
