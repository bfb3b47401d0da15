"""What a statement says in words that the mechanism contradicts: where points lie, which way things
turn and move, what is at rest or constant.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinegrade.language.message import Fault
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.angles import find_wrong_angles
from kinegrade.proof.claims.places import find_wrong_places
from kinegrade.proof.claims.senses import find_wrong_senses
from kinegrade.proof.claims.states import find_wrong_states


def find_false_claims(template: Template, examples: Sequence[Solution]) -> Iterator[Fault]:
    """A fault for each claim of the statement that these instances contradict."""
    found = (
        *find_wrong_places(template, examples),
        *find_wrong_senses(template, examples),
        *find_wrong_angles(template, examples),
        *find_wrong_states(template, examples),
    )
    yield from (Fault("statement", what) for what in dict.fromkeys(found))
