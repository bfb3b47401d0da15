"""What files are called that hold the papers of several students each: those of a room, a group."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass

from kinegrade.exam.roster.students import make_room_stems

_SPARE = "spare"


@dataclass(frozen=True)
class VolumeNames:
    """The stem of each one's file, "" among them for students who are in none, and that of spare
    papers; no two are the same.
    """

    stems: Mapping[str, str]
    spare: str


def name_volumes(names: Iterable[str], without: str) -> VolumeNames:
    """The stems of files for these rooms or groups; `without` is that of students who are in none.

    >>> names = name_volumes(["Hall 7", "Spare"], "without-room")
    >>> names.stems
    {'Hall 7': 'Hall-7', 'Spare': 'Spare', '': 'without-room'}
    >>> names.spare
    'spare-'
    """
    stems = make_room_stems(name for name in names if name)
    without = _name_apart(without, stems.values())
    return VolumeNames({**stems, "": without}, _name_apart(_SPARE, [*stems.values(), without]))


def _name_apart(stem: str, taken: Collection[str]) -> str:
    """This stem, with as many lines behind it as it takes to be no other's."""
    others = {each.casefold() for each in taken}
    while stem in others:
        stem += "-"
    return stem
