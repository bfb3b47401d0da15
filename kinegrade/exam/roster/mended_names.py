"""The names of a roster without signs that would turn what is printed behind them."""

from __future__ import annotations

from collections.abc import Sequence

from kinegrade.files.cell_text import DIRECTIONS
from kinegrade.language.message import Message, Quoted

_TURNING = str.maketrans(dict.fromkeys(DIRECTIONS))


def mend_names(names: Sequence[str]) -> tuple[Sequence[str], Sequence[Message]]:
    """The names, and what was taken away from them.

    Joiners stay, as names in some scripts are written with them.

    >>> mend_names(["Ada \\u202eByron"])[0]
    ['Ada Byron']
    """
    mended = [name.translate(_TURNING) for name in names]
    turned = [name for name, rest in zip(names, mended, strict=True) if name != rest]
    if not turned:
        return names, ()
    first = Quoted(turned[0])
    return mended, (Message("roster.directions-taken-away", count=len(turned), name=first),)
