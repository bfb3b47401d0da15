"""What the exams of a term are called: by the folders of their marks."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from kinegrade.errors import TableError
from kinegrade.language.message import Fault, Message
from kinegrade.marks_folder.folder import MarksFolder


def require_different(folders: Sequence[Path]) -> None:
    """Raises TableError for a folder that is given twice, by whatever path."""
    places = [folder.resolve() for folder in folders]
    twice = [
        folder for folder, place in zip(folders, places, strict=True) if places.count(place) > 1
    ]
    if twice:
        raise TableError(Fault(str(twice[-1]), Message("term.folder-twice")))


def name_folders(folders: Sequence[Path]) -> tuple[str, ...]:
    """A name for each folder: its own, or that of the folder around it where several have one name;
    else its path. Raises TableError where a folder is given twice.

    >>> name_folders([Path("HW1/MARKS"), Path("HW2/MARKS")])
    ('HW1', 'HW2')
    >>> name_folders([Path("HOMEWORK"), Path("FINAL")])
    ('HOMEWORK', 'FINAL')
    """
    require_different(folders)
    places = [folder.resolve() for folder in folders]
    own = tuple(place.name for place in places)
    around = tuple(place.parent.name for place in places)
    for names in (own, around):
        if len(set(names)) == len(names) and (len(names) > 1 or names is own):
            return names
    return tuple(map(str, folders))


def require_different_exams(folders: Iterable[MarksFolder]) -> None:
    """Raises TableError where two folders have marks of one exam, as far as they say of which."""
    known: dict[str, MarksFolder] = {}
    for folder in folders:
        first = known.setdefault(folder.exam, folder) if folder.exam else folder
        if first is not folder:
            what = Message("term.exam-twice", first=str(first.path))
            raise TableError(Fault(str(folder.path), what, do=Message("term.leave-one-out")))
