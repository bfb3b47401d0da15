"""The words of a practice sheet: what its script says, in the language of the page."""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.language import Language
from kinegrade.language.catalogue import FORM_SEPARATOR, open_catalogue
from kinegrade.language.entries import NOUN, read_entries

_PRACTICE = (
    "numbers", "score", "hint", "blank", "unreadable", "wrong-unit", "right", "wrong",
    "follow-through", "no-following", "read-as", "close", "earned", "earned-spoilt", "too-long",
)  # fmt: skip
_GUESSES = (
    "either-mistake", "opposite", "twice", "half", "degrees-for-radians", "radians-for-degrees",
    "turns-per-minute", "turns-per-second", "too-large", "too-small", "turned-as-well",
)  # fmt: skip


@dataclass(frozen=True)
class PracticeWording:
    """`texts` by key, of which the `nouns` have `forms`, and what stands before decimals."""

    texts: dict[str, str]
    nouns: tuple[str, ...]
    forms: tuple[str, ...]
    mark: str


def collect_wording(language: Language) -> PracticeWording:
    """What the script says; of what is said on reading, all but the spellings that are read."""
    catalogue = open_catalogue(language)
    motion = catalogue.raw("motion")
    practice, feedback = catalogue.raw("practice"), catalogue.raw("feedback")
    entries = read_entries(language, "typing").entries
    nouns = [key.partition(".")[2] for key, entry in entries.items() if NOUN in entry.flags]
    reading = {
        key: text
        for key, text in catalogue.raw("typing").items()
        if key in nouns or FORM_SEPARATOR not in text
    }
    return PracticeWording(
        {
            **reading,
            **{key: feedback[key] for key in _GUESSES},
            **{key: motion[key] for key in ("play", "stop")},
            **{key: practice[key] for key in _PRACTICE},
        },
        tuple(nouns),
        catalogue.forms,
        catalogue.decimal_mark,
    )
