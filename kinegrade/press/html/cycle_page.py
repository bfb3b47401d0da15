"""The page of a mechanism that moves through its cycle, as HTML."""

from __future__ import annotations

from collections.abc import Sequence

from markupsafe import Markup

from kinegrade.cycles.cycle import Cycle
from kinegrade.cycles.graphs import draw_graphs
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.press.html.filled_page import load_layout
from kinegrade.press.html.moving_figure import write_moving_figure
from kinegrade.press.html.short_texts import write_prose_html


def write_cycle_page(cycle: Cycle, title: str, facts: Sequence[str], language: Language) -> str:
    """A page of its own: the moving figure, what is said of the cycle, and its graphs. Raises
    TypesetError for a symbol that is none.
    """
    return load_layout("cycle.html").render(
        tag=open_catalogue(language).text("language.tag"),
        title=title,
        moving=Markup(write_moving_figure(cycle, language)),
        facts=[write_prose_html(fact) for fact in facts],
        graphs=Markup(draw_graphs(cycle, language)),
    )
