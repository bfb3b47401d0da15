"""Where LaTeX is not installed, the instructor is told what to do."""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.errors import TypesetError
from kinegrade.press.latex.press import LatexPress
from tests.press.papers import ENGLISH


def test_without_latex_the_way_out_is_named(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(TypesetError) as refusal:
        LatexPress().papers({"s": ENGLISH})
    assert refusal.value.problems == (
        "latex: xelatex not found - expected a TeX installation - run make tools, or install TeX "
        "Live with LaTeX, TikZ, XeTeX and xeCJK, or use --engine typst",
    )
