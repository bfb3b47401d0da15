"""What every joint and every driver can say of itself."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator

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


def require_attributes(element: type[Element], names: Iterable[str]) -> None:
    """Refuse a class of joints or drivers that lacks an attribute, unless it lacks a method as well
    and so can be a base only. Raises TypeError.
    """
    lacking = [name for name in names if not hasattr(element, name)]
    if lacking and not _is_abstract(element):
        raise TypeError(f"{element.__name__} lacks {', '.join(lacking)}")


def _is_abstract(element: type[Element]) -> bool:
    """Whether a class still lacks a method; Python notes it only after the class is made."""
    members = (getattr(element, name, None) for name in dir(element))
    return any(getattr(member, "__isabstractmethod__", False) for member in members)
