"""About how wide prose is, of which `$...$` is math."""

from __future__ import annotations

from functools import lru_cache

from kinegrade.language.math.printed_size import FIRST_CHINESE, measure_printed, measure_words
from kinegrade.worked.document import list_formulas

_LATIN = 0.84  # the letters of text relative to those of formulas; Chinese ones are alike


@lru_cache(maxsize=4096)
def measure_text(text: str) -> float:
    """About how wide prose is on one line, in em."""
    words = "".join(text.split("$")[::2])
    latin = "".join(character for character in words if character < FIRST_CHINESE)
    formulas = sum(measure_printed(row).width for row in list_formulas(text))
    return _LATIN * measure_words(latin) + len(words) - len(latin) + formulas


@lru_cache(maxsize=4096)
def measure_formula_height(text: str) -> float:
    """How high the highest formula of prose is, in em; 0 where it has none."""
    return max((measure_printed(row).height for row in list_formulas(text)), default=0.0)
