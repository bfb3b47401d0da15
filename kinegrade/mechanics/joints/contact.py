"""A smooth contact of two profiles."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

from kinegrade.language.message import Message
from kinegrade.mechanics.joints.constraint import Unrelated
from kinegrade.mechanics.joints.touching_pair import TouchingPair
from kinegrade.mechanics.sentence import INSIDE, OF, ON_SHAPE, JointParts
from kinegrade.mechanics.shapes import Profile


@dataclass(frozen=True)
class Contact(TouchingPair, Unrelated):
    """A circle of `body` touches a line or circle of the body `of` and may slide on it (smooth
    contact); `of_curvature` where of the profile of `body` only that circle of curvature is known.
    """

    of_curvature: bool = False

    PATTERN = (
        r"(?P<circle>circle\(.+?\))(?P<curvature> of curvature)? of (?P<body>\w+) "
        rf"touches {ON_SHAPE}{OF}{INSIDE}"
    )
    FORM = "CIRCLE [of curvature] of BODY touches LINE|CIRCLE [of BODY] [inside]"
    EXAMPLES = (
        "circle(C, R) of cam touches line(A, 0) of BC",
        "circle(K, rho) of curvature of cam touches line(A, 0) of BC",
    )
    SLIPS = ()

    @classmethod
    def make(cls, parts: JointParts) -> Self:
        """The joint that a sentence states."""
        options = parts.options
        return cls(
            parts.body,
            parts.circle,
            parts.of,
            parts.on,
            inside="inside" in options,
            of_curvature="curvature" in options,
        )

    def find_profile(self) -> Profile:
        """That of `body`."""
        return Profile(self.body, self.of_curvature)

    def list_turning_bodies(self) -> tuple[str, ...]:
        """The body that carries the line or circle."""
        return (self.of,)

    def describe(self) -> Message:
        """It, as messages name it."""
        return Message("mechanics.contact", body=self.body, of=self.of)
