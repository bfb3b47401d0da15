"""What a person should look at before the papers of a class are handed out."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.errors import Problem, TableError
from kinegrade.exam.bank.blueprint import Bank
from kinegrade.exam.generating.earlier_exams import list_repeated
from kinegrade.exam.printing.printing import Extras
from kinegrade.exam.roster.complaints import roster_complaints
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.setting.contradictions import list_contradictions
from kinegrade.exam.setting.dealing import ClassDeal
from kinegrade.exam.setting.same_answers import list_same_answers
from kinegrade.language.message import Fault, Message
from kinegrade.press.protocol import Press


def list_unbound(bank: Bank, extras: Extras) -> Iterator[Fault]:
    """That papers in other kinds of files lack the formula sheet."""
    if bank.formula_sheet is not None and extras.also:
        what, do = Message("exam.without-formulas"), Message("exam.hand-out-formulas")
        yield Fault(", ".join(extras.also), what, do=do)


def list_complaints(
    roster: Roster, press: Press, dealt: ClassDeal, *, strict: bool
) -> tuple[Problem, ...]:
    """What a person should look at before papers of a class are handed out. Raises TableError
    where that is refused.
    """
    found: tuple[Problem, ...] = (*roster_complaints(roster, press), *dealt.shortages())
    found = (*found, *list_repeated(dealt), *list_same_answers(dealt), *list_contradictions(dealt))
    require_none(found if strict else ())
    return found


def require_none(complaints: tuple[Problem, ...]) -> None:
    """Raises TableError where there are complaints."""
    if complaints:
        raise TableError(*complaints)
