"""`kinegrade cycle` and the moving figure of notebooks: a mechanism over its whole cycle."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from operator import attrgetter
from typing import Literal, assert_never

from kinegrade.cycles.cycle import Cycle, make_cycle
from kinegrade.cycles.facts import list_facts
from kinegrade.cycles.graphs import draw_graphs
from kinegrade.cycles.moving_figure import draw_cycle
from kinegrade.cycles.table import write_table
from kinegrade.cycles.wording import say_plainly
from kinegrade.figure.back_ends.svg import to_svg
from kinegrade.figure.scene import Scene
from kinegrade.files.csv_writing import encode_for_people
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message
from kinegrade.language.sentence import write_sentence
from kinegrade.press.cycle_page import CyclePage
from kinegrade.press.html.cycle_page import write_cycle_page
from kinegrade.press.html.moving_figure import write_moving_figure
from kinegrade.press.typst.press import TypstPress
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Ask
from kinegrade.problem.template.texts import require_language

CycleFormat = Literal["pdf", "svg", "csv", "html"]


@dataclass(frozen=True)
class Animation:
    """The moving figure of a problem, which a notebook shows; `html` needs no other file."""

    html: str = field(repr=False)

    def _repr_html_(self) -> str:
        return self.html


def animate(solution: Solution, language: Language) -> Animation:
    """The moving figure of a solved instance. Raises MechanismError where nothing can move."""
    cycle = make_cycle(solution, ())
    return Animation(write_moving_figure(cycle, language))


def describe_cycle(cycle: Cycle, language: Language) -> list[str]:
    """What is said of a cycle at a terminal, a line each. Raises TypesetError for a symbol
    that is none.
    """
    facts = list_facts(cycle, language, attrgetter("name"))
    return [say_plainly(fact, language) for fact in facts]


def write_cycle(cycle: Cycle, language: Language, kind: CycleFormat) -> bytes:
    """A cycle as a file of that kind. Raises TemplateError for a language that the template does
    not have, TypesetError.
    """
    match kind:
        case "csv":
            return encode_for_people(write_table(cycle))
        case "svg":
            return draw_graphs(cycle, language, with_figure=cycle.centrodes).encode()
        case "html":
            title, facts = _write_title(cycle, language), _print_facts(cycle, language)
            return write_cycle_page(cycle, title, facts, language).encode()
        case "pdf":
            return TypstPress().cycle(_lay_out_page(cycle, language))
        case _:
            assert_never(kind)


def _print_facts(cycle: Cycle, language: Language) -> tuple[str, ...]:
    """What a page says of a cycle, a line of prose each."""
    facts = list_facts(cycle, language, _print_symbol)
    return tuple(write_sentence(fact, language) for fact in facts)


def _print_symbol(ask: Ask) -> str:
    return f"${ask.symbol}$"


def _write_title(cycle: Cycle, language: Language) -> str:
    """The template's title."""
    require_language([cycle.solution.template], language)
    title = cycle.solution.template.about.title.in_language(language)
    return open_catalogue(language).write(Message("motion.page-title", title=title))


def _lay_out_page(cycle: Cycle, language: Language) -> CyclePage:
    """The page: the figure at the instant, what is said, each curve by itself."""
    figure = draw_cycle(cycle)
    each = (
        replace(cycle, curves=(curve,), instant=(value,))
        for curve, value in zip(cycle.curves, cycle.instant, strict=True)
    )
    return CyclePage(
        language,
        _write_title(cycle, language),
        to_svg(Scene(figure.width, figure.height, 1.0, figure.at_instant)),
        _print_facts(cycle, language),
        tuple(draw_graphs(one, language) for one in each),
    )
