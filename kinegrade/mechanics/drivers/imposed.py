"""Which laws a driver imposes."""

from __future__ import annotations

from kinegrade.mechanics.laws import Imposed, Law


def select_imposed(law: Law | None) -> Imposed | None:
    """The law itself where a driver imposes it; None for one of joints, and for none."""
    return law if isinstance(law, Imposed) else None
