"""What the reader of a practice sheet has to know: units, senses, and the words for them in all
languages, as `kinegrade.grading.typed` reads them.
"""

from __future__ import annotations

from typing import Any

from kinegrade.grading.typed.sense import SENSE_WORDS
from kinegrade.grading.typed.unit_spelling import SHORT_UNITS, list_unit_names
from kinegrade.language.message import Message
from kinegrade.language.spellings import is_written_apart, list_spellings
from kinegrade.numbers.units import TYPED

_WORDS = {
    "about": Message("marking.about"),
    "root": Message("typing.root"),
    "squared": Message("typing.squared"),
    "square": Message("typing.square"),
    "cycles": Message("typing.turns-per-second"),
}


def list_vocabulary() -> dict[str, Any]:
    """The words by what they mean; for each unit its size, the power of pi in it, and what it
    measures.
    """
    return {
        "words": {name: list_spellings(entry) for name, entry in _WORDS.items()},
        "per": [(word, is_written_apart(word)) for word in list_spellings(Message("typing.per"))],
        "senses": {name: list_spellings(entry) for name, entry in SENSE_WORDS.items()},
        "names": dict(list_unit_names()),
        "short": dict(SHORT_UNITS),
        "units": dict(
            map(_describe_unit, sorted(set(list_unit_names().values()) - {*SHORT_UNITS}))
        ),
    }


def _describe_unit(name: str) -> tuple[str, tuple[float, int, str]]:
    scale, dimension = TYPED[name]
    return name, (float(scale.rational), scale.power, dimension)
