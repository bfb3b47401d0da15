"""The ways one and the same unit is written: m/s^2, m/s², m·s⁻², m s^-2, m/s/s, ㎨.

Called by `answers`. It says whether two texts spell the same unit, not what a unit is worth.
"""

from __future__ import annotations

import re
from collections import Counter
from functools import lru_cache
from unicodedata import normalize

_ATOMS = {
    "sec": "s", "秒": "s",
    "米": "m", "厘米": "cm", "毫米": "mm",
    "弧度": "rad", "radian": "rad", "radians": "rad",
    "°": "deg", "degree": "deg", "degrees": "deg", "度": "deg",
}  # fmt: skip
_DEGREE_SIGNS = str.maketrans("º˚", "°°")  # the ordinal sign and the ring, next to ° on many keyboards
_MINUS_SIGNS = str.maketrans("\u2212\u2010\u2011\u2012\u2013\u2014", "------")
_DIVISION = str.maketrans("\u2044\u2215", "//")
_TIMES = "·⋅•∙・*\u00d7"
_FACTOR = re.compile(
    r"([^\W\d_]+|°)(?:\s*(?:\^|\*\*)\s*)?(?:([+-]?[0-9]+)|\(([+-]?[0-9]+)\)|\{([+-]?[0-9]+)\})?"
)
_LINK = re.compile(rf"\s*[{_TIMES}./]\s*|\s+|")


@lru_cache(maxsize=4096)
def same_unit(typed: str, unit: str) -> bool:
    """Whether `typed`, perhaps in brackets, spells `unit`; "1" is that of a pure number, spelled by nothing.

    >>> same_unit("m·s⁻²", "m/s^2"), same_unit("mm/s", "m/s")
    (True, False)
    """
    bare = _unbracketed(typed)
    if unit in ("", "1"):
        return not bare
    powers = _powers(bare)
    return bare == unit or (powers is not None and powers == _powers(unit))


def _unbracketed(typed: str) -> str:
    bare = typed.strip()
    if bare[:1] + bare[-1:] in ("()", "[]", "\uff08\uff09", "【】"):
        return bare[1:-1].strip()
    return bare


def _powers(text: str) -> dict[str, int] | None:
    """The power of each factor, `None` where the text is not written as a unit; a slash turns one factor."""
    folded = normalize("NFKC", text.translate(_DEGREE_SIGNS)).translate(_MINUS_SIGNS).translate(_DIVISION)
    powers: Counter[str] = Counter()
    place, link = 0, ""
    while found := _FACTOR.match(folded, place):
        name, *written = found.groups()
        power = int(next((digits for digits in written if digits), "1"))
        powers[_ATOMS.get(name, name)] += -power if link == "/" else power
        if found.end() == len(folded):
            return dict(powers)
        step = _LINK.match(folded, found.end())
        link = step[0].strip() if step else ""
        place = step.end() if step else found.end()
    return None
