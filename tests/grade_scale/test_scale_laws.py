"""Laws of every scale: more points never earn a worse grade, and whoever has a passing grade has at
least the pass mark.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.grade_scale.kinds import make_scale
from kinegrade.grade_scale.scale import Scale
from kinegrade.grade_scale.stated import KINDS, Kind, StatedScale
from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue

_SHARES = st.fractions(0, Fraction(6, 5), max_denominator=1000)
_POINTS = st.fractions(0, 1, max_denominator=20)


def curves() -> st.SearchStrategy[tuple[tuple[Fraction, Fraction], ...]]:
    """No curve, or one through two points, the lower first."""
    pairs = st.tuples(_POINTS, _POINTS).filter(lambda pair: pair[0] < pair[1])
    through = st.tuples(pairs, pairs).map(
        lambda both: ((both[0][0], both[1][0]), (both[0][1], both[1][1]))
    )
    return st.just(()) | through


def make(kind: Kind, curve: tuple[tuple[Fraction, Fraction], ...]) -> Scale:
    return make_scale(StatedScale(kind, curve=curve), open_catalogue(ENGLISH))


@pytest.mark.parametrize("kind", KINDS)
@given(curve=curves(), less=_SHARES, more=_SHARES)
def test_more_points_never_earn_a_worse_grade(
    kind: Kind, curve: tuple[tuple[Fraction, Fraction], ...], less: Fraction, more: Fraction
) -> None:
    scale = make(kind, curve)
    low, high = sorted((less, more))
    places = [scale.steps.index(scale.find_step(share)) for share in (low, high)]
    assert places[0] >= places[1]


@pytest.mark.parametrize("kind", KINDS)
@given(curve=curves(), share=_SHARES)
def test_whoever_passes_has_the_pass_mark_and_the_others_do_not(
    kind: Kind, curve: tuple[tuple[Fraction, Fraction], ...], share: Fraction
) -> None:
    scale = make(kind, curve)
    mark = scale.pass_mark
    assert scale.find_step(share).passes == (mark is not None and share >= mark)


@given(curve=curves().filter(bool), share=_POINTS)
def test_a_curve_gives_the_grade_of_what_a_share_counts_as(
    curve: tuple[tuple[Fraction, Fraction], ...], share: Fraction
) -> None:
    (first, counts), (second, more) = curve
    counted = counts + (share - first) * (more - counts) / (second - first)
    plain = make("german", ())
    assert (
        make("german", curve).find_step(share).grade
        == plain.find_step(max(counted, Fraction(0))).grade
    )
