r"""LaTeX math for LaTeX: what the closed list of `kinegrade.exam.formula` lets through, and nothing
that TeX would execute.

That list does not cover comments (`%`), characters by their codes (`^^5c` is a backslash) and
`\begin` without braces, all of which TeX understands; they are refused here. Texts inside a formula
are escaped as plain text.
"""

from __future__ import annotations

import re
from functools import lru_cache

from kinegrade.errors import TypesetError, write_message
from kinegrade.exam.formula import TEXT, formula_place, require_known_math
from kinegrade.exam.latex_text import write_unit

_COMMENT = re.compile(r"(?<!\\)(?:\\\\)*%")
_CODED = re.compile(r"\^\s*\^")
_ENVIRONMENT = re.compile(r"\\(?:begin|end)(?!\{(?:cases|aligned)\}|[A-Za-z])")
_DOORS = (
    (_COMMENT, "% in math", "a percent sign that starts no comment", "write \\%"),
    (_CODED, "^ after ^", "one thing after each ^", "write ^{...}"),
    (
        _ENVIRONMENT,
        "\\begin or \\end without braces",
        "braces right after it",
        "write \\begin{cases} or \\begin{aligned}",
    ),
)


@lru_cache(maxsize=4096)
def write_math(latex: str, where: str) -> str:
    r"""LaTeX math without dollar signs, on one line.

    Raises TypesetError naming `where` and every fault.

    >>> print(write_math(r"v = 2\,\unit{m/s^2}", "q1"))
    v = 2\,\text{m/s\textsuperscript{2}}
    """
    outside = TEXT.sub(" ", require_known_math(latex, where))
    problems = [
        write_message(formula_place(latex, where), what, expected, do)
        for door, what, expected, do in _DOORS
        if door.search(outside)
    ]
    if problems:
        raise TypesetError(*problems)
    return " ".join(TEXT.sub(_write_text, latex).split())


def _write_text(found: re.Match[str]) -> str:
    comma = found[2]
    return "{,}" if comma else rf"\text{{{write_unit(found[1])}}}"
