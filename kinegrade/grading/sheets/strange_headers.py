"""What the header of a column that is no ask's may have been meant for."""

from __future__ import annotations

from collections.abc import Sequence

from kinegrade.ask_names import AskNames
from kinegrade.errors import find_nearest
from kinegrade.files.cell_text import make_header_key
from kinegrade.language.math.letters import GREEK


def find_numbered(title: str, columns: Sequence[str]) -> str | None:
    """The column that a number names in the bank's order, None where the title is no number: it is
    another question on each of shuffled papers.

    >>> find_numbered("1b", ["q1.v_B", "q1.a_B"])
    'q1.a_B'
    """
    named = AskNames(columns).find(title)
    if named is None or not named.ask or AskNames(columns, shuffled=True).find(title):
        return None
    return named.column


def find_meant(title: str, columns: Sequence[str]) -> list[str]:
    """The columns that are written most alike, the nearest first.

    >>> find_meant("Q1 ω_AB", ["q1.v_B", "q1.omega_AB"])
    ['q1.omega_AB']
    """
    key = make_header_key(title).replace(" ", ".")
    for name, letter in GREEK.items():
        key = key.replace(letter.character, name)
    return find_nearest(key, columns)
