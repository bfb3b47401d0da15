"""A deck holds every combination once, in an order of its secret."""

from __future__ import annotations

from kinegrade.draws.deck import Deck, make_deck
from tests.problem.crank import crank

DOMAINS = {"r": ("1", "2", "3"), "h": ("0", "1/2"), "omega": ("2", "sqrt(2)", "3", "4")}


def order(deck: Deck) -> list[tuple[str, ...]]:
    return [tuple(values.values()) for values in deck.first(deck.size)]


def test_a_deck_holds_every_combination_once() -> None:
    deck = Deck(DOMAINS, "spring", "q1")
    assert deck.size == 24
    assert set(order(deck)) == {
        (r, h, o) for r in "123" for h in ("0", "1/2") for o in DOMAINS["omega"]
    }
    assert list(deck.combination(7)) == ["r", "h", "omega"]


def test_secret_and_question_decide_the_order() -> None:
    decks = (
        Deck(DOMAINS, "spring", "q1"),
        Deck(DOMAINS, "Spring", "q1"),
        Deck(DOMAINS, "spring", "q2"),
    )
    first, second, third = map(order, decks)
    assert first != second != third != first


def test_its_secret_is_not_shown() -> None:
    assert "spring" not in repr(Deck(DOMAINS, "spring", "q1"))


def test_a_template_without_a_choice_has_one_combination() -> None:
    assert Deck({}, "spring", "q1").first(3) == [{}]


def test_the_domains_of_a_template_are_replaced_by_name() -> None:
    deck = make_deck(crank(), "spring", "q1", {"h": ("7",)})
    assert deck.domains == {"r": ("1", "2"), "h": ("7",), "omega": ("2", "1000000", "20000000")}
    assert {values["h"] for values in deck.first(6)} == {"7"}
    assert len(deck.first(100)) == deck.size == 6
