"""What `kinegrade show` prints of a template: plain text, with formulas in one line."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kinegrade.choosing.choice import Entry
from kinegrade.choosing.demands import LEVELS
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message
from kinegrade.language.prose.plain import write_line, write_prose
from kinegrade.language.terminal_lines import align, wrap
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.statement import list_wordings, write_statement
from kinegrade.problem.statement_faults import check_statements
from kinegrade.problem.template.signs import write_sign
from kinegrade.problem.template.slots import split_slots
from kinegrade.problem.template.template import Ask, Parameter, Template
from kinegrade.problem.template.texts import find_languages

_COLUMNS = 96


def describe_template(entry: Entry, language: Language) -> str:
    """A template in words: title, what it takes, statement at its default values, parameters, asks
    and how many instances.
    """
    return "\n".join(_write_lines(entry, language))


def _write_lines(entry: Entry, language: Language) -> Iterator[str]:
    """The lines of the description."""
    template = entry.template
    check_statements(template)
    yield f"{template.name}: {_write_text(template.about.title.in_language(language))}"
    yield from _write_demands(entry, language)
    yield ""
    yield from _write_paragraphs(template, language)
    words = open_catalogue(language)
    if wordings := [*_list_wordings(template, language)]:
        yield ""
        yield words.text("template.shown-wordings")
        yield from _align(wordings)
    yield ""
    yield words.text("template.shown-parameters")
    yield from _align(_list_parameters(template, language))
    yield ""
    yield words.text("template.shown-asks")
    yield from _align(_list_asks(template, language))


def _align(rows: Iterable[tuple[str, ...]]) -> list[str]:
    """Rows in columns, without a header."""
    first, *others = rows
    return align(first, others).splitlines()


def _write_demands(entry: Entry, language: Language) -> Iterator[str]:
    """Where a template comes from, what it takes, and how many combinations it has."""
    words, about = open_catalogue(language), entry.template.about
    yield words.text("template.shown-origin", family=about.family, source=about.source)
    yield words.text(
        "choosing.shown-difficulty",
        difficulty=entry.demands.difficulty,
        most=LEVELS,
        count=entry.demands.minutes,
    )
    yield words.text("choosing.shown-tags", names=_list(entry.tags))
    if entry.demands.methods:
        yield words.text("choosing.shown-methods", names=_list(entry.demands.methods))
    if entry.demands.joints:
        yield words.text("choosing.shown-joints", names=_list(entry.demands.joints))
    yield words.text("template.shown-combinations", number=entry.template.combinations)


def _list(names: Iterable[str]) -> str:
    return ", ".join(sorted(names))


def describe_other_words(solution: Solution, language: Language) -> str:
    """The statement at the values of a solution, where one of its texts is worded otherwise there
    than at the default values, which may be another mechanism; else "".
    """
    template = solution.template
    usual = solve_template(template, {}, ()).parameters
    if list_wordings(template, solution.parameters) == list_wordings(template, usual):
        return ""
    found = find_languages(template)
    spoken = language if language in found else found[0]
    statement = write_statement(template, solution.parameters, spoken, tuple(solution))
    return "\n".join(_write_statement(statement, template.name))


def _list_wordings(template: Template, language: Language) -> Iterator[tuple[str, ...]]:
    """A row for each wording of the texts that depend on values: its name, when it applies, what it
    says.
    """
    otherwise = open_catalogue(language).text("template.shown-otherwise")
    for name, wordings in template.words.texts.items():
        for each in wordings:
            pieces = split_slots(each.text.in_language(language))
            text = "".join(one if isinstance(one, str) else one.name for one in pieces)
            yield "", name, each.condition.text if each.condition else otherwise, _write_text(text)


def _write_paragraphs(template: Template, language: Language) -> Iterator[str]:
    """The statement at the default values."""
    solution = solve_template(template, {}, ())
    statement = write_statement(template, solution.parameters, language)
    return _write_statement(statement, template.name)


def _write_statement(statement: str, name: str) -> Iterator[str]:
    """Its lines."""
    for paragraph in statement.strip().split("\n\n"):
        yield from wrap(write_prose(paragraph, name), _COLUMNS)


def _list_parameters(template: Template, language: Language) -> Iterator[tuple[str, ...]]:
    """A row for each parameter: name, unit, what may be drawn, what it is."""
    for name, each in template.parameters.items():
        means = _write_text(each.means.in_language(language))
        yield "", name, each.unit.printed, _write_domain(each), means


def _list_asks(template: Template, language: Language) -> Iterator[tuple[str, ...]]:
    """A row for each ask: name, unit, points, what it is, with its sign convention."""
    words = open_catalogue(language)
    for name, ask in template.asks.items():
        means = _write_text(ask.means.in_language(language))
        sign = _write_text(write_sign(ask.sign, language))
        yield "", name, ask.unit.printed, words.write(_describe_points(ask)), f"{means} ({sign})"


def _write_text(markdown: str) -> str:
    return write_line(markdown, "")


def _describe_points(ask: Ask) -> Message:
    if ask.points:
        return Message("template.shown-points", count=ask.points)
    return Message("template.shown-on-request")


def _write_domain(parameter: Parameter) -> str:
    """What may be drawn, in short."""
    choices = parameter.choices
    shown = (
        ", ".join(choices)
        if len(choices) <= 6
        else f"{choices[0]}, {choices[1]}, ... {choices[-1]}"
    )
    return f"{shown} ({len(choices)})"
