"""A contact sheet of templates, for an instructor to choose from: what each asks, and how it looks
at several draws.

A template that cannot be read, drawn or typeset does not spoil the sheet: it is listed with the
reason.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from kinegrade.choosing.choice import make_entry
from kinegrade.choosing.demands import LEVELS
from kinegrade.draws.deal import deal, look_here
from kinegrade.draws.deck import make_deck
from kinegrade.draws.draw_filter import DrawFilter
from kinegrade.errors import KinegradeError, TemplateError, TypesetError
from kinegrade.figure.sketch import sketch
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.decimal_mark import write_decimals_of_prose
from kinegrade.press.gallery_sheet import Gallery, GalleryDemands, GalleryEntry, GalleryFigure
from kinegrade.press.legible import make_legible
from kinegrade.press.typst.press import TypstPress
from kinegrade.problem.given import list_givens
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.given_marks import mark_givens
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.template import Template
from kinegrade.problem.template.texts import require_language
from kinegrade.proof.assemblies import close_otherwise, find_other_assemblies

# Combinations that are looked at before a template without a good one is given up: somebody waits
_PATIENCE = 60

_Draw = Callable[[Template, Language], tuple[tuple[GalleryFigure, ...], tuple[str, ...]]]


@dataclass(frozen=True)
class ContactSheet:
    """The gallery as PDF, and what could not be shown in it, a line each."""

    pdf: bytes
    complaints: tuple[str, ...]


def make_contact_sheet(names: Iterable[str], language: Language, draws: int) -> ContactSheet:
    """The gallery of the templates of these names (or paths that end in .toml), each at that many
    draws.

    Raises TemplateError when none of them can be read.
    """
    return _make_sheet(names, language, partial(_draw_figures, draws=draws))


def make_assembly_sheet(names: Iterable[str], language: Language) -> ContactSheet:
    """The same, each at one draw, put together as its template says and in all other ways.

    Raises TemplateError when none of them can be read.
    """
    return _make_sheet(names, language, _draw_assemblies)


def _make_sheet(names: Iterable[str], language: Language, draw: _Draw) -> ContactSheet:
    entries = [_make_entry(name, language, draw) for name in dict.fromkeys(names)]
    if not any(entry.family for entry in entries):
        raise TemplateError(*(fault for entry in entries for fault in entry.faults))
    press = TypstPress()
    try:
        return _require_printed(press, Gallery(language, _order_entries(entries)))
    except TypesetError:
        legible = [_require_printable(press, entry, language) for entry in entries]
        return _require_printed(press, Gallery(language, _order_entries(legible)))


def _require_printed(press: TypstPress, gallery: Gallery) -> ContactSheet:
    """The sheet of entries that are all printable. Raises TypesetError when one is not."""
    complaints = tuple(fault for entry in gallery.entries for fault in entry.faults)
    return ContactSheet(press.gallery(gallery), complaints)


def _order_entries(entries: Iterable[GalleryEntry]) -> tuple[GalleryEntry, ...]:
    """The entries by family and name; what cannot be read comes last."""
    return tuple(sorted(entries, key=lambda entry: (not entry.family, entry.family, entry.name)))


def _make_entry(name: str, language: Language, draw: _Draw) -> GalleryEntry:
    """The entry of one template; if it cannot be read, its faults alone."""
    try:
        template = load_template(name)
        require_language([template], language)
    except TemplateError as error:
        return _make_unreadable_entry(Path(name).stem, _write_faults(error, language))
    demands, unsolved = _find_demands(template, language)
    figures, faults = draw(template, language)
    asked = template.asked()
    return GalleryEntry(
        template.about.family,
        template.name,
        template.about.title.in_language(language),
        demands,
        tuple(template.asks[ask].symbol for ask in asked),
        tuple(ask.symbol for ask in template.asks.values() if ask.name not in asked),
        figures,
        (*unsolved, *faults),
    )


def _find_demands(
    template: Template, language: Language
) -> tuple[GalleryDemands | None, tuple[str, ...]]:
    """What a template takes, or why that cannot be said."""
    try:
        entry = make_entry(template)
    except KinegradeError as error:
        return None, _write_faults(error, language)
    demands = entry.demands
    tags = tuple(sorted(entry.tags))
    return GalleryDemands(
        template.combinations, demands.difficulty, LEVELS, demands.minutes, tags
    ), ()


def _make_unreadable_entry(name: str, faults: tuple[str, ...]) -> GalleryEntry:
    """The entry of a template that can only be named."""
    return GalleryEntry("", name, "", None, (), (), (), faults)


def _require_printable(press: TypstPress, entry: GalleryEntry, language: Language) -> GalleryEntry:
    """The entry itself where it can be typeset, otherwise its faults alone, in characters that
    can.
    """
    try:
        press.gallery(Gallery(language, (entry,)), entry.name)
    except TypesetError as error:
        faults = entry.faults + (_write_faults(error, language) if entry.family else ())
        missing = press.unprintable((entry.name, *faults))
        return _make_unreadable_entry(
            make_legible(entry.name, missing),
            tuple(make_legible(fault, missing) for fault in faults),
        )
    return entry


def _draw_figures(
    template: Template, language: Language, draws: int
) -> tuple[tuple[GalleryFigure, ...], tuple[str, ...]]:
    """The figures of the first good combinations, the same in every gallery, and why there are no
    more.
    """
    figures: list[GalleryFigure] = []
    try:
        solutions, shortage = _deal_first(template, draws, language)
        for solution in solutions:
            figures.append(_draw_figure(solution, language))
    except KinegradeError as error:
        return tuple(figures), _write_faults(error, language)
    return tuple(figures), shortage


def _deal_first(
    template: Template, draws: int, language: Language
) -> tuple[list[Solution], tuple[str, ...]]:
    """The instances of the first good combinations, and a line where there are too few."""
    deck = make_deck(template, template.name, "gallery")
    draw_filter = DrawFilter(template, template.asked(), deck, {})
    filters = {"gallery": draw_filter}
    dealt = deal(filters, draws, partial(look_here, filters), _PATIENCE)["gallery"]
    values = map(deck.combination, dealt.positions[:draws])
    solutions = [draw_filter.dealt.solved(each) for each in values]
    if dealt.lasting:
        return solutions, ()
    shortage = dealt.shortage(template.name, "draws", draw_filter)
    return solutions, (open_catalogue(language).write(shortage),)


def _draw_assemblies(
    template: Template, language: Language
) -> tuple[tuple[GalleryFigure, ...], tuple[str, ...]]:
    """The figure of the first good combination, and those of the other ways in which it closes."""
    try:
        (solution,), shortage = _deal_first(template, 1, language)
        figures = [_draw_figure(solution, language)]
        for other in find_other_assemblies(template):
            closed = close_otherwise(solution, other)
            if closed is not None:
                caption = f"${other.point}$: {other.other}"
                figures.append(replace(_draw_figure(closed, language), givens=caption))
    except KinegradeError as error:
        return (), _write_faults(error, language)
    return tuple(figures), shortage


def _write_faults(error: KinegradeError, language: Language) -> tuple[str, ...]:
    return tuple(map(open_catalogue(language).write, error.faults))


def _draw_figure(solution: Solution, language: Language) -> GalleryFigure:
    """The figure of an instance with the values drawn."""
    template = solution.template
    figure = sketch(solution.assembly.mechanism.map(float), mark_givens(template))
    values = ", ".join(map(str, list_givens(template, solution.parameters).values()))
    return GalleryFigure(figure, write_decimals_of_prose(values, language))
