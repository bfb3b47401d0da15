"""In which languages papers can be printed: that of the exam, and those that students have."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from kinegrade.errors import BankError
from kinegrade.exam.bank.blueprint import Bank
from kinegrade.exam.bank.texts import require_bank_language
from kinegrade.exam.roster.roster import Roster
from kinegrade.language import Language
from kinegrade.language.message import Fault, Message
from kinegrade.problem.template.texts import note_other_scripts


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


def note_languages(bank: Bank, language: Language, roster: Roster) -> Iterator[Message]:
    """A note for each template that gives a paper texts in a script that is not its own."""
    own = {Language(each.language) for each in roster.students if each.language}
    templates = {question.template.name: question.template for question in bank.questions}
    for template in templates.values():
        for spoken in sorted({language, *own}):
            yield from note_other_scripts(template, spoken)
