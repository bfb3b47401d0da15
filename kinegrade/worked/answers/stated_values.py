"""A value that is stated once the motions that it refers to are found: of a function of the motion
whose derivation no textbook step shows.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinegrade.expressions.tree import Call, Name
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.problem.template.template import Ask
from kinegrade.worked.answers.asked_vectors import explain_vector
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.equation import Equation
from kinegrade.worked.formulas.numbers import state_quantity
from kinegrade.worked.formulas.symbols import read_symbol
from kinegrade.worked.vectors.needed_rates import find_references


def explain_value(ask: Ask, calls: Sequence[Call], case: Case) -> Iterator[Block]:
    """The motions of all points that the calls refer to, as far as they have not been found yet,
    and the answer.
    """
    for call in calls:
        changes = MOTION_FUNCTIONS[call.function].by_changes
        for body, point in find_references(call, case.reader).points:
            for function in ("velocity", "acceleration") if changes else ("velocity",):
                yield from explain_vector(Call(function, (Name(point), Name(body))), case)
    answer = case.solution.answers[ask.name]
    yield case.show(Equation(read_symbol(ask.symbol), state_quantity(answer)))
