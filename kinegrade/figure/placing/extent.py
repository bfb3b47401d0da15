"""The room a symbol takes on paper, estimated from its LaTeX, never too small, for all back
ends.
"""

from __future__ import annotations

from functools import lru_cache

from kinegrade.language.math.label_size import measure_label
from kinegrade.language.math.reading import read_math

FONT_SIZE = 9.0  # points
EM = FONT_SIZE * 0.352778  # millimetres


@lru_cache(maxsize=1024)
def measure_symbol(symbol: str) -> tuple[float, float]:
    """Width and height in millimetres of a LaTeX symbol at the figure's font size.

    Raises TypesetError for what is not LaTeX math.
    """
    width, height = measure_label(read_math(symbol, "figure.labels"))
    return width * EM, height * EM
