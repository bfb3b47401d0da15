"""Figures as SVG: well-formed, complete, within their box, with letters as they are printed."""

from __future__ import annotations

import re
from itertools import pairwise
from math import hypot, pi
from xml.etree import ElementTree

import pytest

from kinegrade.errors import TypesetError
from kinegrade.exam.quiz.paper import show_instance
from kinegrade.figure.back_ends.svg import to_svg
from kinegrade.figure.placing.extent import EM, measure_symbol
from kinegrade.figure.scene import FIRM, Bow, Disc, Label, Outline, Primitive, Scene
from kinegrade.figure.sketch import sketch
from kinegrade.language.math.runs import split_symbol
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.library.library import find_template_names, load_template
from tests.figure.mechanisms import EIGHT

SVG = "{http://www.w3.org/2000/svg}"


def drawn(*primitives: Primitive) -> ElementTree.Element:
    return ElementTree.fromstring(to_svg(Scene(40.0, 30.0, 1.0, primitives)))


def numbers(text: str) -> list[float]:
    return [float(number) for number in re.findall(r"-?[\d.]+", text)]


def texts(root: ElementTree.Element) -> list[str]:
    return ["".join(text.itertext()) for text in root.iter(f"{SVG}text")]


@pytest.mark.sampled(8, first=2)
@pytest.mark.parametrize("name", find_template_names())
def test_a_shipped_figure_is_whole_and_within_its_box(name: str) -> None:
    template = load_template(name)
    scene = sketch(show_instance(template, {}, template.asks).mechanism, template.figure)
    root = ElementTree.fromstring(to_svg(scene))
    left, top, width, height = numbers(root.attrib["viewBox"])
    assert (left, top) == (0, 0)
    assert (width, height) == pytest.approx((scene.width, scene.height), abs=0.01)
    shapes = [element for element in root.iter() if element.tag in (f"{SVG}path", f"{SVG}circle")]
    assert len(shapes) + len(texts(root)) == len(scene.primitives)
    for path in root.iter(f"{SVG}path"):
        for x, y in zip(
            *[iter(numbers(re.sub(r"A\S+ \S+ 0 0 \d", "", path.attrib["d"])))] * 2, strict=True
        ):
            assert -0.01 <= x <= width + 0.01, name
            assert -0.01 <= y <= height + 0.01, name
    for label, text in zip(scene.labels, root.iter(f"{SVG}text"), strict=True):
        half = measure_symbol(label.symbol)[0] / 2
        assert half - 0.01 <= float(text.attrib["x"]) <= width - half + 0.01, label.symbol
        assert 0 < float(text.attrib["y"]) <= height, label.symbol


def test_the_picture_is_black_on_white_in_millimetres() -> None:
    scene = sketch(*EIGHT["slider-crank"][0](*EIGHT["slider-crank"][1][0]))
    root = ElementTree.fromstring(to_svg(scene))
    assert root.attrib["width"] == f"{scene.width:.2f}".rstrip("0").rstrip(".") + "mm"
    assert root[0].tag == f"{SVG}rect"
    assert root[0].attrib["fill"] == "#fff"


def test_y_points_up_on_paper_and_down_in_the_picture() -> None:
    path = drawn(Outline((Vector(1.0, 2.0), Vector(3.0, 2.0), Vector(3.0, 5.0)), FIRM)).find(
        f".//{SVG}path"
    )
    assert path is not None
    assert path.attrib["d"] == "M1 28L3 28L3 25Z"


