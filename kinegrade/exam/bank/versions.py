"""Versions A, B, C of an exam: which there are, and who gets which."""

from __future__ import annotations

from kinegrade.draws.keyed_order import address

LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"


def list_version_letters(count: int) -> tuple[str, ...]:
    """The letters of `count` versions; none if every student gets a different paper."""
    return tuple(LETTERS[:count])


def choose_version(secret: str, place: int, letters: tuple[str, ...]) -> str:
    """The version of the student at a place, counted from zero.

    The places are dealt in rounds, each a shuffle of the versions: they are used equally often,
    give or take one, neighbours mostly differ, and a student who is added changes no one else's
    version.
    """
    turn, place_in_turn = divmod(place, len(letters))
    return sorted(letters, key=lambda letter: address(secret, "version", turn, letter))[
        place_in_turn
    ]
