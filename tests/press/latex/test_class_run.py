"""The run of a class draws faster than the source that is kept for one student would be, and to the
same bytes.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.figure.back_ends.tikz import write_tikz
from kinegrade.figure.scene import Bow, Disc, Label, Outline, Pen, Scene, Strokes
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.vector import Vector
from kinegrade.press.latex import press as latex_press
from kinegrade.press.latex.press import LatexPress
from kinegrade.press.latex.xetex import CLASS, run
from kinegrade.press.protocol import Press
from tests.figure.mechanisms import EIGHT
from tests.press.papers import BOUNDS, UNEVEN

pytestmark = [pytest.mark.needs_tex, pytest.mark.xdist_group("latex")]

HEAD = r"\documentclass{article}\usepackage{amsmath,tikz}\begin{document}"
MIDDLE = Vector(7.123, 5.35)
LINE = ((Vector(0.4, 0.0), Vector(9.77, -3.1), MIDDLE),)
INKS = Scene(
    30.0,
    20.0,
    1.0,
    (
        Strokes(LINE, Pen(0.8, ink="grey")),
        Strokes((*LINE, LINE[0][:2]), Pen(0.35, dash="dash-dotted")),
        Outline(LINE[0], Pen(0.2, dash="dashed"), "grey", closed=True),
        Outline(LINE[0], None, "black", closed=True),
        Disc(MIDDLE, 3.3, Pen(0.2), "white"),
        Disc(MIDDLE, 0.77, None, "black"),
        Bow(MIDDLE, 4.4, 0.3, 4.0, Pen(0.2)),
        Label(r"\omega_{AB}", MIDDLE, 6.0, 3.0),
    ),
)


def test_the_run_of_a_class_draws_the_same_bytes_as_a_source_that_is_kept(tmp_path: Path) -> None:
    scenes = [INKS, *(sketch(*build(*values[0])) for build, values in EIGHT.values())]
    body = "\\newpage\n".join(map(write_tikz, scenes)) + r"\end{document}"
    pages = []
    for name, beginning in (("kept", ""), ("class", rf"\input{{{CLASS}}}")):
        folder = tmp_path / name
        folder.mkdir()
        assert run(HEAD + beginning + body, folder, 60).fault is None
        pages.append((folder / "pages.xdv").read_bytes())
    assert pages[0] == pages[1]
    assert pages[0].count(b"pdf:btrans") > len(scenes)


@pytest.mark.parametrize(("pages", "longest"), BOUNDS)
def test_papers_filled_up_in_the_run_that_counts_them_are_those_that_are_printed_once_more(
    pages: int | None, longest: int
) -> None:
    press = LatexPress()
    assert press.alike(UNEVEN, pages, longest) == Press.alike(press, UNEVEN, pages, longest)


def test_only_those_before_the_longest_are_set_again(monkeypatch: pytest.MonkeyPatch) -> None:
    sheets: list[int] = []

    def count_sheets(source: str, *given: object) -> object:
        sheets.append(source.count(r"\begin{sheet}"))
        return run(source, *given)  # type: ignore[arg-type]

    monkeypatch.setattr(latex_press, "run", count_sheets)
    of_one_language = {name: UNEVEN[name] for name in ("early", "long", "late")}
    _, counts = LatexPress().alike(of_one_language, None)
    assert set(counts.values()) == {2}
    assert sheets == [3, 1]
