"""The room a symbol takes on paper, estimated from its LaTeX, never too small, for all back
ends.
"""

from __future__ import annotations

import re
from functools import lru_cache

FONT_SIZE = 9.0  # points
EM = FONT_SIZE * 0.352778  # millimetres

_TOKEN = re.compile(r"\\([A-Za-z]+)|([_^])|([{}])|(\s+)|(.)")
_NO_WIDTH = frozenset(("mathrm", "mathbf", "boldsymbol", "vec", "dot", "ddot", "bar", "prime"))
_WIDE = {
    "m": 0.92,
    "w": 0.78,
    "M": 1.05,
    "W": 1.05,
    "omega": 0.72,
    "infty": 1.05,
    "Omega": 0.82,
    "=": 1.35,
    "+": 1.3,
    "-": 1.3,
}
_NARROW = {
    "i": 0.4,
    "j": 0.45,
    "l": 0.38,
    "t": 0.42,
    ",": 0.45,
    ".": 0.33,
    "'": 0.3,
    "(": 0.42,
    ")": 0.42,
    "I": 0.55,
}
_SCRIPT = 0.72


@lru_cache(maxsize=1024)
def measure_symbol(symbol: str) -> tuple[float, float]:
    """Width and height in millimetres of a LaTeX symbol at the figure's font size."""
    width, scripts, depth, depth_of_script = 0.0, 0, 0, -1
    place, stack = "", {"_": 0.0, "^": 0.0}  # the scripts of one base stand one above the other
    for command, script, brace, blank, character in _TOKEN.findall(symbol):
        if script:
            scripts, place, depth_of_script = scripts + 1, place or script, depth
            continue
        depth += {"{": 1, "}": -1}.get(brace, 0)
        if not brace and not blank and place:
            stack[place] += _SCRIPT * _measure_advance(command or character)
        elif not brace and not blank:
            width, stack = (
                width + max(stack.values()) + _measure_advance(command or character),
                {"_": 0.0, "^": 0.0},
            )
        if depth <= depth_of_script and not blank:
            place = ""
    tall = 1.9 if "\\frac" in symbol else 1.0
    return (width + max(stack.values()) + 0.12) * EM, (0.8 * tall + 0.28 * min(scripts, 2)) * EM


def _measure_advance(name: str) -> float:
    if name in _NO_WIDTH:
        return {"prime": 0.3, "boldsymbol": 0.1}.get(name, 0.0)
    return _WIDE.get(name, _NARROW.get(name, 0.78 if name.isupper() else 0.62))