@pytest.mark.parametrize("sweep", [pi / 2, -pi / 2, 1.9 * pi, -1.5 * pi, 2 * pi])
def test_an_arc_turns_the_way_the_scene_says(sweep: float) -> None:
    path = drawn(Bow(Vector(20.0, 15.0), 10.0, 0.0, sweep, FIRM)).find(f".//{SVG}path")
    assert path is not None
    arcs = re.findall(r"A10 10 0 0 (\d) ([-\d.]+) ([-\d.]+)", path.attrib["d"])
    # 0 is counter-clockwise, as y points down
    assert {flag for flag, _, _ in arcs} == {"0" if sweep > 0 else "1"}
    points = [(30.0, 15.0), *((float(x), float(y)) for _, x, y in arcs)]
    for (x, y), (next_x, next_y) in pairwise(points):
        assert hypot(x - 20, y - 15) == pytest.approx(10, abs=0.01)
        assert hypot(next_x - x, next_y - y) < 20  # below half a circle its two ends tell it
    assert len(arcs) == max(1, -(-abs(sweep) // (pi * 0.999)))


def test_circles_have_their_fill_and_pen() -> None:
    disc, dot = drawn(
        Disc(Vector(5.0, 6.0), 2.0, FIRM, "white"), Disc(Vector(5.0, 6.0), 1.0, None, "black")
    ).iter(f"{SVG}circle")
    assert disc.attrib == {"cx": "5", "cy": "24", "r": "2", "fill": "#fff", "stroke-width": "0.4"}
    assert (dot.attrib["fill"], dot.attrib["stroke"]) == ("#000", "none")


@pytest.mark.parametrize(
    ("symbol", "letters"),
    [
        ("O_1", "O1"),
        ("O'", "O′"),
        (r"\omega_{AB}", "ωAB"),
        (r"\mathrm{II}", "II"),
        ("k r", "kr"),
        (r"-\delta", "−δ"),
        (r"\frac{l}{2}", "l/2"),
        (r"\sqrt{3}r", "√3r"),
        (r"\sqrt{k l}", "√(kl)"),
        (r"30^\circ", "30°"),
        (r"\vec{v}", "v\u20d7"),
        (r"\varphi_{\mathrm{r}}", "φr"),
        ("a=b", "a=b"),
    ],
)
def test_symbols_read_as_they_are_printed(symbol: str, letters: str) -> None:
    assert texts(drawn(Label(symbol, Vector(9.0, 9.0), 5.0, 4.0))) == [letters]


def test_letters_are_italic_and_digits_upright_scripts_small_and_shifted() -> None:
    letter, index = split_symbol("O_1", "label")
    assert (letter.italic, index.italic) == (True, False)
    assert index.size < letter.size
    assert index.shift < letter.shift == 0
    bold = split_symbol(r"\boldsymbol{v}_{BA}", "label")
    assert [(run.bold, run.italic) for run in bold] == [(True, True), (False, True)]


def test_two_scripts_stand_one_above_the_other() -> None:
    _, low, high = split_symbol("a_{BA}^{t}", "label")
    assert low.shift < 0 < high.shift
    width = (measure_symbol("{BA}")[0] / EM - 0.12) * low.size
    assert 0.6 * width < high.back < 0.9 * width  # over the lower one, and never on the base


def test_a_prime_is_high_by_itself() -> None:
    assert split_symbol(r"B^\prime", "label") == split_symbol("B'", "label")
    assert split_symbol("B'", "label")[-1].shift == 0


def test_the_middle_of_the_letters_is_the_middle_of_the_box() -> None:
    low, tall = (
        next(drawn(Label(symbol, Vector(9.0, 9.0), 5.0, 4.0)).iter(f"{SVG}text"))
        for symbol in ("a", "A")
    )
    middle = 21.0
    assert middle < float(low.attrib["y"]) < float(tall.attrib["y"]) < middle + EM / 2


def test_what_is_no_symbol_is_refused() -> None:
    for symbol in ("<script>", r"\input{x}", "a$b"):
        with pytest.raises(TypesetError, match=r"^figure\.labels: "):
            drawn(Label(symbol, Vector(1.0, 1.0), 1.0, 1.0))


def test_numbers_are_short_and_the_same_on_every_machine() -> None:
    for build, values in EIGHT.values():
        assert not re.search(r"\d\.\d{3,}|\de[-+]\d", to_svg(sketch(*build(*values[0]))))
