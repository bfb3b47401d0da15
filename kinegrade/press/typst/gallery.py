"""A contact sheet of templates as Typst source."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import groupby

from kinegrade.figure.back_ends.typst import write_typst
from kinegrade.language import Language
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.gathering import convert_each, gather
from kinegrade.language.math.typst.equation import write_formula
from kinegrade.language.message import Location
from kinegrade.language.prose.typst import write_line
from kinegrade.press.figure_text import describe_figure
from kinegrade.press.gallery_sheet import Gallery, GalleryDemands, GalleryEntry, GalleryFigure
from kinegrade.press.places import locate_part
from kinegrade.press.sheet import PaperSize
from kinegrade.press.typst.layout_call import Sheet, write_layout_call


def write_gallery_source(gallery: Gallery, size: PaperSize = "a4") -> str:
    """Typst source of a contact sheet of templates; raises TypesetError with all faults of their
    texts.
    """
    words = open_catalogue(gallery.language)
    entries = convert_each(lambda entry: _write_entry(entry, words), gallery.entries)
    families = [
        {"name": family or words.text("gallery.unreadable"), "entries": list(members)}
        for family, members in groupby(entries, lambda entry: entry["family"])
    ]
    sheet: Sheet = {
        "families": families,
        "words": words.raw("gallery", "layout."),
        "language": words.raw("language", "page."),
        "size": size,
        "title": words.text("gallery.title", count=len(gallery.entries)),
    }
    return write_layout_call("gallery", sheet)


def _write_entry(entry: GalleryEntry, words: Catalogue) -> Sheet:
    sheet = gather(
        title=lambda: _write_title(entry, words.language),
        asks=lambda: _write_symbols(entry.asks, entry.name, words.language),
        on_request=lambda: _write_symbols(entry.on_request, entry.name, words.language),
        figures=lambda: convert_each(
            lambda draw: _write_figure(draw, entry.title or entry.name, entry.name, words.language),
            entry.figures,
        ),
    )
    return sheet | {
        "family": entry.family,
        "name": entry.name,
        "demands": _write_demands(entry.demands, words),
        "tags": entry.demands.tags if entry.demands else (),
        "faults": entry.faults,
    }


def _write_demands(demands: GalleryDemands | None, words: Catalogue) -> str:
    """How many combinations there are, how hard it is, how long it takes."""
    if demands is None:
        return ""
    parts = (
        words.text("gallery.combinations", count=demands.combinations),
        words.text(
            "gallery.demands",
            difficulty=demands.difficulty,
            most=demands.most,
            count=demands.minutes,
        ),
    )
    return " · ".join(parts)


def _write_title(entry: GalleryEntry, language: Language) -> str | None:
    return (
        write_line(entry.title, locate_part(entry.name, "title"), language) if entry.title else None
    )


def _write_figure(draw: GalleryFigure, title: str, where: Location, language: Language) -> Sheet:
    return {
        "figure": f"[{write_typst(draw.figure)}]",
        "said": describe_figure(title, language),
        "givens": write_line(draw.givens, locate_part(where, "givens"), language),
    }


def _write_symbols(symbols: Iterable[str], where: Location, language: Language) -> list[str]:
    return convert_each(
        lambda symbol: write_formula(symbol, locate_part(where, "symbol"), language), symbols
    )
