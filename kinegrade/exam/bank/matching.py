"""A different template for each question that is drawn, where that is possible: a matching in a
bipartite graph.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence


def match_slots(wanted: Mapping[str, Sequence[str]]) -> dict[str, str]:
    """A name for as many slots as can have one, no name twice: the first that is free, or one that
    is made free.

    >>> match_slots({"q1": ["crank", "cam"], "q2": ["crank"], "q3": ["cam"]})
    {'q2': 'crank', 'q1': 'cam'}
    """
    holders: dict[str, str] = {}
    for slot, names in wanted.items():
        free = next((name for name in names if name not in holders), None)
        if free is not None:
            holders[free] = slot
        else:
            _displace(slot, wanted, holders, set())
    return {slot: name for name, slot in holders.items()}


def _displace(
    slot: str, wanted: Mapping[str, Sequence[str]], holders: dict[str, str], tried: set[str]
) -> bool:
    """Let a slot take a name whose holder can take another one, and return whether that was
    possible (Kuhn's algorithm).
    """
    for name in wanted[slot]:
        if name in tried:
            continue
        tried.add(name)
        if name not in holders or _displace(holders[name], wanted, holders, tried):
            holders[name] = slot
            return True
    return False
