"""What is filled into the slots of a statement at an instance's values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import assert_never

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.problem.driven_words import describe_driven
from kinegrade.problem.given import Given
from kinegrade.problem.template.driven import Drives
from kinegrade.problem.template.slots import Slot, split_slots


@dataclass(frozen=True)
class Filling:
    """The givens and what is driven, in one language; without `changes` nothing is said of
    accelerations of what is driven.
    """

    givens: Mapping[str, Given]
    driven: Drives
    changes: bool
    language: Language

    def fill(self, text: str, texts: Mapping[str, str]) -> str:
        """A text with its slots filled in, which name what there is, for the template was read."""
        return "".join(
            one if isinstance(one, str) else self._write(one, texts) for one in split_slots(text)
        )

    def _write(self, slot: Slot, texts: Mapping[str, str]) -> str:
        """The text that replaces a slot."""
        match slot.part:
            case "":
                return texts[slot.name] if slot.name in texts else str(self.givens[slot.name])
            case "value":
                return self.givens[slot.name].value
            case "size":
                return self.givens[slot.name].size
            case "turning" | "moving":
                driven = self.driven[slot.part][slot.name]
                said = describe_driven(driven, self.givens, changes=self.changes)
                return open_catalogue(self.language).write(said)
            case _:
                assert_never(slot.part)
