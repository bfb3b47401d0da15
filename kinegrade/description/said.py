"""What is said of a figure, as a page has it: it loads nothing of how that is found."""

from __future__ import annotations

from typing import TYPE_CHECKING

from msgspec import Struct

from kinegrade.language.prose.plain import write_prose

if TYPE_CHECKING:
    from kinegrade.worked.document import Prose


class Description(Struct, frozen=True):
    """A figure in words.

    `short` is plain text of at most 125 characters. `long` is paragraphs of prose with formulas
    between dollar signs: axes and givens, bodies, joints, positions, motions.
    """

    short: str
    long: tuple[Prose, ...]

    def __str__(self) -> str:
        """The long text without marks of formulas, a line for each paragraph."""
        return "\n".join(write_prose(part.text, "description") for part in self.long)
