"""What a student sees, in every language of the template, and the answers with a box to try one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from markupsafe import Markup

from kinegrade.description.description import describe
from kinegrade.description.short import describe_briefly
from kinegrade.exam.printing.pages import draw_figure
from kinegrade.figure.back_ends.svg import to_svg
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.html_text import write_unit_html
from kinegrade.language.prose.html import write_page_line, write_page_prose
from kinegrade.press.html.described import write_described
from kinegrade.press.html.filled_page import load_layout
from kinegrade.press.html.short_texts import write_symbol_html
from kinegrade.press.places import locate_part
from kinegrade.preview.instance import Instance
from kinegrade.preview.subject import Subject
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.statement import list_statement_languages, write_statement
from kinegrade.problem.template.texts import find_languages

_DIGITS = 10


@dataclass(frozen=True)
class _Worded:
    """The problem in one language, as HTML."""

    tag: str
    title: Markup
    statement: Markup
    described: Markup
    asked: tuple[Markup, ...]


@dataclass(frozen=True)
class _Row:
    """An answer as HTML; `exact` is "" where it has no form that fits a line."""

    name: str
    symbol: Markup
    exact: Markup
    decimal: str
    unit: Markup


def write_problem(subject: Subject, language: Language) -> str:
    """Figure, statements and answers. Raises KinegradeError."""
    instance = Instance(subject.question)
    worded = [_word(instance, each) for each in _choose_languages(instance, language)]
    return load_layout("preview-problem.html").render(
        words=open_catalogue(language).raw("preview", "page."),
        picture=_draw(instance, _choose_languages(instance, language)[0]),
        worded=worded,
        rows=list(_list_rows(instance)),
    )


def _choose_languages(instance: Instance, first: Language) -> list[Language]:
    """Those in which the template is complete, that of the page first; else what there is of the
    statement.
    """
    template = instance.question.template
    stated, complete = list_statement_languages(template), find_languages(template)
    known = [language for language in stated if language in complete] or stated
    return sorted(known, key=lambda language: language != first)


def _draw(instance: Instance, language: Language) -> Markup:
    """The figure as on a paper; "" for a problem of steps alone."""
    template, mechanism = instance.question.template, instance.solution.assembly.mechanism
    figure = draw_figure(template, mechanism.map(float), mark_question(template, instance.asks))
    short = describe_briefly(template, instance.solution.parameters, language)
    return Markup("" if figure is None else to_svg(figure, short))


def _word(instance: Instance, language: Language) -> _Worded:
    template, asks = instance.question.template, instance.asks
    statement = write_statement(template, instance.solution.parameters, language, asks)
    described = describe(instance.solution, language, asks)
    title, place = template.about.title.in_language(language), template.name
    return _Worded(
        open_catalogue(language).text("language.tag"),
        Markup(write_page_line(title, locate_part(place, "title"))),
        Markup(write_page_prose(statement, locate_part(place, "statement"))),
        Markup(write_described(described, language, lambda text: write_page_prose(text, place))),
        tuple(
            Markup(
                write_page_line(
                    template.asks[name].means.in_language(language), locate_part(name, "meaning")
                )
            )
            for name in asks
        ),
    )


def _list_rows(instance: Instance) -> Iterator[_Row]:
    for name in instance.asks:
        answer = instance.solution[name]
        ask = instance.question.template.asks[name]
        yield _Row(
            name,
            write_symbol_html(ask.symbol),
            _write_exact(answer),
            answer.decimal(_DIGITS),
            Markup(write_unit_html(answer.unit)),
        )


def _write_exact(answer: Quantity) -> Markup:
    form = answer.closed_form
    return Markup("") if form is None else write_symbol_html(form)
