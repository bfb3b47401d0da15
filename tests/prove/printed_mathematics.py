"""What a worked solution prints is true as a student reads it: equal, rounded as it says, with
units, of known symbols, at any draw.
"""

from __future__ import annotations

from pathlib import Path

from kinegrade.worked.solution import write_worked_solution
from tests.prove.draws import seeded_solution
from tests.worked.reader.known import KNOWN, RARE
from tests.worked.reader.laws import find_faults


def hold(seed: int, _: Path) -> None:
    """Read the solution of the instance of a seed, in one language after the other."""
    solution = seeded_solution(seed)
    template = solution.template
    languages = template.words.statement.languages
    document = write_worked_solution(solution, template.asked(), languages[seed % len(languages)])
    for fault in find_faults(document.blocks, solution):
        excused = KNOWN[fault.law] | RARE.get(fault.law, frozenset())
        assert template.name in excused, f"{template.name}: {fault.law}: {fault.line}"
