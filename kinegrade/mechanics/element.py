"""What every joint and every driver can say of itself."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator

from kinegrade.language.message import Message


class Element(ABC):
    """A joint or a driver: it names bodies and points, and has a name in messages."""

    @abstractmethod
    def list_bodies(self) -> tuple[str, ...]:
        """The bodies that it names, first the one that moves."""

    @abstractmethod
    def list_turning_bodies(self) -> tuple[str, ...]:
        """Those of its bodies that turn in it or carry its line or circle, which no particle
        can.
        """

    @abstractmethod
    def list_points(self) -> tuple[str, ...]:
        """The points that it names."""

    @abstractmethod
    def describe(self) -> Message:
        """It, as messages name it."""

    def find_nonsense(self) -> Iterator[Message]:
        """What makes it meaningless: that it is of a body with itself."""
        if len(set(self.list_bodies()[:2])) < 2:
            yield Message("mechanics.relative-to-itself")
