"""The gallery: every template that is shipped, with its figure as papers print it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from html import escape
from itertools import groupby
from pathlib import Path

import kinegrade
from docs.generator.markdown import write_code, write_page
from kinegrade.exam.printing.pages import draw_figure
from kinegrade.figure.back_ends.svg import to_svg
from kinegrade.language import ENGLISH
from kinegrade.language.prose.plain import write_line
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.template import Template

FOLDER = "gallery"  # of the pictures, in the site


def write_gallery_page() -> str:
    """The figures of all templates, family by family, each with what is asked."""
    return write_page(
        "# Gallery",
        "Every template that is included, at the values of its source. "
        "`kinegrade show NAME -o page.pdf` prints one as a question, "
        "`kinegrade gallery -o gallery.pdf` all of them, and "
        "`kinegrade gallery FILE --draws 6 -o sheet.pdf` a template of your own at six draws.",
        *_write_families(),
    )


def write_pictures(folder: Path, names: Iterable[str]) -> None:
    """The figures of templates, as SVG in a folder that the site takes in."""
    (folder / FOLDER).mkdir(parents=True, exist_ok=True)
    for name in names:
        picture = _draw(load_template(name))
        (folder / FOLDER / f"{name}.svg").write_text(picture, encoding="utf-8")


def _write_families() -> Iterator[str]:
    """A heading for each family, and its templates by name."""
    templates = sorted(
        map(load_template, find_template_names()), key=lambda each: (each.about.family, each.name)
    )
    for family, members in groupby(templates, key=lambda each: each.about.family):
        yield f"## {family.capitalize().replace('-', ' ')}"
        for template in members:
            yield from _write_template(template)


def _write_template(template: Template) -> Iterator[str]:
    """The title, the name for banks, the figure, and what is asked with points."""
    yield f"### {template.about.title.in_language(ENGLISH)}"
    described = kinegrade.template(template.name).describe(str(ENGLISH))
    words = "" if described is None else described.short
    source = f"../{FOLDER}/{template.name}.svg"
    style = "background: white; padding: 0.5rem; max-width: 100%"
    yield f'<img src="{source}" alt="{escape(words)}" style="{style}">'
    asked = [
        write_line(template.asks[name].means.in_language(ENGLISH), name)
        for name in template.asked()
    ]
    yield f"{write_code(template.name)} asks for: {'; '.join(asked)}."


def _draw(template: Template) -> str:
    """The figure at the values of the source."""
    solution = solve_template(template, {})
    mechanism = solution.assembly.mechanism.map(float)
    figure = draw_figure(template, mechanism, mark_question(template, template.asked()))
    return "" if figure is None else to_svg(figure)
