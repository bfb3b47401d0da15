"""What every back end keeps: the size of the scene, all primitives, and symbols alone reach the
typesetter.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest
import typst

from kinegrade.errors import TypesetError
from kinegrade.figure.back_ends.svg import to_svg
from kinegrade.figure.back_ends.tikz import write_tikz
from kinegrade.figure.back_ends.typst import write_typst
from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.scene import Label, Pen, Scene, Strokes
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.vector import Vector
from kinegrade.press.latex.xetex import run
from tests.figure.mechanisms import EIGHT
from tests.figure.test_typst import SYMBOLS

BackEnd = Callable[[Scene], str]
BACK_ENDS = pytest.mark.parametrize("back_end", [write_typst, write_tikz])


def eight_scenes() -> list[Scene]:
    return [sketch(*build(*values[0])) for build, values in EIGHT.values()]


def latex(body: str) -> str:
    return rf"\documentclass{{article}}\usepackage{{amsmath,tikz}}\begin{{document}}{body}\end{{document}}"


def test_typst_draws_all_eight_figures() -> None:
    page = "#set page(width: auto, height: auto)\n" + "\n#pagebreak()\n".join(
        map(write_typst, eight_scenes())
    )
    assert typst.compile(page.encode(), format="pdf").startswith(b"%PDF")


@pytest.mark.parametrize(
    ("back_end", "grey"),
    [
        (write_typst, "luma(65%)"),
        (to_svg, "#a6a6a6"),
        (write_tikz, r"\pgfsetstrokecolor{black!35}"),
    ],
)
def test_a_grey_line_is_grey_and_the_next_one_black(back_end: BackEnd, grey: str) -> None:
    line = ((Vector(0.0, 0.0), Vector(9.0, 0.0)),)
    first, second = Strokes(line, Pen(0.8, ink="grey")), Strokes(line, Pen(0.8))
    alone = back_end(Scene(9.0, 1.0, 1.0, (second,)))
    both = back_end(Scene(9.0, 1.0, 1.0, (first, second)))
    assert (alone.count(grey), both.count(grey)) == (0, 1)


@pytest.mark.needs_tex
def test_latex_draws_all_eight_figures_in_boxes_of_their_size(tmp_path: Path) -> None:
    scenes = eight_scenes()
    boxes = (
        rf"\setbox0\hbox{{{write_tikz(scene)}}}\typeout{{size \the\wd0 \space\the\ht0}}\box0\newpage"
        for scene in scenes
    )
    assert run(latex("".join(boxes)), tmp_path, 60).fault is None
    sizes = re.findall(
        r"^size ([\d.]+)pt ([\d.]+)pt$", (tmp_path / "pages.log").read_text(), re.MULTILINE
    )
    for scene, found in zip(scenes, sizes, strict=True):
        assert [float(size) * 25.4 / 72.27 for size in found] == pytest.approx(
            [scene.width, scene.height], abs=0.02
        )


@pytest.mark.needs_tex
def test_the_estimated_room_holds_every_symbol_latex_sets(tmp_path: Path) -> None:
    boxes = (
        rf"\setbox0\hbox{{${symbol}$}}\typeout{{size \the\wd0 \space\the\dimexpr\ht0+\dp0}}"
        for symbol in SYMBOLS
    )
    run(latex(r"\fontsize{9}{9}\selectfont" + "".join(boxes)), tmp_path, 60)
    sizes = re.findall(
        r"^size ([\d.]+)pt ([\d.]+)pt$", (tmp_path / "pages.log").read_text(), re.MULTILINE
    )
    for symbol, (width, height) in zip(SYMBOLS, sizes, strict=True):
        room = measure_symbol(symbol)
        assert float(width) * 25.4 / 72.27 <= room[0] + 0.05, symbol
        # TeX's root stands out a little
        assert float(height) * 25.4 / 72.27 <= room[1] + 0.8, symbol


@BACK_ENDS
def test_what_is_no_symbol_is_refused(back_end: BackEnd) -> None:
    for symbol in ("#read(1)", r"\input{x}", "a$b"):
        scene = Scene(9.0, 9.0, 1.0, (Label(symbol, Vector(1.0, 1.0), 1.0, 1.0),))
        with pytest.raises(TypesetError, match=r"^figure\.labels: "):
            back_end(scene)


@BACK_ENDS
def test_every_label_and_every_primitive_is_drawn(back_end: BackEnd) -> None:
    for scene in eight_scenes():
        less = Scene(scene.width, scene.height, scene.scale, scene.primitives[1:])
        assert len(back_end(less)) < len(back_end(scene))


@BACK_ENDS
def test_numbers_are_short_and_the_same_on_every_machine(back_end: BackEnd) -> None:
    for scene in eight_scenes():
        assert not re.search(r"\d\.\d{4,}|\de[-+]\d", back_end(scene))
