"""Filter, then deal: the good combinations that are found first depend on the deck only, and there
is one for each place while combinations last.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cache, partial

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec import structs

from kinegrade.draws.deal import (
    LOOKS,
    PART,
    PATIENCE,
    Deal,
    DeckPart,
    Verdicts,
    deal,
    look_further,
    look_here,
)
from kinegrade.draws.draw_filter import DrawFilter, Verdict
from kinegrade.errors import DrawError
from kinegrade.figure.scene import Scene
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.problem.template.hints import FigureHints
from kinegrade.problem.template.library.library import load_template
from kinegrade.students.comparison import Comparison
from kinegrade.students.mistaking.mistakes import Values
from kinegrade.students.separation import Separation
from tests.problem.crank import crank
from tests.problem.draws import dealt, draw_filter, drawn
from tests.said import said

FEW = {"r": ("2", "3"), "h": ("1/2", "1"), "omega": ("2", "3", "4")}
ONE_TO_SIXTY = tuple(map(str, range(1, 61)))
MANY = 40  # combinations


def cranks(**fixed: tuple[str, ...]) -> DrawFilter:
    return draw_filter(crank(), fixed=fixed, asks=("v_x",))


def of(verdicts: list[bool], places: int) -> Deal:
    """A deck that is dealt to places when these of its combinations are good."""
    told: list[Verdict] = [None if good else "mechanism" for good in verdicts]
    return Deal(len(told), places, tuple(told[: max(LOOKS * places, PATIENCE)]))


@cache
def whole() -> tuple[Verdict, ...]:
    """The first verdicts on many cranks, as one part."""
    return many_cranks().verdicts(range(MANY))


def many_cranks() -> DrawFilter:
    return cranks(r=("1", "2"), h=("1/2", "1", "2"), omega=ONE_TO_SIXTY)


@given(st.integers(0, MANY), st.data())
def test_parts_that_are_filtered_alone_are_the_whole(count: int, data: st.DataObject) -> None:
    template = many_cranks()
    cuts = sorted(data.draw(st.lists(st.integers(0, count), max_size=4)))
    parts = zip([0, *cuts], [*cuts, count], strict=True)
    alone = [verdict for part in parts for verdict in template.verdicts(range(*part))]
    assert tuple(alone) == whole()[:count]


@pytest.mark.parametrize("name", ["slider-crank", "slotted-bar-between-two-rods"])
def test_parts_of_a_shipped_template_are_the_whole(name: str) -> None:
    template = load_template(name)
    whole = draw_filter(template).verdicts(range(60))
    parts = range(1), range(1, 3), range(3, 33), range(33, 60)
    assert sum((draw_filter(template).verdicts(part) for part in parts), ()) == whole
    assert {None, "mistake"} <= set(whole)


def test_combinations_that_are_asked_for_one_by_one_are_screened_together(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    expected = whole()
    screened = []
    compare = Separation.compare

    def note(separation: Separation, values: Values) -> Comparison:
        screened.append(len(values["omega"]))
        return compare(separation, values)

    monkeypatch.setattr(Separation, "compare", note)
    template = many_cranks()
    verdicts = [template.verdicts(range(place, place + 1)) for place in range(MANY)]
    assert sum(verdicts, ()) == expected
    assert screened == [360, 100]  # all combinations as the sample, and the block of these


@given(st.lists(st.booleans(), min_size=1, max_size=50), st.integers(1, 70))
def test_there_is_one_for_each_place_while_they_last(good: list[bool], places: int) -> None:
    good[0] = True
    each = of(good, places)
    assert each.lasting == (sum(good) >= places)
    assert each.good == min(sum(good), places)
    assert each.positions == [place for place, fit in enumerate(good) if fit]


@given(st.lists(st.integers(1, 900), min_size=1, max_size=8), st.integers(1, 10), st.data())
def test_what_is_found_first_does_not_depend_on_how_many_places_there_are(
    gaps: list[int], places: int, data: st.DataObject
) -> None:
    good = [False] * 4000
    good[0] = True
    for place in range(len(gaps)):
        good[min(sum(gaps[: place + 1]), 3999)] = True
    few, many = of(good, data.draw(st.integers(1, places))), of(good, places)
    assert many.positions[: len(few.positions)] == few.positions


@pytest.mark.parametrize("places", [1, 5, PART, 3 * PART + 1])
def test_a_deal_looks_at_no_more_than_it_needs_to_count(places: int) -> None:
    template = many_cranks()
    verdicts = template.verdicts(range(template.deck.size))
    found = dealt(template, places)
    good = [place for place, verdict in enumerate(verdicts) if verdict is None]
    assert found.positions[:places] == good[:places]
    refused = Counter(map(str, filter(None, verdicts[: good[places - 1] + 1])))
    assert found.refused == dict(sorted(refused.items()))


def test_what_a_place_gets_is_good_and_solved() -> None:
    for one in drawn(cranks(**FEW), 12):
        assert one.values == {
            name: quantity.exact for name, quantity in one.solution.parameters.items()
        }
        assert list(one.solution.answers) == ["v_x"]


def test_a_shortage_is_said() -> None:
    few = cranks(**FEW)
    found = dealt(few, 30)
    assert (found.size, found.good, found.lasting, found.refused) == (12, 12, False, {})
    assert found.positions == [*range(12)]
    assert said(found.shortage("q1 (crank)", "students", few)) == (
        "q1 (crank): 12 of the 12 combinations of values are fit for 30 students, so some have the "
        "same numbers - expected one for each - widen the domains"
    )


def test_looking_for_a_place_ends_at_a_bound() -> None:
    good = [False] * 3000
    good[10] = good[2300] = True
    two, five, six = of(good, 2), of(good, 5), of(good, 6)
    assert (two.positions, five.positions, six.positions) == ([10], [10], [10, 2300])
    for few in (two, five):
        assert (few.good, said(few.looked_at())) == (
            1,
            "the first 2000 of the 3000 combinations of values",
        )
        assert few.bound == 2000
        assert few.refused == {"mechanism": 1999}


def test_reasons_are_counted() -> None:
    mixed = dealt(draw_filter(crank(), asks=("v_x",)), 3)
    # r = 1 and r = 2 with h = 1/2 and omega = 2: there are no more
    assert (mixed.good, mixed.size) == (2, 18)
    assert mixed.refused == {"absurd": 2, "condition": 6, "degenerate": 4, "mechanism": 4}


def test_where_nothing_is_good_every_question_is_named_before_long() -> None:
    wide = tuple(map(str, range(1, 1001)))
    filters = {
        "q1": cranks(r=("1",), h=("3", "4"), omega=wide),
        "q2": cranks(**FEW),
        "q3": cranks(r=("1",), h=("3",), omega=("2", "20000000")),
    }
    with pytest.raises(DrawError) as caught:
        deal(filters, 500, partial(look_here, filters))
    assert caught.value.problems == (
        "q1 (crank): none of the 2000 combinations of values is fit for students "
        "(mechanism 2000) - expected one for each student - widen the domains",
        "q3 (crank): none of the 2 combinations of values is fit for students "
        "(condition 1, mechanism 1) - expected one for each student - widen the domains",
    )


def test_who_waits_at_a_screen_gives_up_sooner() -> None:
    filters = {"q1": cranks(r=("1",), h=("3", "4"), omega=ONE_TO_SIXTY)}
    with pytest.raises(DrawError, match="none of the first 60 of"):
        deal(filters, 4, partial(look_here, filters), patience=60)


def test_a_deal_is_looked_at_further_from_where_it_ended() -> None:
    filters = {"q1": cranks(r=("1", "2"), h=("1/2", "1", "2"), omega=ONE_TO_SIXTY)}
    look = partial(look_here, filters)
    begun = deal(filters, 5, look)["q1"]
    further = look_further(filters, {"q1": replace(begun, spare=20)}, look)["q1"]
    assert further.verdicts[: len(begun.verdicts)] == begun.verdicts
    assert len(further.positions) >= 25 == further.wanted
    assert (further.good, further.refused) == (begun.good, begun.refused)


def test_a_few_more_are_looked_at_in_several_parts() -> None:
    filters = {"q1": cranks(r=("1", "2"), h=("1/2", "1", "2"), omega=ONE_TO_SIXTY)}
    counts: list[int] = []

    def look(parts: Sequence[DeckPart]) -> Iterator[Verdicts]:
        counts.append(len(parts))
        return look_here(filters, parts)

    look_further(filters, {"q1": Deal(360, 30)}, look)
    assert counts[0] >= 2  # for two processes, of which none looks on while the other works


VANISHING = ('sign = "+x", points', 'sign = "+x", vanishes = true, points')


def test_an_answer_is_zero_in_all_draws_or_in_none() -> None:
    some, all_of_them = (
        draw_filter(
            crank(VANISHING), fixed={"r": ("2",), "h": h, "omega": ("2", "3")}, asks=("v_x",)
        )
        for h in (("0", "1/2", "1"), ("0",))
    )
    told = {
        some.deck.combination(place)["h"]: verdict
        for place, verdict in enumerate(some.verdicts(range(some.deck.size)))
    }
    assert told == {"0": "degenerate", "1/2": None, "1": None}
    assert all_of_them.verdicts(range(2)) == (None, None)


def test_what_four_decimals_do_not_hold_is_refused_where_no_more_are_kept() -> None:
    turning = (
        "v_y = {",
        'turning = { quantity = "omega(OA)", unit = "rad/s", sign = "ccw", points = 1, '
        'means = { en = "rate", zh = "rate" } }\nv_y = {',
    )
    fine = {"r": ("2",), "h": ("1",), "omega": ("0.0012345", "0.25")}
    plain = draw_filter(crank(turning), fixed=fine, asks=("turning",))
    assert plain.verdicts(range(2)) == (None, None)
    kept = replace(plain, four_decimals=True)
    said = {
        kept.deck.combination(place)["omega"]: kept.verdicts(range(2))[place] for place in (0, 1)
    }
    assert said == {"0.0012345": "decimals", "0.25": None}


def test_figures_are_drawn_last_and_refused_where_a_part_cannot_be_seen() -> None:
    drawn: list[str] = []

    def draw(mechanism: Mechanism, hints: FigureHints) -> Scene:
        drawn.append(str(mechanism.points["A"].x))
        return structs.replace(sketch(mechanism, hints), crowded=("r",) if len(drawn) > 1 else ())

    offsets = ("0", "1/2", "1")
    filtered = draw_filter(
        crank(VANISHING), fixed={"r": ("2",), "h": offsets, "omega": ("2",)}, asks=("v_x",)
    )
    verdicts = replace(filtered, sketcher=draw).verdicts(range(3))
    assert sorted(map(str, verdicts)) == ["None", "degenerate", "figure"]
    assert len(drawn) == 2
