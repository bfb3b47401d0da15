"""From a paper's line of the key to its questions in a quiz: statement, figure, right numbers,
known mistakes.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from typing import Any

from kinegrade.errors import ExamError, KinegradeError
from kinegrade.exact.written import written_number, written_text
from kinegrade.exam.pages import answer_row
from kinegrade.exam.quiz_document import QuizAsk, QuizFigure, QuizMistake, QuizPaper, QuizQuestion
from kinegrade.exam.quiz_solution import solution_html
from kinegrade.exam.quiz_source import BROKEN, MENDING, QuizSource, tolerance_of
from kinegrade.exam.quiz_words import FIGURE, AskRule, digits_to_type, marking_rules
from kinegrade.figure.sketch import sketch
from kinegrade.figure.svg import to_svg
from kinegrade.language import Language
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.numeric import drawable_mechanism
from kinegrade.problem.assemble import assemble
from kinegrade.problem.mistake_kinds import sentences
from kinegrade.problem.quantity import Quantity, in_unit
from kinegrade.problem.solving import certain, certified, parameter_values, read_values
from kinegrade.problem.statement import statement
from kinegrade.problem.template import Method, Template

NO_CREDIT = Fraction(0)
_RATIONAL = re.compile(r"-?[0-9]{1,300}(?:/[0-9]{0,299}[1-9][0-9]{0,299})?")
Record = Mapping[str, Any]


@dataclass(frozen=True)
class QuizWishes:
    """What a quiz shall hold: known mistakes, each with a share of the points, the bank's where
    none is wished; worked solutions, by `method` where several serve.
    """

    mistakes: bool = True
    credit: Fraction | None = None
    solutions: bool = False
    method: Method | None = None


def quiz_paper(
    source: QuizSource, wishes: QuizWishes, record: Record, *, pooled: bool = False
) -> QuizPaper:
    """The questions of one paper, of nobody where they are pooled.

    They stand in the bank's order even where the paper is shuffled, for in that order responses are
    read again. Raises ExamError where the line is broken, TypesetError for texts that cannot be
    shown.
    """
    try:
        student = str(record["student"])
        code = str(record.get("version", record["paper"]))  # a version is of nobody in particular
        questions = tuple(_question(source, wishes, code, entry) for entry in record["questions"])
        owner = ("", "") if pooled else (student, source.names[student])
    except BROKEN as fault:
        raise _broken(source, record, fault) from fault
    return QuizPaper(code, *owner, questions)


def paper_asks(source: QuizSource, record: Record) -> Iterator[tuple[str, QuizAsk]]:
    """The asks of one paper by question, without known mistakes, figures and texts: little work.

    Raises ExamError where the line is broken.
    """
    bare = QuizWishes(mistakes=False)
    try:
        for entry in record["questions"]:
            question = str(entry["question"])
            template = source.templates[question]
            for name, stated in entry["asks"].items():
                yield question, _ask(template, name, stated, bare, source)
    except BROKEN as fault:
        raise _broken(source, record, fault) from fault


def _broken(source: QuizSource, record: Record, fault: Exception) -> ExamError:
    return ExamError(
        f'{source.folder / "key.jsonl"}: the line of student "{record["student"]}" is broken '
        f"({type(fault).__name__}: {fault}) - {MENDING}"
    )


def _question(source: QuizSource, wishes: QuizWishes, code: str, entry: Record) -> QuizQuestion:
    name, language = str(entry["question"]), source.language
    template = source.templates[name]
    given = {parameter: given_text(value) for parameter, value in entry["parameters"].items()}
    try:
        parameters, mechanism = shown(template, given)
        asks = tuple(
            _ask(template, ask, stated, wishes, source) for ask, stated in entry["asks"].items()
        )
        rules = {
            template.asks[ask].symbol: AskRule(
                source.tolerances[name, ask], written_text(stated["unit"])
            )
            for ask, stated in entry["asks"].items()
        }
        solution = (
            solution_html(template, given, tuple(entry["asks"]), language, wishes.method)
            if wishes.solutions
            else ""
        )
        return QuizQuestion(
            f"{source.identifier}-{code}-{name}",
            name,
            template.title.in_language(language),
            statement(template, parameters, language),
            _figure(template, mechanism, language),
            asks,
            solution,
            marking_rules(rules, language),
            digits_to_type(rule.tolerance for rule in rules.values()),
        )
    except KinegradeError as error:
        raise type(error)(
            *(f"{source.folder}: paper {code}, {name}: {problem}" for problem in error.problems)
        ) from error


def given_text(entry: Record) -> str:
    """A drawn value as it is written in a template: exactly, or as a decimal where it is known no
    better.
    """
    if entry["exact"] is not None:
        return str(entry["exact"])
    written_number(entry["value"])  # a number of bounded size, or it would be written out at length
    return f"{Decimal(entry['value']):f}"


def shown(template: Template, given: Mapping[str, str]) -> tuple[dict[str, Quantity], Mechanism]:
    """What a paper shows of an instance, its parameters and the mechanism to be drawn, without
    solving it.

    Raises TemplateError, MechanismError.
    """
    trees = read_values(template, given)

    def work(arithmetic: Any) -> tuple[dict[str, Quantity], Mechanism]:
        values = parameter_values(template, trees, arithmetic)
        known = values if arithmetic.exact else certain(template, trees, values)
        parameters = {
            name: in_unit(name, value, template.parameters[name].unit)
            for name, value in known.items()
        }
        return parameters, drawable_mechanism(assemble(template, values, arithmetic).mechanism)

    return certified(work)


def _figure(template: Template, mechanism: Mechanism, language: Language) -> QuizFigure:
    scene = sketch(mechanism, template.figure)
    title = template.title.in_language(language).replace("$", "")
    return QuizFigure(
        to_svg(scene).encode(), scene.width, scene.height, FIGURE[language].format(title)
    )


def _ask(
    template: Template, name: str, entry: Record, wishes: QuizWishes, source: QuizSource
) -> QuizAsk:
    row = answer_row(template.asks[name], written_number(entry["points"]), source.language)
    value = right_value(entry)
    low, high = tolerance_of(entry).interval(value)
    period = written_number(entry["period"]) if "period" in entry else None
    mistakes = tuple(_mistakes(entry, wishes.credit, source)) if wishes.mistakes else ()
    return QuizAsk(
        name,
        row.symbol,
        row.meaning,
        written_text(entry["unit"]),
        template.asks[name].sign.in_language(source.language),
        row.points,
        value,
        low,
        high,
        period,
        mistakes,
    )


def right_value(entry: Record) -> Fraction:
    """The exact value where it is a plain number, else its 40 digits."""
    exact = entry["exact"]
    return written_number(
        exact if exact is not None and _RATIONAL.fullmatch(exact) else entry["decimal"]
    )


def _mistakes(entry: Record, wished: Fraction | None, source: QuizSource) -> Iterator[QuizMistake]:
    """What known mistakes lead to outside the interval of what is right."""
    tolerance, words = tolerance_of(entry), sentences()
    right = tolerance.interval(right_value(entry))
    for identifier, stated in entry.get("mistakes", {}).items():
        value = written_number(stated)
        if not right[0] <= value <= right[1]:
            sentence = words[identifier][source.language] if identifier in words else identifier
            credit = source.credits.get(identifier, NO_CREDIT) if wished is None else wished
            yield QuizMistake(identifier, value, credit, sentence, *tolerance.interval(value))
