"""Both typesetters, for tests of what each prints; where TeX is missing, those of LaTeX fail."""

from __future__ import annotations

import pytest

LATEX = pytest.mark.needs_tex
ENGINES = ["typst", pytest.param("latex", marks=LATEX)]


def pair_with_engines(*values: str) -> list[object]:
    """Each of these with Typst, then each with LaTeX."""
    return [
        *(pytest.param(value, "typst") for value in values),
        *(pytest.param(value, "latex", marks=LATEX) for value in values),
    ]
