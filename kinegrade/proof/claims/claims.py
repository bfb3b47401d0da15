"""What a statement says in words that the mechanism contradicts: where points lie, which way things
turn and move, what is at rest or constant.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinegrade.language.message import Fault
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.angles import find_wrong_angles
from kinegrade.proof.claims.circles import find_wrong_circles
from kinegrade.proof.claims.formulas import find_wrong_formulas
from kinegrade.proof.claims.givens import find_wrong_givens
from kinegrade.proof.claims.inclinations import find_wrong_inclinations
from kinegrade.proof.claims.kinds import find_marks_of_other_kinds, find_wrong_signs
from kinegrade.proof.claims.lines import find_wrong_lines
from kinegrade.proof.claims.means import find_wrong_means
from kinegrade.proof.claims.paces import find_wrong_paces, find_wrong_references
from kinegrade.proof.claims.places import find_wrong_places
from kinegrade.proof.claims.senses import find_wrong_senses
from kinegrade.proof.claims.states import find_wrong_states
from kinegrade.proof.claims.swaps import find_swapped_givens
from kinegrade.proof.claims.wheels import find_wrong_wheels


def find_false_claims(template: Template, examples: Sequence[Solution]) -> Iterator[Fault]:
    """A fault for each claim of a template's words and marks that these instances contradict."""
    said = (
        *find_wrong_places(template, examples),
        *find_wrong_lines(template, examples),
        *find_wrong_formulas(template, examples),
        *find_wrong_inclinations(template, examples),
        *find_wrong_senses(template, examples),
        *find_wrong_paces(template, examples),
        *find_wrong_references(template),
        *find_wrong_angles(template, examples),
        *find_wrong_states(template, examples),
        *find_swapped_givens(template),
        *find_wrong_wheels(template, examples),
    )
    found = (
        *(Fault("statement", what) for what in said),
        *find_wrong_circles(template, examples),
        *find_wrong_givens(template, examples),
        *find_wrong_signs(template),
        *find_wrong_means(template, examples),
        *find_marks_of_other_kinds(template),
    )
    yield from dict.fromkeys(found)
