"""From a paper's line of the key to its questions in a quiz: statement, figure, right numbers,
known mistakes.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from kinegrade.cycles.chapter import write_cycle_chapter
from kinegrade.description.description import describe
from kinegrade.errors import ExamError, FieldError, KinegradeError
from kinegrade.exam.folder.contents import HEAD
from kinegrade.exam.folder.faults import AS_GENERATED, describe_damage, explain_broken, name_line_of
from kinegrade.exam.folder.key.exact_keys import find_exact_value, read_mistakes, read_rule
from kinegrade.exam.folder.key.lines import KeyLine, StatedAnswer
from kinegrade.exam.folder.numbers import require_number
from kinegrade.exam.printing.pages import (
    QuestionPlace,
    ShownInstance,
    lay_out_question,
    make_answer_row,
)
from kinegrade.exam.printing.rules import count_digits
from kinegrade.exam.quiz.document import QuizAsk, QuizMistake, QuizPaper, QuizQuestion
from kinegrade.exam.quiz.source import QuizSource
from kinegrade.exam.quiz.words import write_marking_rules
from kinegrade.language.message import Fault, Message
from kinegrade.press.html.solution import NOT_SHOWN, Illustrated, illustrate
from kinegrade.problem.assembling.assemble import assemble
from kinegrade.problem.given_values import find_certain_values, find_parameter_values, read_values
from kinegrade.problem.quantity import express_in_unit
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_certified, solve_template
from kinegrade.problem.template.template import Method, Template
from kinegrade.stated_marking import find_identifier
from kinegrade.students.mistaking.mistake_names import describe_all_mistakes
from kinegrade.worked.solution import write_worked_solution

_NO_CREDIT = Fraction(0)


@dataclass(frozen=True)
class QuizWishes:
    """What a quiz is to hold: known mistakes, each with a share of the points, by default the
    bank's; worked solutions, by `method` where several serve.
    """

    mistakes: bool = True
    credit: Fraction | None = None
    solutions: bool = False
    method: Method | None = None


def make_quiz_paper(
    source: QuizSource, wishes: QuizWishes, line: KeyLine, *, pooled: bool = False
) -> QuizPaper:
    """The questions of one paper, without a student where they are pooled.

    They are in the bank's order even if the paper is shuffled, because responses are read in that
    order; each has its number on the paper. Raises ExamError where the line is broken,
    TypesetError for texts that cannot be shown.
    """
    code = line.version or line.paper  # a version belongs to no particular student
    try:
        questions = tuple(
            _make_question(source, wishes, line, place) for place in range(len(line.questions))
        )
        name = "" if pooled else source.exam.head.candidates[line.student].name
    except (KeyError, FieldError) as fault:
        raise _explain_broken(source, line, fault) from fault
    return QuizPaper(code, "" if pooled else line.student, name, questions)


def list_asks(source: QuizSource, line: KeyLine) -> Iterator[tuple[str, QuizAsk]]:
    """The asks of one paper by question, without known mistakes, figures and texts, which makes it
    fast.

    Raises ExamError where the line is broken.
    """
    without_mistakes = QuizWishes(mistakes=False)
    try:
        for entry in line.questions:
            template = source.templates[entry.question]
            for name, stated in entry.asks.items():
                yield entry.question, _make_ask(template, name, stated, without_mistakes, source)
    except (KeyError, FieldError) as fault:
        raise _explain_broken(source, line, fault) from fault


def _explain_broken(source: QuizSource, line: KeyLine, fault: KeyError | FieldError) -> ExamError:
    damage = describe_damage(fault)
    if isinstance(fault, KeyError):
        lacking = Message("exam.not-in", name=str(fault), file=HEAD)
        damage = Fault("", Message("exam.broken", reason=lacking), AS_GENERATED)
    return explain_broken(source.exam.keys.file, [Fault(name_line_of(line.student), damage)])


def _make_question(
    source: QuizSource, wishes: QuizWishes, line: KeyLine, place: int
) -> QuizQuestion:
    entry, code = line.questions[place], line.version or line.paper
    name, language = entry.question, source.language
    template = source.templates[name]
    solution = source.kept.derive(line, entry).drawn.solution if wishes.solutions else None
    try:
        shown = show_instance(template, entry.values, entry.asks)
        asks = tuple(
            _make_ask(template, ask, stated, wishes, source) for ask, stated in entry.asks.items()
        )
        rules = {
            template.asks[ask].symbol: source.rule(name, ask, stated)
            for ask, stated in entry.asks.items()
        }
        rows = tuple(ask.row for ask in asks)
        number = line.order.index(name) + 1
        sheet = lay_out_question(QuestionPlace(number, name), shown, rows, language)
        solved = solve_template(template, entry.values)
        return QuizQuestion(
            f"{source.identifier}-{code}-{name}",
            replace(sheet, described=describe(solved, language, tuple(entry.asks))),
            asks,
            _write_solution(source, solution, tuple(entry.asks), wishes.method)
            if solution
            else NOT_SHOWN,
            write_marking_rules(rules, language),
            count_digits(source.kept.bank.carry, (rule.tolerance for rule in rules.values())),
        )
    except FieldError:
        raise  # a fault of the key, which its reader places
    except KinegradeError as error:
        where = Message("exam.at-paper", exam=str(source.exam.path), code=code, question=name)
        raise type(error)(*(Fault(where, each) for each in error.faults)) from error


def _write_solution(
    source: QuizSource, solution: Solution, asks: Sequence[str], method: Method | None
) -> Illustrated:
    """The worked solution as HTML, with graphs over the cycle where the exam's solutions have them.
    Raises TypesetError for texts that cannot be shown.
    """
    language = source.language
    blocks = write_worked_solution(solution, asks, language, method).blocks
    graphs = write_cycle_chapter(solution, asks, language) if source.exam.head.cycle else ()
    return illustrate((*blocks, *graphs), language)


def show_instance(
    template: Template, given: Mapping[str, str], asks: Iterable[str]
) -> ShownInstance:
    """What a paper that asks this shows of an instance, without solving it.

    Raises TemplateError, MechanismError.
    """
    trees = read_values(template, given)

    def work(arithmetic: Any) -> ShownInstance:
        values = find_parameter_values(template, trees, arithmetic)
        known = values if arithmetic.exact else find_certain_values(template, trees, values)
        parameters = {
            name: express_in_unit(name, value, template.parameters[name].unit)
            for name, value in known.items()
        }
        mechanism = assemble(template, values, arithmetic).mechanism.map(float)
        return ShownInstance(template, parameters, mechanism, tuple(asks))

    return solve_certified(work)


def _make_ask(
    template: Template, name: str, stated: StatedAnswer, wishes: QuizWishes, source: QuizSource
) -> QuizAsk:
    points = require_number("points", stated.points)
    row = make_answer_row(template.asks[name], points, source.language)
    value = find_exact_value(stated)
    low, high = read_rule(stated.tolerance).interval(value)
    period = None if stated.period is None else require_number("period", stated.period)
    mistakes = tuple(_find_mistakes(stated, wishes.credit, source)) if wishes.mistakes else ()
    return QuizAsk(name, replace(row, unit=stated.unit), value, low, high, period, mistakes)


def _find_mistakes(
    stated: StatedAnswer, wished: Fraction | None, source: QuizSource
) -> Iterator[QuizMistake]:
    """What known mistakes lead to outside the interval of what is right."""
    tolerance = read_rule(stated.tolerance)
    sentences = describe_all_mistakes(source.templates.values(), source.language)
    low, high = tolerance.interval(find_exact_value(stated))
    for label, value in read_mistakes(stated.mistakes).items():
        if not low <= value <= high:
            identifier = find_identifier(label)
            sentence = sentences.get(identifier, identifier)
            credit = source.credits.get(identifier, _NO_CREDIT) if wished is None else wished
            yield QuizMistake(identifier, value, credit, sentence, *tolerance.interval(value))
