"""Whether a value made of the numbers of a paper can be counted in the unit of an ask, as templates
are checked.
"""

from __future__ import annotations

from collections.abc import Mapping

from kinegrade.expressions.tree import Expression
from kinegrade.language.message import Message
from kinegrade.numbers.units import read_unit
from kinegrade.problem.kinds.dimension import find_dimension
from kinegrade.problem.kinds.kinds import Scalar, require_unit
from kinegrade.problem.kinds.signatures import ELEMENTARY
from kinegrade.problem.template.meaning.meaning import Scope

_ANGLES = ("deg", "rad")


def require_countable(
    tree: Expression, units: Mapping[str, str], unit: str, advice: Message
) -> None:
    """Raises FieldError for a value of another dimension than the unit's, and for plain numbers in
    place of angles; `units` are those of the names in it. Raises ExpressionError for an unknown
    unit.
    """
    kinds = {name: Scalar(find_dimension(read_unit(each))) for name, each in units.items()}
    angles = frozenset(name for name, each in units.items() if each in _ANGLES)
    kind = Scope(kinds, ELEMENTARY, frozenset(), angles).kind(tree)
    require_unit(kind, read_unit(unit), lambda _: advice)
