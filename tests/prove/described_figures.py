"""A figure in words prints the numbers of its statement and tells nothing that is asked, at any
draw, in every language, whatever is asked.
"""

from __future__ import annotations

from pathlib import Path
from random import Random

from tests.description.claims import find_faults
from tests.prove.draws import seeded_solution


def hold(seed: int, _: Path) -> None:
    """Read the descriptions of the instance of a seed: all that is asked by default, and a part."""
    solution = seeded_solution(seed)
    template = solution.template
    every = tuple(template.asks)
    part = tuple(Random(seed).sample(every, (len(every) + 1) // 2))
    for language in template.words.statement.languages:
        for asks in (template.asked(), part):
            faults = list(find_faults(solution, asks, language))
            assert faults == [], f"{template.name}, {language}, {asks}: {faults}"
