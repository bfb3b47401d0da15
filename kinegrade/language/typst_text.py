"""Plain text into Typst: whatever it holds is printed and never executed."""

from __future__ import annotations

import re

# All of Unicode's Cc, Zl, Zp and Cs
_CONTROL = re.compile("[\\x00-\\x1f\\x7f-\\x9f\\u2028\\u2029\\ud800-\\udfff]")


def write_literal(text: str) -> str:
    """`text` as a Typst string literal, whatever it contains; control characters become spaces.

    >>> print(write_literal('a "b" #read(1)'))
    "a \\"b\\" #read(1)"
    """
    return '"' + _CONTROL.sub(" ", text).replace("\\", "\\\\").replace('"', '\\"') + '"'
