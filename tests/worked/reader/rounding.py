"""How far rounding may have moved what is printed."""

from __future__ import annotations

from tests.worked.reader.amounts import Amount
from tests.worked.reader.equations import Side
from tests.worked.reader.forms import is_decimal, measure_last_digit


def find_room(side: Side, amount: Amount) -> float:
    """How far rounding may have moved a side of an equation: a decimal by its last digit."""
    if side.relation == r"\approx" and is_decimal(side.row) and amount.value:
        return max(amount.room, measure_last_digit(side.row, amount.value) / 2)
    return amount.room
