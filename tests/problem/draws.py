"""Good combinations of a template as a class is dealt them, for tests."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

from kinegrade.draws.deal import Deal, deal, look_here
from kinegrade.draws.deck import make_deck
from kinegrade.draws.draw_filter import DrawFilter
from kinegrade.exam.setting.setting import Drawn
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.problem.template.template import Template


def draw_filter(
    template: Template,
    secret: str = "spring",
    fixed: Mapping[str, tuple[str, ...]] | None = None,
    tolerances: Mapping[str, Tolerance] | None = None,
    asks: tuple[str, ...] | None = None,
) -> DrawFilter:
    """The filter of a question "q1" that asks what the template asks, if nothing else is said."""
    deck = make_deck(template, secret, "q1", fixed or {})
    return DrawFilter(template, asks or template.asked(), deck, tolerances or {})


def dealt(draws: DrawFilter, places: int) -> Deal:
    """The question dealt to so many places."""
    filters = {"q1": draws}
    return deal(filters, places, partial(look_here, filters))["q1"]


def drawn(draws: DrawFilter, places: int) -> list[Drawn]:
    """The first good combinations, solved; from the first again where there are too few."""
    good = dealt(draws, places).positions
    values = [draws.deck.combination(good[place % len(good)]) for place in range(places)]
    return [Drawn(each, draws.dealt.solved(each)) for each in values]
