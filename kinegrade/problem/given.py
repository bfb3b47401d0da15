"""A given as a statement prints it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from kinegrade.language.math.units import append_unit
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.text import LATEX, write_angle
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.template.template import Template


@dataclass(frozen=True)
class Given:
    """A parameter of an instance with its symbol; as text "r = 0.25 m", in LaTeX math."""

    symbol: str
    quantity: Quantity

    @property
    def value(self) -> str:
        """The number with its unit, without the symbol."""
        return f"${_write_with_unit(self.quantity)}$"

    @property
    def size(self) -> str:
        """Symbol and value without the sign, for a sentence that says the sense."""
        return str(Given(self.symbol, self.quantity.size))

    def __str__(self) -> str:
        return f"${self.symbol} = {_write_with_unit(self.quantity)}$"


def list_givens(template: Template, parameters: Mapping[str, Quantity]) -> dict[str, Given]:
    """The givens of an instance by name."""
    return {
        name: Given(template.parameters[name].symbol, quantity)
        for name, quantity in parameters.items()
    }


def _write_with_unit(quantity: Quantity) -> str:
    """A quantity in LaTeX math: number and upright unit."""
    unit = quantity.measure
    if isinstance(quantity.number, Angle) and quantity.number.parts:
        return write_angle(quantity.number, degrees=False, form=LATEX)
    return append_unit(quantity.given_text, unit.text)
