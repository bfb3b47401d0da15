"""A figure that moves, as HTML: one SVG whose drawings a plain script shows one after the other; it
loads nothing from anywhere.
"""

from __future__ import annotations

import hashlib
import json

import numpy as np
from markupsafe import Markup

from kinegrade.cycles.cycle import Cycle
from kinegrade.cycles.graph import convert_displacements
from kinegrade.cycles.moving_figure import MovingFigure, draw_cycle
from kinegrade.cycles.wording import say_input, write_signed
from kinegrade.figure.back_ends.svg import CLOSE, open_document, write_parts
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.press.html.filled_page import load_layout


def write_moving_figure(cycle: Cycle, language: Language) -> str:
    """The mechanism of a cycle as an element of a page, at the instant until it is played. Raises
    TypesetError for a symbol that is none.
    """
    path, words = cycle.path, open_catalogue(language)
    figure = draw_cycle(cycle)
    drawings = [write_parts(drawing, figure.height) for drawing in figure.drawings]
    shown = convert_displacements(path, np.array(figure.moved))
    decimals = 1 if path.input.is_angle else 3
    baked = {
        "drawings": drawings,
        "moved": [write_signed(f"{each + 0.0:.{decimals}f}", language) for each in shown],
        "first": figure.first,
        "closed": figure.closed,
        "play": words.text("motion.play"),
        "stop": words.text("motion.stop"),
    }
    written = json.dumps(baked, ensure_ascii=False).replace("</", "<\\/")
    name = f"cycle-{hashlib.sha256(written.encode()).hexdigest()[:12]}"
    layout = load_layout("moving-figure.html")
    return layout.render(
        name=name,
        picture=_write_picture(figure, drawings),
        play=words.text("motion.play"),
        label=say_input(path, cycle.solution.template, language),
        last=len(drawings) - 1,
        first=figure.first,
        baked=Markup(written),
    )


def _write_picture(figure: MovingFigure, drawings: list[str]) -> Markup:
    """The picture at the instant, with a group for what moves."""
    parts = (
        open_document(figure.width, figure.height),
        write_parts(figure.still, figure.height),
        f'<g class="moving">{drawings[figure.first]}</g>',
        CLOSE,
    )
    return Markup("\n".join(parts))
