"""Problems from textbooks that are not shipped: what they need, no shipped one shows."""

from __future__ import annotations

from pathlib import Path

from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.template import Template

PROBLEMS = Path(__file__).parent.parent / "data" / "problems"


def load_problem(name: str) -> Template:
    """The one of that name in `tests/data/problems`."""
    return load_template(name, PROBLEMS)
