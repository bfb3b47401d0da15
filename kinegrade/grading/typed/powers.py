"""Powers in typed values: as large as the engine raises, those of ten as large as numbers are."""

from __future__ import annotations

from kinegrade.expressions.evaluation import MAX_POWER
from kinegrade.expressions.reading import read_rational
from kinegrade.expressions.tree import Expression, Number, Operation
from kinegrade.grading.typed.number_text import LARGEST_EXPONENT, Unreadable
from kinegrade.language.message import Message


def raise_to(base: Expression, power: int) -> Expression:
    """base**power. Raises Unreadable for a power that is too large."""
    if isinstance(base, Number) and base.value == 10:
        _require_at_most(LARGEST_EXPONENT, power)
        return Number(base.value**power)
    _require_at_most(MAX_POWER, power)
    exponent: Expression = Number(read_rational(str(abs(power))))
    if power < 0:
        exponent = Operation("-", Number(read_rational("0")), exponent)
    return Operation("**", base, exponent)


def _require_at_most(most: int, power: int) -> None:
    if abs(power) > most:
        raise Unreadable(Message("typing.large-whole-power", most=most))
