"""Every worked solution obeys the laws of print, read from its document alone; the reader of it is
tried with pages that break each law.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import islice

import pytest
from msgspec import structs

from kinegrade.figure.scene import Label, Strokes
from kinegrade.figure.vectors.chains import Arrow, find_corners
from kinegrade.figure.vectors.polygon import draw_polygon
from kinegrade.language import Language
from kinegrade.language.math.reading import read_math
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.texts import find_languages
from kinegrade.worked.document import Block, Display, Picture, Pictures, Prose, TermTable
from kinegrade.worked.solution import write_worked_solution
from tests.worked.draws import drawn, kept, told
from tests.worked.reader.economy import find_repeated, find_unused
from tests.worked.reader.known import KNOWN
from tests.worked.reader.laws import LAWS, Law, find_faults
from tests.worked.reader.polygons import judge_polygons
from tests.worked.telling import lines, read_term


def _broken(name: str, language: Language = "en") -> dict[Law, list[str]]:
    """The laws that the solutions of a template break, each with the lines that do."""
    found: dict[Law, list[str]] = {}
    for place, solution in enumerate(drawn(name)):
        for fault in find_faults(kept(name, place, language=language), solution):
            found.setdefault(fault.law, []).append(fault.line)
    return found


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_a_solution_obeys_the_laws_of_print_and_is_not_excused_without_need(name: str) -> None:
    broken = _broken(name)
    excused = {law for law, names in KNOWN.items() if name in names}
    assert {law: told for law, told in broken.items() if law not in excused} == {}
    assert excused - set(broken) == set()


@pytest.mark.sampled(24, first=1)
@pytest.mark.parametrize("language", ["zh", "de"])
@pytest.mark.parametrize("name", find_template_names())
def test_it_does_so_in_every_language(name: str, language: Language) -> None:
    known = find_languages(load_template(name))
    # what an ask tells in other words alone: a symbol, and by which of two signs it is counted
    untold = set() if language in known else {"symbol", "once"}
    untold |= {law for law, names in KNOWN.items() if name in names}
    assert set(_broken(name, language)) - untold == set(_broken(name)) - untold


def test_only_shipped_templates_are_excused() -> None:
    assert set().union(*KNOWN.values()) <= set(find_template_names())


ALONG, ACROSS = Arrow("v_S", Vector(1.0, 0.0)), Arrow("v_U", Vector(0.5, 0.5), known=False)
BACK = Arrow("v_W", Vector(0.5, -0.5))


def _draw(left: list[Arrow], right: list[Arrow]) -> Pictures:
    """A polygon whose every corner has a letter."""
    tips = (tip for side in (left, right) for tip in islice(find_corners(side), 1, None))
    scene = draw_polygon(left, right, dict(zip("abcde", dict.fromkeys(tips), strict=False)))
    return Pictures((Picture(scene, "velocity polygon, 1 mm corresponds to 1 m/s"),))


def _draw_bare(left: list[Arrow], right: list[Arrow]) -> Pictures:
    """A polygon without the letters of its corners."""
    (picture,) = _draw(left, right).pictures
    kept = (
        part
        for part in picture.scene.primitives
        if not isinstance(part, Label) or len(part.symbol) > 1
    )
    return Pictures(
        (replace(picture, scene=structs.replace(picture.scene, primitives=tuple(kept))),)
    )


WRONG: dict[Law, tuple[Block, ...]] = {
    "equal": (Display((read_math(r"r = 2\,\unit{m}", ""), read_math(r"b = r = 3\,\unit{m}", ""))),),
    "rounded": (Display((read_math(r"s = \frac{\sqrt{3}}{2} = 0.8660", ""),)),),
    "exact": (Display((read_math(r"s = 2 \cdot 0.3333 = \frac{2}{3} \approx 0.6667", ""),)),),
    "settled": (Display((read_math(r"s = \frac{1}{2} \approx 0.5", ""),)),),
    "short": (Display((read_math(r"s = \sqrt{2739201267} \approx 52337", ""),)),),
    "unit": (Display((read_math(r"s = 1 + 2\,\unit{m}", ""),)),),
    "symbol": (Display((read_math(r"s = 2q", ""),)),),
    "angle": (Prose(r"Projected on the axis at $330^\circ$"),),
    "point": (Display((read_math(r"x_{X} = 2\,\unit{m}", ""),)),),
    "closed": (_draw([ALONG], [ACROSS]),),
    "corner": (_draw_bare([ALONG], [ACROSS, BACK]),),
    "used": (Display((read_math(r"s = 1 + 1 = 2", ""),)),),
    "once": (Prose("The rope $A$ does not turn here, so that is zero."),) * 2,
    "sense": (TermTable((read_term("", "v_A", r"$2\,\unit{m/s}$", r"$\parallel x$"),)),),
    "early": (
        TermTable((read_term("", "v_A", r"$OM \cdot \omega$", r"$\perp OM,\curvearrowleft$"),)),
        Prose(r"Here $OM = 2\,\unit{m}$."),
    ),
    "way": (Display((read_math(r"\omega_{AB} &= \boxed{2\,\unit{rad/s}}", ""),)),),
    "inclined": (
        TermTable((read_term("", r"\boldsymbol{v}_A", "?", r"$\perp AB,\curvearrowleft$"),)),
        Prose(r"$AB$ makes the acute angle $\psi$ with the $x$ axis."),
        Display((read_math(r"v_{A}\sin\psi = 2\,\unit{m/s}", ""),)),
    ),
    "between": (
        Display((read_math(r"\psi = 30^\circ", ""),)),
        Prose(r"The angle between $OA$ and $OB$ is $180^\circ - \psi$."),
    ),
    "marked": (Display((read_math(r"a_{B}^{\mathrm{n}} = 2\,\unit{m/s^2}", ""),)),),
    "named": (Display((read_math(r"\alpha_{AB} = 2\,\unit{rad/s^2}", ""),)),),
    "size": (
        Prose("Sought: $v_{B}$ (speed of slider $B$)."),
        Display((read_math(r"v_{B} = -2\,\unit{m/s}", ""),)),
    ),
    "senses": (
        Display(
            (
                read_math(r"v_{B} &= 2\,\unit{m/s}\quad\text{(to the left)}", ""),
                read_math(r"v_{C} &= -3\,\unit{m/s}\quad\text{(to the left)}", ""),
            )
        ),
    ),
    "lettered": (
        Prose(
            r"Check by Pythagoras: $(2\,\unit{m})^{2} = 4\,\unit{m^2}$; left side"
            r" $(2\,\unit{m})^{2} = 4\,\unit{m^2}$, right side $4\,\unit{m^2}$; they agree."
        ),
    ),
    "doubled": (
        Prose(
            r"Check by Pythagoras: $a^{2} = b^{2}$; left side $4\,\unit{m^2} \approx"
            r" 4\,\unit{m^2}$, right side $4\,\unit{m^2}$; they agree."
        ),
    ),
    "signed": (
        Display((read_math(r"\left|v_{B}\right| = 2\,\unit{m/s}", ""),)),
        Prose(
            r"Check by Pythagoras: $-v_{B} = \left|v_{B}\right|$; left side $2\,\unit{m/s}$,"
            r" right side $2\,\unit{m/s}$; they agree."
        ),
    ),
    "zero": (
        Display(
            (read_math(r"y_{A} &= 2\,\unit{m} - 4\,\unit{m} \cdot \sin 30^\circ \approx 0", ""),)
        ),
    ),
    "redone": (
        Prose(
            r"Check by Pythagoras: $a^{2} + b^{2} = c^{2}$; left side"
            r" $(2\,\unit{m/s})^{2} + (1.333\,\unit{m/s})^{2} \approx"
            r" 5.778\,\unit{m^2/s^2}$, right side $5.778\,\unit{m^2/s^2}$; they agree."
        ),
        Prose(
            r"Check by Pythagoras: $a^{2} + b^{2} = c^{2}$; left side"
            r" $(2\,\unit{m/s})^{2} + (1.333\,\unit{m/s})^{2} \approx"
            r" 5.779\,\unit{m^2/s^2}$, right side $5.778\,\unit{m^2/s^2}$; they agree."
        ),
    ),
    "figure": (
        Display(
            (read_math(r"s = 0.7206\,\unit{m} - 0.7125\,\unit{m} \approx 0.008254\,\unit{m}", ""),)
        ),
    ),
    "independent": (
        Display(
            (
                read_math(r"x_{C} = r\cos\varphi = 0.5\,\unit{m}", ""),
                read_math(r"x_{C}^{2} + y_{A}^{2} = r^{2}", ""),
                read_math(r"y_{A} = \sqrt{r^{2} - x_{C}^{2}} \approx 0.8660\,\unit{m}", ""),
            )
        ),
        Prose(
            r"Check by Pythagoras: $\sqrt{x_{C}^{2} + y_{A}^{2}} = r$; left side $1\,\unit{m}$,"
            r" right side $1\,\unit{m}$; they agree."
        ),
    ),
    "sign": (
        Display(
            (read_math(r"v = 2.419\,\unit{m/s} \cdot \sin 7^\circ \approx 0.3\,\unit{m/s}", ""),)
        ),
    ),
    "solved": (
        Display(
            (
                read_math(r"v - 2\,\unit{rad/s} \cdot 3\,\unit{m} = 0", ""),
                read_math(r"v = 2\,\unit{rad/s} \cdot 4\,\unit{m} = 8\,\unit{m/s}", ""),
            )
        ),
    ),
    "given": (Display((read_math(r"r = -1\,\unit{m}", ""),)),),
    "label": (Display((read_math(r"v_S = 2\,\unit{m}", ""),)), _draw([ALONG], [ACROSS, BACK])),
}


@pytest.mark.parametrize("law", LAWS)
def test_a_page_that_breaks_a_law_is_found(law: Law) -> None:
    solution = drawn("slider-crank")[0]
    assert law in {fault.law for fault in find_faults(WRONG[law], solution)}


def test_an_arrow_beside_its_place_is_found() -> None:
    page = _draw([ALONG], [ACROSS, BACK])
    (picture,) = page.pictures
    (first, *rest) = picture.scene.primitives
    assert isinstance(first, Strokes)
    ((start, tip),) = first.lines
    moved = structs.replace(first, lines=((start + Vector(0.0, 0.02), tip),))
    torn = replace(picture, scene=structs.replace(picture.scene, primitives=(moved, *rest)))
    for pictures, faults in ((page, []), (Pictures((torn,)), ["closed"])):
        assert [fault.law for fault in judge_polygons((pictures,), {})] == faults


def test_a_sentence_with_other_points_is_another_one() -> None:
    page = (
        Prose("The velocity of $B$ is that of the base point $A$."),
        Prose("The velocity of $C$ is that of the base point $B$."),
    )
    assert list(find_repeated(page)) == []


def test_what_a_check_or_a_table_alone_takes_up_is_used() -> None:
    found = Display((read_math(r"v_{DB} = 1\,\unit{m/s} + 1.5\,\unit{m/s} = 2.5\,\unit{m/s}", ""),))
    assert list(find_unused((found,))) != []
    assert list(find_unused((found, Prose(r"left side $2.5\,\unit{m/s}$")))) == []
    table = TermTable(
        (read_term("", r"\boldsymbol{v}_{\mathrm{a}}", r"$2.5\,\unit{m/s}$", "$+x$"),)
    )
    assert list(find_unused((found, table))) == []


def test_a_page_without_faults_has_none() -> None:
    page_lines = (
        r"s = r\cos\varphi = 1\,\unit{m} \cdot \cos 60^\circ = 0.5\,\unit{m}",
        r"h = r\sin\varphi = \frac{\sqrt{3}}{2}\,\unit{m} \approx 0.8660\,\unit{m}",
        r"\psi = 90^\circ - \varphi = 30^\circ",
        r"u = s\cos(\varphi + \psi) = 0.5\,\unit{m} \cdot \cos 90^\circ = 0",
    )
    page = Display(tuple(read_math(line, "") for line in page_lines))
    end = Prose("Above stand $u$ and $h$.")
    assert list(find_faults((page, end), drawn("slider-crank")[0])) == []


def test_the_double_of_an_angle_at_a_corner_is_read() -> None:
    page_lines = (
        r"\angle OAB = 36^\circ",
        r"s = r\sin 2\angle OAB = 1\,\unit{m} \cdot \sin 72^\circ \approx 0.9511\,\unit{m}",
    )
    page = Display(tuple(read_math(line, "") for line in page_lines))
    end = Prose("Above stands $s$.")
    assert list(find_faults((page, end), drawn("slider-crank")[0])) == []


@pytest.mark.parametrize(
    ("line", "laws"),
    [
        (r"v = 0.3333\,\unit{m} \cdot 1.5 = 0.5\,\unit{m}", set()),
        (r"v = 0.3333\,\unit{m} \cdot 1.5 \approx 0.5\,\unit{m}", {"sign"}),
        (r"v = 0.3333\,\unit{m} \cdot 1.7 = 0.567\,\unit{m}", {"equal", "figure"}),
        (r"v = 0.3333\,\unit{m} \cdot 1.7 \approx 0.5667\,\unit{m}", set()),
        (r"v = 0.5666\,\unit{m} = 0.567\,\unit{m}", {"equal", "rounded"}),
        (r"0.6\,\unit{m} \cdot 7.5 \approx 4.5\,\unit{m}", {"settled", "sign"}),
        (r"0.61\,\unit{m} \cdot 7.5 \approx 4.7\,\unit{m}", {"equal", "figure", "sign"}),
    ],
)
def test_a_number_of_few_digits_is_exact_after_rounded_ones(line: str, laws: set[Law]) -> None:
    page = (Display((read_math(line, ""),)), Prose("Above stands $v$."))
    assert {fault.law for fault in find_faults(page, drawn("slider-crank")[0])} == laws


@pytest.mark.parametrize(
    "right", [[ACROSS, BACK], [Arrow("v_U", Vector(1.6, 0.0)), Arrow("v_W", Vector(-0.6, 0.0))]]
)
def test_a_polygon_that_closes_has_no_faults_with_arrows_drawn_aside_or_not(
    right: list[Arrow],
) -> None:
    symbol = Display((read_math(r"v_S = 1\,\unit{m}", ""),))
    page = (symbol, _draw([ALONG], right), Prose("Above stands $v_S$."))
    assert list(find_faults(page, drawn("slider-crank")[0])) == []


def test_an_arrow_may_lead_past_a_vector_that_its_caption_names_as_too_short() -> None:
    short, known = Vector(0.0066, 0.0066), Display((read_math(r"v_U = 0.7071\,\unit{m}", ""),))
    right = [ACROSS, Arrow("v_T", short), Arrow("v_W", BACK.value - short)]
    (picture,) = _draw([ALONG], right).pictures
    named = replace(picture, caption=f"{picture.caption} (too short to draw: $v_T$)")
    for one, laws in ((picture, {"label"}), (named, set[str]())):
        page = (known, Pictures((one,)), Prose("Above stand $v_U$ and $v_T$."))
        assert {fault.law for fault in find_faults(page, drawn("slider-crank")[0])} == laws


def _lines_with(name: str, part: str) -> list[str]:
    return [line for line in lines(kept(name)) if part in line]


@pytest.mark.parametrize(
    ("name", "derived", "given"),
    [
        ("guided-rack-and-gear", "{AC}", r"\cos(\varphi - \psi_{AO})"),
        ("bent-rod-two-sleeves", "{EM}", r"\cos\varphi"),
        ("bent-rod-two-sleeves", "{BM}", r"\cos(\varphi + \psi_{AM})"),
    ],
)
def test_a_line_that_a_given_angle_places_has_no_angle_of_its_own(
    name: str, derived: str, given: str
) -> None:
    assert not _lines_with(name, rf"\psi_{derived}")
    assert _lines_with(name, given)


def test_a_coordinate_is_told_once() -> None:
    assert len(_lines_with("pose-four-bar-coupler", "y_{C} &")) == 1


def test_a_table_says_in_which_direction_an_unknown_vector_is_assumed() -> None:
    (velocity, acceleration) = _lines_with("slider-crank", "_{B} | ?")
    assert velocity.endswith("| $+x$")
    assert acceleration.endswith("| $+x$")
    assert _lines_with("slotted-bar-between-two-rods", r"_{\mathrm{r}} | ? | $B \to A$")


def test_a_component_along_an_axis_has_the_given_angle() -> None:
    # it had the angle between vector and axis, which nothing on the page told
    values = {"R": "0.25", "phi": "60", "gamma": "-30", "delta": "105", "k_BC": "2"}
    values |= {"k_OB": "3/2", "omega": "3", "alpha": "4"}
    solution = solve_template(load_template("bar-pushing-rolling-disc"), values)
    blocks = told(solution)
    assert r"v_{B,x} &= -v_{B}\sin\delta" in "\n".join(lines(blocks))
    assert [fault.line for fault in find_faults(blocks, solution) if fault.law == "angle"] == []


def test_a_point_of_contact_is_placed_for_velocities_about_it_alone() -> None:
    name = "planetary-gear-external-rim-accelerations"
    solution = solve_template(load_template(name), {})
    about_points, about_centre = (
        list(lines(write_worked_solution(solution, (ask,), "en").blocks)) for ask in ("v_A", "a_A")
    )
    assert any("x_{C} &=" in line for line in about_points), about_points
    assert [line for line in about_centre if "x_{C} &=" in line] == []


def test_an_answer_in_the_sense_of_the_question_repeats_the_decimals_found() -> None:
    # -51/22 came after a number that had been worked out from rounded ones
    values = {"R": "0.3", "d": "0.82", "omega_1": "5", "omega_2": "3"}
    solution = solve_template(load_template("pin-in-two-rings"), values)
    page = "\n".join(lines(write_worked_solution(solution, ("v_rel_1",), "en").blocks))
    assert r"\approx \boxed{-2.3182\,\unit{m/s}}" in page
    assert r"\frac{51}{22}" not in page


def test_two_compositions_of_different_points_have_two_absolute_velocities() -> None:
    # both began with v_a, and went on with v_a1 and v_a2
    page = "\n".join(lines(kept("square-on-two-fixed-points")))
    for number in "12":
        absolute, transport = (rf"\boldsymbol{{v}}_{{\mathrm{{{role}}}{number}}}" for role in "ae")
        assert f"{absolute} = {transport}" in page
