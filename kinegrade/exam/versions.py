"""Versions A, B, C of an exam: which there are, and who gets which."""

from __future__ import annotations

from kinegrade.problem.keyed_order import address

LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"


def version_letters(count: int) -> tuple[str, ...]:
    """The letters of `count` versions; none where every student gets an own paper."""
    return tuple(LETTERS[:count])


def version_of(secret: str, place: int, letters: tuple[str, ...]) -> str:
    """The version of the student at a place of the roster, counted from zero.

    The roster is dealt in rounds, each a shuffle of the versions: they are used equally often, but
    for one, students next to each other mostly differ, and a student who is appended changes
    nobody's version.
    """
    turn, place_in_turn = divmod(place, len(letters))
    return sorted(letters, key=lambda letter: address(secret, "version", turn, letter))[
        place_in_turn
    ]
