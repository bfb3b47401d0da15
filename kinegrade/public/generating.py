"""`kinegrade.generate` and `kinegrade.add_students`: an exam folder, written and added to."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from os import PathLike
from pathlib import Path

from kinegrade.errors import OptionError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.generating.earlier_exams import count_avoided
from kinegrade.exam.generating.generate import Generated as Written
from kinegrade.exam.generating.generate import generate as write_exam
from kinegrade.exam.generating.growing.adding import add_students as add_to_exam
from kinegrade.exam.generating.options import GenerateOptions
from kinegrade.exam.printing.paper_languages import note_languages
from kinegrade.exam.roster.roster import Roster
from kinegrade.language.message import Message
from kinegrade.public.bank import Bank
from kinegrade.public.folders import expect_own_place
from kinegrade.public.opened import expect_opened
from kinegrade.public.opening import open_exam
from kinegrade.public.options import find_language, require_known
from kinegrade.public.outcome import Outcome

_ORDINARY = GenerateOptions()


@dataclass(frozen=True, repr=False)
class Generated(Outcome):
    """An exam folder was written."""

    @cached_property
    def exam(self) -> ExamFolder:
        """The folder, opened."""
        return open_exam(self.path)


def generate(
    bank: Bank,
    roster: Roster,
    output: str | PathLike[str],
    *,
    language: str = "en",
    force: bool = False,
    options: GenerateOptions = _ORDINARY,
) -> Generated:
    """Draw, solve and typeset an exam for every student of a roster, as `kinegrade generate` does.

    `output` is the exam folder, which is written whole or not at all; with `force` it may replace
    one. Raises KinegradeError.

    >>> bank, roster = Bank.read("bank.toml"), Roster.read("roster.csv")
    >>> generate(bank, roster, "SPRING").exam.students
    ('007', '0012')
    >>> generate(bank, roster, "SPRING")
    Traceback (most recent call last):
    kinegrade.errors.OutputError: SPRING: already exists - ...
    """
    expect_opened(bank=bank, roster=roster)
    place = Path(output)
    expect_own_place(place)
    require_known(options)
    if options.seed is not None and options.reproducible is not None:
        raise OptionError(Message("terminal.seed-or-words"))
    chosen = find_language(language)
    written = write_exam(bank.blueprint, roster, place, chosen, options, force=force)
    languages = note_languages(written.dealt.bank, chosen, roster)
    notes = (*roster.notes, *languages, *_list_notes(written, place, options))
    return Generated(place, notes, written.complaints)


def add_students(
    exam: ExamFolder,
    bank: Bank,
    roster: Roster,
    late: Roster,
    *,
    options: GenerateOptions = _ORDINARY,
) -> Generated:
    """Give late students papers of an exam that was generated from that bank for the students of
    that roster, as `kinegrade generate --add` does.

    No other paper, solution or key changes; the exam with the late students is in what is given
    back. Of the options only `strict`, `jobs`, `cluster` and `progress` matter. Raises
    KinegradeError.

    >>> bank, roster = kinegrade.Bank.read("bank.toml"), kinegrade.Roster.read("roster.csv")
    >>> exam, late = kinegrade.open_exam("EXAM"), kinegrade.Roster.read("late.csv")
    >>> add_students(exam, bank, roster, late)
    EXAM: 1 paper added, 2 stay as they are
    >>> add_students(exam, bank, roster, late)
    Traceback (most recent call last):
    kinegrade.errors.TableError: ...
    """
    expect_opened(exam=exam, bank=bank, roster=roster, late=late)
    require_known(options)
    added = add_to_exam(exam.path, bank.blueprint, roster, late, options)
    note = Message("terminal.of", where=str(exam.path), what=added.summary)
    return Generated(exam.path, (*late.notes, *added.sharing, note), added.complaints)


def _list_notes(written: Written, place: Path, options: GenerateOptions) -> Iterator[Message]:
    if written.dealt.secret.guessable:
        kept = Message("terminal.keeps-words", exam=str(place))
        yield kept if options.reproducible is None else Message("terminal.words-cost")
    for question, template in written.drawn.items():
        yield Message("terminal.drawn", question=question, template=template)
    for question, count in written.dealt.combinations().items():
        yield Message("terminal.combinations", question=question, count=count)
    yield from written.dealt.giving()
    yield from written.dealt.sharing()
    yield from count_avoided(written.dealt)
    changes = () if written.changes is None else (written.changes.summary,)
    for what in (*changes, *written.remarks):
        yield Message("terminal.of", where=str(place), what=what)
    if written.resumed:
        yield Message("terminal.resumed", exam=str(place), count=written.resumed)
    done = Message("terminal.generated", exam=str(place), count=written.papers)
    dealt = Message("terminal.dealt", exam=str(place), count=written.papers)
    yield dealt if options.no_papers else done
