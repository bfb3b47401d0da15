"""What the sentences of one description may name."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from tests.description.reader.names import plain

GROUND = "ground"


@dataclass
class Vocabulary:
    """The bodies by the words that name them, the numbers by their names."""

    bodies: dict[str, str]
    numbers: dict[str, float] = field(default_factory=dict)
    carried: dict[str, list[str]] = field(default_factory=dict)
    lengths: list[float] = field(default_factory=list)

    @property
    def words(self) -> dict[str, str]:
        """The bodies by their words, as they are within a sentence."""
        found = {lowered(words): body for body, words in self.bodies.items()}
        return found | {"the ground": GROUND}

    def body(self, words: str) -> str:
        """The body of that name."""
        return self.words[lowered(words)]

    def body_called(self, identifier: str) -> str:
        """The body of that identifier; where it was not told, one of its words is the same."""
        if identifier in self.bodies or identifier == GROUND:
            return identifier
        found = [body for body in self.bodies if identifier in map(plain, body.split())]
        if len(found) != 1:
            raise ValueError(f"body not known: {identifier} among {sorted(self.bodies)}")
        return found[0]

    def pattern_of_bodies(self) -> str:
        """A pattern that matches the name of any body."""
        words = sorted(self.words, key=len, reverse=True)
        return "(?:" + "|".join(re.escape(word) for word in words) + ")"

    def bodies_with(self, point: str) -> list[str]:
        """The bodies to which the point belongs."""
        return [body for body, points in self.carried.items() if point in points]


def lowered(words: str) -> str:
    """The words without a capital at their beginning."""
    return words[:1].lower() + words[1:]
