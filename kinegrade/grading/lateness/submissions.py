"""When students handed in, from what the files of answers say of it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime, timedelta

from kinegrade.deadlines.moment import parse_moment, write_moment
from kinegrade.errors import TableError
from kinegrade.files.cell_text import is_answered, shorten
from kinegrade.files.tables import Complaint
from kinegrade.grading.lateness.rule import LateRule, Penalties
from kinegrade.grading.sheets.entry import Entry
from kinegrade.grading.sheets.sheet import Sheet
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.marks_folder.rows import Submission

_IN_TIME = timedelta(0)
_MOST_NAMED = 20


@dataclass(frozen=True, slots=True)
class Submissions:
    """The submissions of a class by the penalties of its policy."""

    penalties: Penalties

    def find(self, student: str, entries: Sequence[Entry], counted: Entry) -> Submission:
        """That of the entry that counts; the others before it were tries if they had answers."""
        place = next(number for number, each in enumerate(entries) if each is counted)
        before = _count_others(entries[:place], counted)
        late, moment = self.penalties.late, parse_moment(counted.submitted)
        if late is None or moment is None:
            return Submission(moment, None, _IN_TIME, before)
        due = late.find_due(student)
        return Submission(moment, due, _find_lateness(moment, due, late), before)


def _find_lateness(moment: datetime, due: datetime, rule: LateRule) -> timedelta:
    """How long after the due date something was handed in, nothing within the grace; a time without
    its difference from UTC is in that of the due date.
    """
    if moment.tzinfo is None and due.tzinfo is not None:
        moment = moment.replace(tzinfo=due.tzinfo)
    return moment - due if moment > due + rule.grace else _IN_TIME


def _count_others(entries: Sequence[Entry], counted: Entry) -> int:
    """How many submissions there are among entries beside the one that counts; a row that stands
    twice is one.
    """
    submissions = [counted]
    for each in entries:
        if _has_answers(each) and not any(map(each.repeats, submissions)):
            submissions.append(each)
    return len(submissions) - 1


def _has_answers(entry: Entry) -> bool:
    return any(map(is_answered, entry.responses))


def check_times(sheet: Sheet, rule: LateRule | None) -> tuple[Complaint, ...]:
    """Complaints about students of whom it is not known when they handed in, or of whom two files
    say different times.

    Raises TableError for times that are not certain, or cannot be compared with the due date.
    """
    if rule is None:
        return ()
    _require_certain(sheet.entries, rule)
    return (*_find_unknown(sheet), *_find_different(sheet))


def _find_different(sheet: Sheet) -> Iterator[Complaint]:
    """A complaint for each time that is not that of the first file."""
    for student, entries in sheet.entries.items():
        for entry in entries:
            for place, time in entry.other_times:
                if parse_moment(time) == parse_moment(entry.submitted):  # written otherwise
                    continue
                problem = Message(
                    "deadline.two-times",
                    student=Quoted(student),
                    here=Quoted(shorten(time)),
                    there=Quoted(shorten(entry.submitted)),
                    file=entry.file,
                )
                done = Message("deadline.first-time-counts", file=entry.file)
                yield Complaint(*place, "", shorten(time), problem, done)


def _find_unknown(sheet: Sheet) -> Iterator[Complaint]:
    """One complaint about all students of whom it is not known when they handed in."""
    unknown = [
        student
        for student, entries in sheet.entries.items()
        if any(_has_answers(each) and not each.submitted for each in entries)
    ]
    if not unknown:
        return
    problem = Message("deadline.no-times", count=len(unknown), first=Quoted(unknown[0]))
    files = dict.fromkeys(each.file for whose in unknown for each in sheet.entries[whose])
    done = Message("deadline.nothing-subtracted")
    yield Complaint(", ".join(files), None, "", "", problem, done)


def _require_certain(entries: Mapping[str, Sequence[Entry]], rule: LateRule) -> None:
    faults = list(_find_uncertain(entries, rule))
    if faults:
        raise TableError(*faults[:_MOST_NAMED])


def _find_uncertain(entries: Mapping[str, Sequence[Entry]], rule: LateRule) -> Iterator[Fault]:
    """The times that cannot be read, and files whose times cannot be compared with the due date."""
    apart: dict[str, str] = {}
    for entry in (each for several in entries.values() for each in several):
        moment = parse_moment(entry.submitted)
        if entry.submitted and moment is None:
            what = Message("deadline.uncertain", time=Quoted(shorten(entry.submitted)))
            expected, do = Message("deadline.certain"), Message("deadline.write-certain")
            yield Fault(f"{entry.file}:{entry.line}", what, expected, do)
        elif moment is not None and moment.tzinfo is not None and rule.due.tzinfo is None:
            apart.setdefault(entry.file, entry.submitted)
    for file, time in apart.items():
        what = Message("deadline.zone", time=Quoted(time), due=write_moment(rule.due))
        yield Fault(file, what, do=Message("deadline.state-zone", due=write_moment(rule.due)))
