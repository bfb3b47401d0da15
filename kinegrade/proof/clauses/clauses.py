"""What the sentences of a statement say of parts that they name by letters or nouns, and which the
mechanism contradicts in every way in which they can be read.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinegrade.language.message import Fault
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template
from kinegrade.proof.clauses.bars import find_wrong_bars
from kinegrade.proof.clauses.counts import find_wrong_counts
from kinegrade.proof.clauses.goings import find_wrong_goings
from kinegrade.proof.clauses.guides import find_wrong_guides
from kinegrade.proof.clauses.orders import find_wrong_orders
from kinegrade.proof.clauses.ropes import find_wrong_ropes
from kinegrade.proof.clauses.sides import find_wrong_sides
from kinegrade.proof.clauses.teeth import find_misplaced_teeth


def find_false_clauses(template: Template, examples: Sequence[Solution]) -> Iterator[Fault]:
    """A fault for each of them; nothing is known without an instance."""
    if not examples:
        return
    found = (
        *find_wrong_sides(template, examples),
        *find_wrong_goings(template, examples),
        *find_wrong_counts(template, examples),
        *find_wrong_orders(template, examples),
        *find_wrong_guides(template, examples),
        *find_wrong_bars(template, examples),
        *find_wrong_ropes(template, examples),
        *find_misplaced_teeth(template),
    )
    yield from (Fault("statement", what) for what in dict.fromkeys(found))
