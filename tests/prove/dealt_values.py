"""Every value that a shipped template lists is dealt to somebody: none is kept from all papers by
its figure alone, which nobody would notice.
"""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from kinegrade.draws.examining import Refused
from tests.problem.draws import draw_filter
from tests.prove.draws import seeded_template

COMBINATIONS = 400
ENOUGH = 12  # combinations with a value that are refused for their figure, and none that is not


def hold(seed: int, _: Path) -> None:
    """Examine combinations of the template of a seed."""
    template = seeded_template(seed)
    examined = draw_filter(template, f"prove {seed}")
    deck = examined.deck
    combinations = [deck.combination(each) for each in range(min(COMBINATIONS, deck.size))]
    dealt: Counter[tuple[str, str]] = Counter()
    illegible: Counter[tuple[str, str]] = Counter()
    for values, found in zip(combinations, examined.examine(combinations), strict=True):
        if not isinstance(found, Refused):
            dealt.update(values.items())
        elif found.reason == "figure":
            illegible.update(values.items())
    never = [each for each, count in illegible.items() if count >= ENOUGH and not dealt[each]]
    assert never == [], f"{template.name}: {never}"
