"""What is said of a figure to those who cannot see it: the one place that all pages ask."""

from __future__ import annotations

import re

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.math.spoken.speaking import speak_math

_FORMULA = re.compile(r"\$([^$]+)\$")


def describe_figure(title: str, language: Language) -> str:
    """The alternative text of a figure, by the title of its question or by its caption (prose).

    >>> describe_figure("Slider-crank with crank $O_1A$", Language("en"))
    'Figure to scale: Slider-crank with crank O 1 A'
    """
    said = _FORMULA.sub(lambda found: speak_math(found[1], title, language), title)
    return open_catalogue(language).text("paper.figure", title=said)
