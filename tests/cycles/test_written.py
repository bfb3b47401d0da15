"""A cycle as files: pages, graphs, tables, and a figure that moves."""

from __future__ import annotations

import csv
import io
import json
import re
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from pypdf import PdfReader

import kinegrade
from kinegrade.cycles.centrodes import find_poled_bodies, trace_centrodes
from kinegrade.cycles.cycle import make_cycle
from kinegrade.cycles.moving_figure import draw_cycle, draw_moving_figure
from kinegrade.errors import MechanismError
from kinegrade.figure.scene import Label, Outline, Pen, find_common_box
from kinegrade.language import ENGLISH, Language
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.public.cycles import write_cycle
from tests.motion.mechanisms import follow

MANY = [name for name in find_template_names() if load_template(name).scheme.drivers][::6]


@pytest.mark.parametrize("language", [ENGLISH, Language("zh"), Language("de")])
def test_the_graphs_are_one_picture_with_a_curve_and_a_mark_each(language: Language) -> None:
    cycle = make_cycle(solve_template(load_template("slider-crank"), {}))
    tree = ElementTree.fromstring(write_cycle(cycle, language, "svg"))
    kind = "{http://www.w3.org/2000/svg}"
    curves = [each for each in tree.iter(f"{kind}path") if each.get("stroke-width") == "0.4"]
    assert len(curves) == 4
    assert len(list(tree.iter(f"{kind}circle"))) == 4
    texts = ["".join(each.itertext()) for each in tree.iter(f"{kind}text")]
    assert "aAB(rad/s²)" not in texts
    assert any(text.endswith("(rad/s²)") for text in texts), texts
    assert ("0,5" in texts) == (language == Language("de"))


def test_the_table_has_the_input_the_moving_points_and_the_asks() -> None:
    cycle = make_cycle(solve_template(load_template("slider-crank"), {}), ("v_B",))
    table = write_cycle(cycle, ENGLISH, "csv").decode("utf-8-sig")
    header, *rows = csv.reader(io.StringIO(table))
    points = ["x_A (m)", "y_A (m)", "x_B (m)", "y_B (m)"]
    poles = ["x_P (m)", "y_P (m)", "x_P_AB (m)", "y_P_AB (m)"]
    assert header == ["input (deg)", *points, *poles, "v_B (m/s)"]
    assert len(rows) == 721
    assert float(rows[0][1]) == pytest.approx(0.5)
    assert [float(cell) for cell in rows[-1][1:]] == pytest.approx(list(map(float, rows[0][1:])))


@pytest.mark.parametrize(
    ("name", "centrodes"),
    [("bent-rod-two-sleeves", False), ("watt-linkage", False), ("slider-crank", True)],
)
def test_at_the_instant_no_way_and_no_centrode_goes_through_a_letter(
    name: str, *, centrodes: bool
) -> None:
    figure = draw_cycle(make_cycle(solve_template(load_template(name), {}), centrodes=centrodes))
    letters = [find_common_box([part]) for part in figure.at_instant if isinstance(part, Label)]
    curves = [part for part in figure.at_instant if isinstance(part, Outline) and not part.closed]
    places = np.array([corner for curve in curves for corner in _refine(curve)])
    assert letters
    for box in letters:
        across = (box.left < places[:, 0]) & (places[:, 0] < box.right)
        assert not (across & (box.bottom < places[:, 1]) & (places[:, 1] < box.top)).any()


def _refine(curve: Outline) -> list[tuple[float, float]]:
    """Places on a curve, of which many lie in a letter that it goes through."""
    corners = np.array(curve.corners)
    shares = np.linspace(0, 1, 20)[:, None, None]
    places = corners[:-1] + shares * np.diff(corners, axis=0)
    return [(x, y) for x, y in places.reshape(-1, 2).tolist()]


def test_a_page_writes_numbers_as_formulas() -> None:
    solution = solve_template(load_template("slider-crank"), {"omega": "1/1000"})
    page = write_cycle(make_cycle(solution, ("a_B",)), Language("de"), "html").decode()
    said = page[page.index("<ul") : page.index("</ul>")]
    assert "<mo>·</mo><msup><mn>10</mn>" in said
    text = re.sub("<[^>]*>", "", said)
    assert "am kleinsten −" in text
    assert not re.search(r"-[0-9]|[0-9]e-|[0-9][.][0-9]", text), text


def test_the_page_says_what_the_terminal_says(tmp_path: Path) -> None:
    cycle = make_cycle(solve_template(load_template("stone-crusher"), {}))
    pdf = write_cycle(cycle, ENGLISH, "pdf")
    text = " ".join(page.extract_text() for page in PdfReader(io.BytesIO(pdf)).pages)
    assert "full turns of the input" in text
    assert "time ratio 1.038" in text


def read_baked(html: str) -> dict[str, object]:
    found = re.search(r"DATA = (\{.*\});\n", html)
    assert found is not None
    baked: dict[str, object] = json.loads(found[1])
    return baked


