"""Faults of a template's expressions, as its author reads them."""

from __future__ import annotations

import pytest

from kinegrade.errors import TemplateError
from tests.problem.crank import crank

PUBLISHED = 'gives = { v_x = "-omega*h" }'
ON_REQUEST = '\n[asks]\nw = { quantity = "%s", unit = "%s", means = { en = "w", zh = "w 量" } }\n'


def faults(*changes: tuple[str, str]) -> list[str]:
    """What reading the changed crank refuses."""
    with pytest.raises(TemplateError) as refusal:
        crank(*changes)
    return list(refusal.value.problems)


def asking(quantity: str, unit: str) -> list[str]:
    """What reading the crank refuses when something further may be asked for on request."""
    return faults(("\n[asks]\n", ON_REQUEST % (quantity, unit)))
