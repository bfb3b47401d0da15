"""`kinegrade.assign` and `kinegrade.exchange`: a paper becomes that of a student."""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.owners.assigning import assign_paper
from kinegrade.exam.owners.exchanging import ExchangeWishes, exchange_papers
from kinegrade.exam.roster.students import Student
from kinegrade.language.message import Message
from kinegrade.public.opened import expect_opened
from kinegrade.public.outcome import Outcome


def assign(
    exam: ExamFolder,
    code: str,
    student: str,
    *,
    name: str = "",
    email: str = "",
    group: str = "",
) -> Outcome:
    """Give the spare paper of that code to a student who has none, as `kinegrade assign` does.

    Every other paper stays; the numbers are those on the paper. Raises KinegradeError.

    >>> bank, roster = kinegrade.Bank.read("bank.toml"), kinegrade.Roster.read("roster.csv")
    >>> spare = kinegrade.GenerateOptions(spare=1)
    >>> exam = kinegrade.generate(bank, roster, "SUMMER", options=spare).exam
    >>> assign(exam, exam.head.spares[0].paper, "0099", name="Dora")
    SUMMER: paper ... is that of "0099"; 0 spare papers are left
    >>> assign(exam, "XXXX-XXXX", "0100")
    Traceback (most recent call last):
    kinegrade.errors.ExamError: ...
    """
    expect_opened(exam=exam)
    done = assign_paper(exam.path, code, Student(student, name, email, "", group=group))
    said = Message("terminal.of", where=str(exam.path), what=done.summary)
    return Outcome(exam.path, (*done.typed, said))


@dataclass(frozen=True)
class ExchangeOptions:
    """Who a student is whom the exam does not have yet: `name`, `email` and `group`. With `new_id`,
    that is the same person as before. `drop_pool` removes a quiz pool that was made of the exam and
    that nobody answered.
    """

    name: str = ""
    email: str = ""
    group: str = ""
    new_id: bool = False
    drop_pool: bool = False


_ORDINARY = ExchangeOptions()


def exchange(
    exam: ExamFolder, code: str, student: str, *, options: ExchangeOptions = _ORDINARY
) -> Outcome:
    """Give the paper of that code, or the version of that letter, to a student who wrote it in
    place of the own one, as `kinegrade exchange` does: whoever had it gets the other.

    A spare paper that was assigned to somebody else by mistake is passed on, with the name, address
    and group that are given, or those of that person where none is. Every other paper stays. Raises
    KinegradeError.

    >>> bank, roster = kinegrade.Bank.read("bank.toml"), kinegrade.Roster.read("roster.csv")
    >>> exam = kinegrade.generate(bank, roster, "EXCHANGED").exam
    >>> own, other, *_ = exam.students
    >>> exchange(exam, exam.head.candidates[other].paper, own)
    EXCHANGED: ... has paper ... now, and ... has paper ... now; grade again what was graded before
    >>> exchange(exam, "XXXX-XXXX", own)
    Traceback (most recent call last):
    kinegrade.errors.ExamError: ...
    """
    expect_opened(exam=exam)
    whose = Student(student, options.name, options.email, "", group=options.group)
    wishes = ExchangeWishes(new_id=options.new_id, drop_pool=options.drop_pool)
    done = exchange_papers(exam.path, code, whose, wishes)
    said = Message("terminal.of", where=str(exam.path), what=done.summary)
    return Outcome(exam.path, (*done.notes, said))
