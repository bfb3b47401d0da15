"""Prose as LaTeX."""

from __future__ import annotations

import pytest

from kinegrade.language.prose.latex import write_prose


@pytest.mark.parametrize(
    ("markdown", "expected"),
    [
        ("The *crank* $OA$", r"The \emph{crank} $OA$"),
        ("a\n\n**b**", "a\n\n\\textbf{b}"),
        ("- a\n- $b$", "\\begin{itemize}\n\\item{} a\n\\item{} $b$\n\\end{itemize}"),
        ("3. a", "\\begin{enumerate}\\startat{3}\n\\item{} a\n\\end{enumerate}"),
        ("so $$x = 1$$", r"so \[x = 1\]"),
        ("the rod\nAB", "the rod\nAB"),
        ("曲柄\n转动", "曲柄%\n转动"),
        ("the slider's pin", "the slider’s pin"),
        (r"5 \$ \* \# &amp; \\input{x}", r"5 \$ * \# \& \textbackslash{}input\{x\}"),
    ],
)
def test_what_an_exam_needs(markdown: str, expected: str) -> None:
    assert write_prose(markdown, "q1") == expected