def test_the_moving_figure_begins_at_the_instant_and_loads_nothing() -> None:
    html = kinegrade.template("slider-crank").animate(phi=30).html
    assert not re.search(r"(src|href)=|url\(|import|fetch|http(?!://www.w3.org/2000/svg)", html)
    baked = read_baked(html)
    assert baked["moved"][baked["first"]] == "0.0"  # type: ignore[index]
    assert baked["closed"] is True
    assert len(baked["drawings"]) == 72  # type: ignore[arg-type]


def test_the_page_that_moves_is_whole_and_escapes_what_it_shows() -> None:
    cycle = make_cycle(solve_template(load_template("pole-four-bar-coupler"), {}))
    page = write_cycle(cycle, Language("zh"), "html").decode()
    assert page.startswith('<!DOCTYPE html>\n<html lang="zh')
    assert page.count("<script>") == 1
    assert "播放" in page


@pytest.mark.sampled(6)
@pytest.mark.parametrize("name", MANY)
def test_every_drawing_of_a_moving_figure_lies_within_its_frame(name: str) -> None:
    template = load_template(name)
    figure = draw_moving_figure(follow(solve_template(template, {}).motion), template.figure)
    assert figure.width <= 170
    assert figure.height <= 140
    assert len(figure.drawings) == len(figure.moved) >= 8
    assert figure.moved[figure.first] == 0


def test_what_cannot_move_says_why() -> None:
    with pytest.raises(MechanismError) as refused:
        kinegrade.template("pose-four-bar-coupler").animate()
    assert str(refused.value) == (
        "pose-four-bar-coupler: no driver moves the mechanism: it has no cycle"
    )


def test_poles_in_a_table_are_those_of_the_textbook() -> None:
    """The pole of a connecting rod lies on the crank's line, above the slider."""
    cycle = make_cycle(solve_template(load_template("slider-crank"), {}), ())
    table = write_cycle(cycle, ENGLISH, "csv").decode("utf-8-sig")
    read = 0
    for row in csv.DictReader(io.StringIO(table)):
        x_a, y_a, x_b, x, y = (
            float(row[name] or "nan")
            for name in ("x_A (m)", "y_A (m)", "x_B (m)", "x_P (m)", "y_P (m)")
        )
        if abs(x) < 10 and abs(y) < 10:
            assert x == pytest.approx(x_b, abs=1e-9)
            assert x_a * y == pytest.approx(y_a * x, abs=1e-8)
            read += 1
    assert read > 600


def test_a_trammels_centrodes_are_cardans_circles() -> None:
    """One of the bar's length about the corner, and one of half of that, on the bar."""
    solution = solve_template(load_template("elliptic-trammel-end-driven"), {})
    path = follow(solution.motion)
    (centrodes,) = trace_centrodes(path.place(path.spread(41)[1:-1]), find_poled_bodies(path))
    corner, bar = path.motion.points["A"], path.motion.points["B"]
    length = float(np.hypot(corner.x - bar.x, corner.y - bar.y))
    assert np.hypot(*centrodes.fixed) == pytest.approx(length, rel=1e-9)
    middle = (corner + bar) / 2
    arm = centrodes.moving - np.array([[float(middle.x)], [float(middle.y)]])
    assert np.hypot(*arm) == pytest.approx(length / 2, rel=1e-9)


@pytest.mark.sampled(6, first=1)
@pytest.mark.parametrize("name", MANY)
def test_figures_with_centrodes_keep_to_their_frame(name: str) -> None:
    solution = solve_template(load_template(name), {})
    plain, figure = (draw_cycle(make_cycle(solution, (), centrodes=each)) for each in (False, True))
    assert figure.width <= 170
    assert figure.height <= 140
    assert len(figure.drawings) == len(plain.drawings)
    drawn = find_common_box(part for each in figure.drawings for part in (*figure.still, *each))
    assert 0 <= drawn.left <= drawn.right <= figure.width
    assert 0 <= drawn.bottom <= drawn.top <= figure.height


def test_a_closed_centrode_is_shown_whole_and_its_pole_named() -> None:
    """Cardan's circles: the fixed one about the corner, of the bar's length."""
    solution = solve_template(load_template("elliptic-trammel-crank-driven"), {})
    cycle = make_cycle(solution, (), centrodes=True)
    figure = draw_cycle(cycle)
    [fixed] = [part for part in figure.still if isinstance(part, Outline) and part.pen == Pen(0.25)]
    across, upward = np.array([tuple(corner) for corner in fixed.corners]).T
    assert np.ptp(across) == pytest.approx(np.ptp(upward), rel=1e-3)
    letters = [part.symbol for part in figure.at_instant if isinstance(part, Label)]
    assert letters.count("P") == 1


def test_centrodes_are_in_every_picture_where_they_are_wanted() -> None:
    solution = solve_template(load_template("slider-crank"), {})
    plain, shown = (make_cycle(solution, ("v_B",), centrodes=each) for each in (False, True))
    for kind in ("svg", "html", "pdf"):
        assert len(write_cycle(shown, ENGLISH, kind)) > len(write_cycle(plain, ENGLISH, kind))
