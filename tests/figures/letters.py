"""The room that printed letters take, in em, by the proportions of a book face such as Times.

They are restated here so that nothing of the program's own estimate enters the proof.
"""

from __future__ import annotations

from collections.abc import Mapping

CAPITAL, TALL, LOW, DEEP = 0.66, 0.69, 0.45, 0.21  # heights above and below the baseline
RISING = "bdfhklitθβδλϕψζξϑ"
FALLING = "gjpqyβγημρφϕψχζξς,;"
WIDTHS: Mapping[str, float] = {
    **dict.fromkeys("ijlt", 0.29),
    **dict.fromkeys("fsrι", 0.38),
    **dict.fromkeys("cevzγ", 0.42),
    **dict.fromkeys("mwMWωΩ", 0.75),
    **dict.fromkeys("+−=<>", 0.66),
    **dict.fromkeys(",.;:'′ \u2009\u200a", 0.25),
    **dict.fromkeys("()I°", 0.34),
}
LOWERCASE, UPPERCASE = 0.5, 0.63


def measure_letters(text: str) -> tuple[float, float, float]:
    """The width of a text, and how far its ink rises above the baseline and falls below it."""
    width = sum(map(_find_width, text))
    return width, max(map(_find_rise, text), default=0.0), max(map(_find_fall, text), default=0.0)


def _find_width(letter: str) -> float:
    if letter in WIDTHS:
        return WIDTHS[letter]
    return UPPERCASE if letter.isupper() else LOWERCASE


def _find_rise(letter: str) -> float:
    if letter in RISING:
        return TALL
    if letter.isupper() or letter.isdigit() or letter in "()°′'":
        return CAPITAL
    return LOW


def _find_fall(letter: str) -> float:
    return DEEP if letter in FALLING or letter in "()Q" else 0.0
