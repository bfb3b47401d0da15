"""In which languages papers can be printed: that of the exam, and those that students have."""

from __future__ import annotations

from collections import Counter

from kinegrade.errors import BankError
from kinegrade.exam.bank.blueprint import Bank
from kinegrade.exam.bank.texts import require_bank_language
from kinegrade.exam.roster.roster import Roster
from kinegrade.language import Language
from kinegrade.language.message import Fault, Message


def require_languages(bank: Bank, language: Language, roster: Roster) -> None:
    """Raises BankError where the bank or a template lacks texts in the language of the exam, or in
    that of a student.
    """
    require_bank_language(bank, language)
    wanted = Counter(each.language for each in roster.students if each.language)
    for own, count in sorted(wanted.items()):
        try:
            require_bank_language(bank, Language(own))
        except BankError as error:
            what = Message("exam.language-wanted", count=count, language=own)
            first = Fault(roster.file, what, do=Message("exam.complete-language"))
            raise BankError(first, *error.faults) from error
