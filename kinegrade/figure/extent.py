"""How much room a symbol takes on paper, estimated on the safe side from its LaTeX for all back ends."""

from __future__ import annotations

import re
from functools import lru_cache

FONT_SIZE = 9.0  # points
EM = FONT_SIZE * 0.352778  # millimetres

_TOKEN = re.compile(r"\\([A-Za-z]+)|([_^])|([{}])|(\s+)|(.)")
_NO_WIDTH = frozenset(("mathrm", "mathbf", "vec", "dot", "ddot", "bar", "prime"))
_WIDE = {
    "m": 0.92,
    "w": 0.78,
    "M": 1.05,
    "W": 1.05,
    "omega": 0.72,
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
def symbol_size(symbol: str) -> tuple[float, float]:
    """Width and height in millimetres of a LaTeX symbol at the figure's font size."""
    width, scripts, scripted, depth_of_script = 0.0, 0, False, -1
    depth = 0
    for command, script, brace, blank, character in _TOKEN.findall(symbol):
        if script:
            scripts, scripted, depth_of_script = scripts + 1, True, depth
            continue
        depth += {"{": 1, "}": -1}.get(brace, 0)
        if not brace and not blank:
            width += _advance(command or character) * (_SCRIPT if scripted else 1.0)
        if scripted and depth <= depth_of_script and not blank:
            scripted = False
    tall = 1.9 if "\\frac" in symbol else 1.0
    return (width + 0.12) * EM, (0.8 * tall + 0.28 * min(scripts, 2)) * EM


def _advance(name: str) -> float:
    if name in _NO_WIDTH:
        return 0.0 if name != "prime" else 0.3
    return _WIDE.get(name, _NARROW.get(name, 0.78 if name.isupper() else 0.62))
