"""The head of an exam as the record that its folder keeps of it."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import UNSET, structs

from kinegrade import __version__
from kinegrade.deadlines.moment import write_moment
from kinegrade.exam.bank.blueprint import BankAsk, BankQuestion
from kinegrade.exam.bank.versions import list_version_letters
from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.contents import PAPERS
from kinegrade.exam.folder.head import FORMAT
from kinegrade.exam.folder.records import Candidate, ExamHead, ExamQuestion, HandQuestion
from kinegrade.exam.printing.printing import PrintRun
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.dealing import ClassDeal
from kinegrade.language import ENGLISH, Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import known_languages
from kinegrade.press.sheet import KeyPaper
from kinegrade.problem.template.signs import write_sign
from kinegrade.problem.template.translated import Translated


def write_warning() -> str:
    """That the folder is not for students, in every language: anyone may come across it."""
    languages = dict.fromkeys((ENGLISH, *known_languages()))
    return " ".join(open_catalogue(each).text("exam.warning") for each in languages)


def make_exam_head(dealt: ClassDeal, candidates: Iterable[Candidate], run: PrintRun) -> ExamHead:
    """The head of an exam, printed by that run, whose number of pages is known; `candidates` are
    its students and its spare papers.
    """
    everybody = tuple(candidates)
    spare = {each.student for each in dealt.roster.students if each.spare}
    bank, language, order = dealt.bank, run.language, run.press_order
    head = ExamHead(
        format=FORMAT,
        kinegrade=__version__,
        warning=write_warning(),
        title=bank.title.in_language(language),
        course=bank.course.in_language(language),
        date=bank.date,
        language=language,
        paper_size=order.paper_size,
        engine=order.engine,
        pages=run.pages or 0,
        method=run.extras.method,
        cycle=run.cycle,
        versions=tuple(list_version_letters(bank.versions)),
        credit=bank.credit.record() or None,
        kind=bank.homework.kind,
        due="" if bank.homework.due is None else write_moment(bank.homework.due),
        scale=None if bank.scale is None else bank.scale.record(),
        solutions=bank.solutions,
        questions=tuple(_make_exam_question(dealt, each, language) for each in bank.questions),
        students=tuple(each for each in everybody if each.student not in spare),
        spares=tuple(each for each in everybody if each.student in spare),
        by_hand=tuple(
            HandQuestion(each.identifier, each.points, each.title.in_language(language), each.bonus)
            for each in bank.by_hand
        ),
        choices=bank.choices,
        unprinted=not run.extras.papers,
        earlier={name: tuple(map(dict, dealt)) for name, dealt in bank.earlier.items()},
    )
    return structs.replace(head, **dealt.secret.record())


def _make_exam_question(
    dealt: ClassDeal, question: BankQuestion, language: Language
) -> ExamQuestion:
    deal = dealt.deals[question.identifier]
    return ExamQuestion(
        question=question.identifier,
        template=question.template.name,
        points=question.points,
        combinations=deal.size,
        refused={str(reason): count for reason, count in deal.refused.items()},
        good=UNSET if deal.lasting else deal.good,
        asks=tuple(make_ask(question, ask, language) for ask in question.asks),
        bonus=question.bonus,
    )


def make_ask(question: BankQuestion, asked: BankAsk, language: Language) -> Ask:
    """An ask of a question as the head states it."""
    ask = question.template.asks[asked.name]
    return Ask(
        question.identifier,
        asked.name,
        ask.unit.text,
        asked.points,
        write_sign(ask.sign, language),
        None if isinstance(ask.sign, Translated) else ask.sign,
        question.bonus,
    )


def candidate(student: Student, key: KeyPaper) -> Candidate:
    """A student as the head has them, with the paper of that key."""
    return Candidate(
        student.student,
        student.name,
        student.email,
        key.code,
        key.version,
        f"{PAPERS}/{student.file_name}.pdf",
        group=student.group,
        room=student.room,
        seat=student.seat,
        language=student.language,
        extra_time=student.extra_time,
        print_format=student.print_format,
    )
