"""The layouts of HTML pages: all text is escaped, and a missing text is an error."""

from __future__ import annotations

from functools import cache
from importlib.resources import files

from jinja2 import Environment, FileSystemLoader, StrictUndefined, Template
from markupsafe import Markup

from kinegrade.press.class_sheet import Symbol
from kinegrade.press.html.plots import write_plot
from kinegrade.press.html.short_texts import write_prose_html, write_symbol_html


@cache
def load_layout(name: str) -> Template:
    """A layout of this room; it may call `css(FILE)`, also for a script, and the filters `prose`,
    `symbol`, `named` and `plot`.
    """
    folder = files("kinegrade.press.html") / "layouts"
    environment = Environment(
        loader=FileSystemLoader(str(folder)),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters |= {
        "prose": write_prose_html,
        "symbol": write_symbol_html,
        "named": _write_named_symbol,
        "plot": write_plot,
    }
    environment.globals["css"] = lambda file: Markup((folder / file).read_text(encoding="utf-8"))
    return environment.get_template(name)


def _write_named_symbol(symbol: Symbol) -> Markup:
    """A symbol, or the name where none is known."""
    return Markup.escape(symbol.name) if symbol.math is None else write_symbol_html(symbol.math)
