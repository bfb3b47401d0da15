"""Only symbols of the small alphabet reach a back end."""

from __future__ import annotations

from kinegrade.errors import TypesetError
from kinegrade.language.message import Fault
from kinegrade.problem.template.symbols import find_symbol_fault


def require_symbol(symbol: str) -> None:
    """Raises TypesetError for a label that is not a LaTeX symbol."""
    fault = find_symbol_fault(symbol)
    if fault is not None:
        raise TypesetError(Fault("figure.labels", fault))
