"""One row of a student in a sheet of answers, and where it stands."""

from __future__ import annotations

from collections import Counter
from typing import NamedTuple

from kinegrade.deadlines.moment import parse_moment
from kinegrade.files.answer_file import Sources
from kinegrade.files.cell_text import is_answered, trim


class Place(NamedTuple):
    """Where something stands; `line` is None where no particular line is at fault."""

    file: str
    line: int | None


class OtherTime(NamedTuple):
    """Another time at which a student handed in, by another file than the first, and where it
    stands.
    """

    place: Place
    submitted: str


class Entry(NamedTuple):
    """One row of a student: the responses in the order of the asks; `line` is None where the
    student has no row.

    `whole` is the row as it came, where the student has several in its file. `put` holds for each
    ask the student whose line of the key it is marked by, "" for the student's own; it is empty
    where all are the student's own. `submitted` is when it was handed in, as far as that is known.
    `places` are those of the single responses, where they come from several files; `other_times`
    are those that do not count.
    """

    line: int | None
    responses: tuple[str, ...]
    whole: str = ""
    file: str = ""
    put: Sources = ()
    places: tuple[Place, ...] = ()
    submitted: str = ""
    other_times: tuple[OtherTime, ...] = ()

    def place(self, number: int) -> Place:
        """Where the response to an ask stands."""
        return self.places[number] if self.places else Place(self.file, self.line)

    def main_place(self) -> Place:
        """Where most of its answers stand, the first file where several have as many."""
        itself = Place(self.file, self.line)
        if not self.places:
            return itself
        both = zip(self.responses, self.places, strict=True)
        found = Counter(place for response, place in both if is_answered(response))
        return max(dict.fromkeys([itself, *found]), key=lambda place: found[place])

    def repeats(self, other: Entry) -> bool:
        """Whether it is the same submission once more: the same answers to the same papers, and no
        time that is another one.
        """
        mine, theirs = map(trim, self.responses), map(trim, other.responses)
        if self.put != other.put or tuple(mine) != tuple(theirs):
            return False
        times = {parse_moment(each) or each for each in (self.submitted, other.submitted) if each}
        return len(times) < 2
