"""What replacing an exam does to papers that may be printed: to their numbers, and to all else that
stands on them or is known of their students.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from msgspec import structs

from kinegrade.errors import OutputError
from kinegrade.exam.folder.contents import FORMULA_PAGES, FORMULA_TEXT, LOGO, TEMPLATES
from kinegrade.exam.folder.records import Candidate, ExamHead
from kinegrade.exam.roster.known_columns import Column
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.kept_exam import student_of
from kinegrade.language.message import Fault, Listing, Message, Text, list_plainly, list_statements

_SOURCES = ("*.toml", f"{TEMPLATES}/**/*.toml", LOGO, FORMULA_PAGES, FORMULA_TEXT)
_NAMED = 5  # students that a message names
_AS_PRINTED = Message("exam.papers-as-printed")


@dataclass(frozen=True)
class PaperChanges:
    """The students by what the replacement does to the numbers of their papers; `otherwise` says
    what else it sets in another way than the exam had it.
    """

    unchanged: tuple[str, ...]
    changed: tuple[str, ...]
    gone: tuple[str, ...]
    added: tuple[str, ...]
    otherwise: tuple[Text, ...] = ()

    @property
    def harmless(self) -> bool:
        """Whether every paper that exists keeps its numbers."""
        return not self.changed and not self.gone

    @property
    def summary(self) -> Message:
        """How many there are of each, in one line."""
        return Message(
            "exam.changes",
            count=len(self.unchanged),
            changed=len(self.changed),
            gone=len(self.gone),
            added=len(self.added),
        )

    def remarks(self) -> Iterator[Message]:
        """What papers that keep their numbers have otherwise from now on, in one line."""
        if self.harmless and self.otherwise:
            yield Message("exam.now-otherwise", what=list_statements(self.otherwise))

    def require_numbers_kept(self, folder: Path, uncorrected: Sequence[str]) -> None:
        """Raises OutputError where the numbers of a paper of that exam would change, or the paper
        of a student who is not in the roster be gone. Sources that are `uncorrected` are as they
        were before the exam was corrected.
        """
        if self.harmless:
            return
        what = Message(
            "exam.papers-would-change",
            changed=len(self.changed),
            papers=len(self.unchanged) + len(self.changed) + len(self.gone),
            gone=len(self.gone),
            names=_name_some([*self.changed, *self.gone]),
            added=len(self.added),
        )
        keep = Message("exam.keep-all" if self.gone else "exam.keep-sources")
        if uncorrected:
            names, corrected = list_plainly(uncorrected), str(folder)
            keep = Message("exam.keep-corrected", names=names, folder=corrected)
        raise OutputError(Fault(str(folder), what, _AS_PRINTED, keep))

    def require_rest_kept(self, folder: Path) -> None:
        """Raises OutputError where anything but numbers would be set otherwise."""
        if self.otherwise:
            what = Message("exam.would-be-otherwise", what=list_statements(self.otherwise))
            do = Message("exam.keep-or-accept")
            raise OutputError(Fault(str(folder), what, _AS_PRINTED, do))


def list_otherwise(old: Path, before: ExamHead, new: Path, after: ExamHead) -> Iterator[Text]:
    """What the exam folder `new` sets otherwise than `old` for students who are in both; the heads
    are theirs.
    """
    yield from _list_sources(old, new)
    if before.paper_size not in {"", after.paper_size}:
        sizes = before.paper_size, after.paper_size
        yield Message("exam.size-otherwise", before=sizes[0], after=sizes[1])
    students = {each.student: _spoken_to(each, after) for each in after.everybody}
    whose: dict[Column, list[str]] = {}
    for each in before.everybody:
        if each.student in students:
            known = _spoken_to(each, before)
            for column, here, there in compare_students(students[each.student], known):
                # An e-mail address is on no paper: a first one changes none
                if here != there and (there or column != "email"):
                    whose.setdefault(column, []).append(each.student)
    for column, names in whose.items():
        shown = _name_some(names)
        yield Message("exam.column-otherwise", column=column, count=len(names), names=shown)


def compare_students(one: Student, other: Student) -> Iterator[tuple[Column, str, str]]:
    """What a roster says of two students besides their ids, column by column."""
    yield "name", one.name, other.name
    yield "email", one.email, other.email
    yield "group", one.group, other.group
    yield "room", one.room, other.room
    yield "seat", one.seat, other.seat
    yield "language", one.language, other.language
    yield "extra-time", one.extra_time, other.extra_time
    yield "format", one.print_format, other.print_format


def _spoken_to(candidate: Candidate, head: ExamHead) -> Student:
    """A student with the language of the paper, which may be that of the exam."""
    return student_of(structs.replace(candidate, language=candidate.language or head.language))


def _list_sources(old: Path, new: Path) -> Iterator[Text]:
    """The bank, templates and other sources that do not state the same; remarks in them do not
    count.
    """
    for name in sorted(_find_sources(old) | _find_sources(new)):
        before, after = _read_source(old / name), _read_source(new / name)
        if isinstance(before, dict) and isinstance(after, dict):
            keys = [key for key in {**before, **after} if before.get(key) != after.get(key)]
            if keys:
                yield Message("exam.keys-otherwise", file=name, keys=list_plainly(keys))
        elif before != after:
            yield name


def _find_sources(folder: Path) -> set[str]:
    found = (file for pattern in _SOURCES for file in folder.glob(pattern))
    return {file.relative_to(folder).as_posix() for file in found}


def _read_source(file: Path) -> dict[str, object] | bytes | None:
    """What a source states; its bytes where it is no TOML, None where there is none."""
    if not file.is_file():
        return None
    content = file.read_bytes()
    try:
        return tomllib.loads(content.decode()) if file.suffix == ".toml" else content
    except ValueError:
        return content


def _name_some(students: Sequence[str]) -> Listing:
    return list_plainly([*students[:_NAMED], *(["..."] if len(students) > _NAMED else [])])
