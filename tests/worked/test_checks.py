"""The check at the end of a chapter uses printed values alone, agrees, and shows a slip."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, replace

import pytest

from kinegrade.language import ENGLISH, Language
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Row
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.document import Block, Prose
from kinegrade.worked.formulas.atoms import Number
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.notation import PLAIN
from kinegrade.worked.solution import write_worked_solution
from tests.worked.draws import drawn, kept, stated
from tests.worked.reader.amounts import Amount, Unreadable
from tests.worked.reader.checks import list_sides
from tests.worked.reader.forms import is_decimal, measure_last_digit
from tests.worked.reader.formula_reader import find_symbols, read_formula
from tests.worked.telling import lines, proses

CHECK = re.compile(
    r"^Check by (?P<way>.*): \$(?P<equation>[^$]*)\$; "
    r"left side \$(?P<left>.*)\$, right side \$(?P<right>.*)\$; "
    r"they agree(?: to \d significant digits)?\.$"
)
RELATION = re.compile(r"=|\\approx")


@dataclass(frozen=True)
class Check:
    """The way, and each side of the equation, in letters and in numbers, with its value."""

    way: str
    left: str
    right: str

    @property
    def sides(self) -> tuple[list[Amount], list[Amount]]:
        """What each side is worth as it is printed: the sum, and the value said of it."""
        return read_side(self.left), read_side(self.right)

    @property
    def agrees(self) -> bool:
        """Whether the values said of both sides are the same."""
        left, right = (RELATION.split(side)[-1].strip() for side in (self.left, self.right))
        return left == right


def find_checks(blocks: Iterable[Block]) -> list[Check]:
    texts = [block.text for block in blocks if isinstance(block, Prose)]
    return [_read_check(found) for text in texts if (found := CHECK.match(text))]


def _read_check(found: re.Match[str]) -> Check:
    """The check with the letters of either side before its numbers."""
    left, right = list_sides(found["equation"], found["left"], found["right"])
    return Check(found["way"], left, right)


def read_checks(name: str, place: int = 0) -> list[Check]:
    return find_checks(kept(name, place))


def read_side(side: str) -> list[Amount]:
    """What a side amounts to: in numbers and by its value; letters stand before these alone."""
    rows = [read_math(part.strip(), "test") for part in list_numbers(side)]
    return [_count_last_digit(row, read_formula(row, refuse)) for row in rows]


def _count_last_digit(row: Row, amount: Amount) -> Amount:
    """A decimal with as much room as its last digit leaves."""
    if not is_decimal(row) or not amount.value:
        return amount
    return replace(amount, room=max(amount.room, measure_last_digit(row, amount.value) / 2))


def list_numbers(side: str) -> list[str]:
    first, *others = RELATION.split(side)
    lettered = any(find_symbols(read_math(first.strip(), "test")))
    return others if others and lettered else [first, *others]


def refuse(symbol: str) -> Amount:
    """A check has no symbols."""
    raise Unreadable(symbol)


def test_a_rod_is_checked_by_differentiating_a_coordinate() -> None:
    assert read_checks("slider-crank")[0] == Check(
        "the time derivative of $x_{A} + (x_{B} - x_{A}) = x_{B}$"
        " (each difference turns with its body)",
        r"-\omega_{OA}\,y_{A} + \omega_{AB}\,y_{A} = -(-1\,\unit{rad/s}) \cdot 0.8660\,\unit{m}"
        r" + 0.3333\,\unit{rad/s} \cdot 0.8660\,\unit{m} \approx 1.155\,\unit{m/s}",
        r"v_{B} = 1.155\,\unit{m/s}",
    )


@pytest.mark.parametrize(
    ("name", "language", "said"),
    [
        (
            "slider-crank",
            "en",
            r"its body): $-\omega_{OA}\,y_{A} + \omega_{AB}\,y_{A} = v_{B}$; left",
        ),
        (
            "slider-crank",
            "de",
            r"ihrem Körper): $-\omega_{OA}\,y_{A} + \omega_{AB}\,y_{A} = v_{B}$; linke",
        ),
        (
            "slider-crank",
            "zh",
            r"求时间导数（各坐标差随所在刚体转动），得 $-\omega_{OA}\,y_{A} + \omega_{AB}\,y_{A} = v_{B}$；左边",
        ),
        (
            "slider-crank-relative-rotation-driver",
            "en",
            r"half the time derivative of $(x_{B} - x_{A})^{2} + y_{A}^{2} = l^{2}$: $(x_{B} - x_{A})",
        ),
    ],
)
def test_the_equation_of_a_check_stands_before_the_numbers_of_its_sides(
    name: str, language: Language, said: str
) -> None:
    """Both sides were worked out of an equation that was never written."""
    assert said in "\n".join(proses(kept(name, language=language)))


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_every_check_says_one_equation_in_letters(name: str) -> None:
    for place in range(len(drawn(name))):
        checks = [text for text in proses(kept(name, place)) if text.startswith("Check by ")]
        assert len(checks) == len(read_checks(name, place))


def test_an_angle_that_is_a_sum_nobody_has_worked_out_is_in_no_check() -> None:
    """The jaw lies at delta + beta + gamma; no line before has the 135 degrees."""
    lengths = {"OE": "9/50", "BG": "11/20", "AB": "1/2", "d": "9/10"}
    given = {**lengths, "delta": "30", "beta": "30", "gamma": "75", "psi": "-75"}
    template = load_template("stone-crusher")
    asked = template.asked()
    solution = solve_template(template, given, asked)
    checks = find_checks(write_worked_solution(solution, asked, ENGLISH).blocks)
    assert checks
    assert [check for check in checks if "135" in check.left + check.right] == []


def test_a_point_in_two_slots_is_checked_by_the_components_that_are_asked() -> None:
    given = {"b": "0.1", "phi": "30", "omega_1": "9", "omega_2": "3"}
    check, _ = find_checks(stated("pin-in-disc-slot-and-rod", **given, alpha_1="0", alpha_2="0"))
    assert check == Check(
        "the time derivative of $y_{M}$ in two ways",
        r"v_{M,y} = 0.1\,\unit{m/s}",
        r"\omega_{\text{rod}}\,x_{M} + \frac{v_{\mathrm{r}2}}{OM}\,y_{M} = 3\,\unit{rad/s}"
        r" \cdot 0.1\,\unit{m} + \frac{-0.4\,\unit{m/s}}{0.11547\,\unit{m}}"
        r" \cdot 0.057735\,\unit{m} = 0.1\,\unit{m/s}",
    )


AREA = Number("0.1596") ** Number("2") - Number("0.05807").dot(Number("0.01193"))


@pytest.mark.parametrize(
    ("value", "numbers", "digits"),
    [
        (2.1134, Number("85.34").dot(AREA), 3),  # a reader gets 2.115
        (0.5, Number("0.5"), 4),
        (3.7e-7, Number("1.234") - Number("1.233"), 0),
    ],
)
def test_a_side_has_as_many_digits_as_its_printed_numbers_give(
    value: float, numbers: Formula, digits: int
) -> None:
    assert Side(numbers, value).count_digits(PLAIN) == digits


def test_a_circle_that_turns_is_checked_by_a_coordinate_of_the_point_on_it() -> None:
    assert read_checks("eccentric-cam-offset-follower")[0] == Check(
        "the time derivative of $y_{A}$, once directly and once by the motion relative to the cam",
        r"v_{\mathrm{a}} = -1.6\,\unit{m/s}",
        r"\omega_{\text{cam}}\,x_{A} - \frac{v_{\mathrm{r}}}{r}\,(x_{A} - x_{C}) ="
        r" -10\,\unit{rad/s} \cdot (-0.32\,\unit{m}) - \frac{-5\,\unit{m/s}}{0.5\,\unit{m}} \cdot"
        r" (-0.48\,\unit{m}) = -1.6\,\unit{m/s}",
    )


def test_a_pole_is_checked_by_a_coordinate_with_both_rotations() -> None:
    assert (
        read_checks("pole-four-bar-coupler")[0].way
        == "the time derivative of $x_{C} = x_{B} + (x_{C} - x_{B})$"
        " (each difference turns with its body)"
    )


def test_a_planet_is_checked_as_its_carrier_sees_it() -> None:
    values = {"R1": "0.4", "R2": "0.16", "phi_3": "30", "omega_3": "1"}
    assert find_checks(stated("ring-gear-planet-relative-spin", **values))[0] == Check(
        "the rim speeds of the planet gear and of the fixed circle, seen from the arm $O_{1}O_{2}$",
        r"R_{2}(\omega_{2} - \omega_{O_{1}O_{2}}) = 0.16\,\unit{m} \cdot (-1.5\,\unit{rad/s} - 1\,\unit{rad/s}) = -0.4\,\unit{m/s}",
        r"-R_{1}\,\omega_{O_{1}O_{2}} = -0.4\,\unit{m} \cdot 1\,\unit{rad/s} = -0.4\,\unit{m/s}",
    )


def test_gears_that_a_planet_joins_are_checked_as_their_carrier_sees_them() -> None:
    values = {"z_S": "24", "z_R": "64", "l": "80", "n_S": "-300", "n_A": "30", "phi": "15"}
    (check,) = find_checks(stated("differential-epicyclic-train", **values))
    assert check == Check(
        "the rim speeds of gear $S$ and of gear $R$, equal by way of the planet gear, "
        "seen from the arm $OP$",
        r"r_{S}(\omega_{S} - \omega_{OP}) = 0.043636\,\unit{m} \cdot (-31.416\,\unit{rad/s} - 3.1416\,\unit{rad/s})"
        r" \approx -1.5080\,\unit{m/s}",
        r"-r_{R}(\omega_{R} - \omega_{OP}) = -0.11636\,\unit{m} \cdot (16.101\,\unit{rad/s} - 3.1416\,\unit{rad/s})"
        r" \approx -1.5080\,\unit{m/s}",
    )


def test_a_wheel_between_tracks_is_checked_from_the_other_contact() -> None:
    assert read_checks("pinion-between-two-racks") == [
        Check(
            "the velocity of $C$ from the point of contact with the rack $B$",
            r"v_{C} = 75\,\unit{mm/s}",
            r"v_{B} + r\,\omega = -100\,\unit{mm/s} + 70\,\unit{mm} \cdot 2.5\,\unit{rad/s} = 75\,\unit{mm/s}",
        ),
        Check(
            "the acceleration of $C$ along its path from the point of contact with the rack $B$",
            r"a_{C} = 200\,\unit{mm/s^2}",
            r"a_{B} + r\,\alpha = 400\,\unit{mm/s^2} + 70\,\unit{mm} \cdot (-2.857\,\unit{rad/s^2})"
            r" = 200\,\unit{mm/s^2}",
        ),
    ]


def test_a_train_that_is_driven_at_a_rotational_speed_is_checked_by_counting_turns() -> None:
    """Not by the product of both ratios, which are the equations of the two steps."""
    values = {"r1": "26", "r2": "20", "r3": "30", "r4": "10", "n": "-60"}
    (check,) = find_checks(stated("two-stage-belt-drive", **values))
    assert check == Check(
        "counting turns: those of the shaft are to those of the engine pulley as the radii say,"
        " and each moves the rim of radius $r_{3}$ by its circumference",
        r"v_{B} = 2.4504\,\unit{m/s}",
        r"2\pi\,n\,\frac{r_{1}}{r_{2}}\,r_{3} = \frac{2\pi \cdot 60}{60\,\unit{s}} \cdot"
        r" \frac{0.26\,\unit{m}}{0.2\,\unit{m}} \cdot 0.3\,\unit{m} \approx 2.4504\,\unit{m/s}",
    )


def test_a_slot_that_turns_is_checked_by_a_coordinate_of_the_point_in_it() -> None:
    """Not by Pythagoras, which any angle of the triangle of velocities obeys."""
    template = load_template("slotted-link-on-cylinder")
    solution = solve_template(template, {"d": "0.6", "l": "2", "theta": "45", "v": "0.5"})
    check, _ = find_checks(write_worked_solution(solution, template.asked(), ENGLISH).blocks)
    assert check == Check(
        "the time derivative of $y_{B}$, once directly and once by the motion relative to $AC$",
        r"v_{B} = 0.5\,\unit{m/s}",
        r"\omega_{AC}\,x_{B} + \frac{v_{\mathrm{r}}}{AB}\,y_{B} = 0.41667\,\unit{rad/s}"
        r" \cdot 0.6\,\unit{m} + \frac{0.35355\,\unit{m/s}}{0.84853\,\unit{m}}"
        r" \cdot 0.6\,\unit{m} = 0.5\,\unit{m/s}",
    )


def test_a_pose_is_checked_by_a_distance_that_is_given() -> None:
    values = {"b": "0.8", "l_BC": "1.3", "l_CD": "2.1", "d": "1.9", "theta": "90"}
    assert find_checks(stated("pose-four-bar-coupler", **values))[0] == Check(
        "the distance $DC$ from the coordinates, and as it is given",
        r"\sqrt{(x_{C} - x_{D})^{2} + y_{C}^{2}} = \sqrt{(0.82549\,\unit{m} - 1.9\,\unit{m})^{2} + (1.8043\,\unit{m})^{2}}"
        r" = 2.1\,\unit{m}",
        r"l_{CD} = 2.1\,\unit{m}",
    )


def test_a_direction_cosine_is_checked_by_its_angle() -> None:
    assert read_checks("pose-sleeve-slider-rod") == [
        Check(
            r"$A_{11}$ from the angle $\varphi_{2}$",
            r"A_{11} = -0.9363",
            r"\cos\varphi_{2} = \cos 159.44^\circ \approx -0.9363",
        )
    ]


TERM = re.compile(r"(?:^| )([+-]) ?")


def list_signed(side: str, sign: int) -> list[tuple[str, int]]:
    """The terms of a side, each with its sign."""
    first = side if side.startswith("-") else f"+{side}"
    _, *parts = TERM.split(f" {first}")
    return [
        (term.strip(), sign if mark == "+" else -sign)
        for mark, term in zip(parts[::2], parts[1::2], strict=True)
    ]


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_no_check_cancels_out_what_it_checks(name: str) -> None:
    for check in read_checks(name):
        left = Counter[str]()
        for side, sign in ((check.left, 1), (check.right, -1)):
            for term, counts in list_signed(RELATION.split(side)[0].strip(), sign):
                left[term] += counts
        assert any(left.values()), check


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_all_that_a_check_says_of_both_sides_agrees(name: str) -> None:
    for place in range(len(drawn(name))):
        for check in read_checks(name, place):
            said = [amount for side in check.sides for amount in side]
            for one in said[1:]:
                assert one.value == pytest.approx(said[0].value, abs=said[0].room + one.room + 1e-9)


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_a_check_ends_with_the_same_value_on_both_sides(name: str) -> None:
    assert [check for check in read_checks(name) if not check.agrees] == []


def slip(solution: Solution, rate: Rate) -> list[Check]:
    """The checks of what an exam asks, as if a rate had been found a tenth too large."""
    wrong = {**solution.motion.rates, rate: solution.motion.rates[rate] * 11 / 10}
    slipped = replace(solution, motion=replace(solution.motion, rates=wrong))
    return find_checks(write_worked_solution(slipped, solution.template.asked(), "en").blocks)


@pytest.mark.parametrize(
    ("name", "body"),
    [
        ("slider-crank", "AB"),
        ("pole-four-bar-coupler", "CD"),
        ("crank-slider-in-floating-link", "BC"),
        ("ring-gear-planet-relative-spin", "planet"),
        ("differential-epicyclic-train", "R"),
        ("pinion-between-two-racks", "pinion"),
        ("rolling-wheel-pin-slotted-rocker", "rocker"),
    ],
)
def test_a_wrong_value_shows(name: str, body: str) -> None:
    solution = drawn(name)[0]
    checks = list(slip(solution, make_turning(body)))
    assert [check for check in checks if not check.agrees], checks


def test_a_point_in_a_wrong_place_shows() -> None:
    solution = drawn("pose-four-bar-coupler")[0]
    mechanism = solution.motion.frames.mechanism
    points = {**mechanism.points, "C": mechanism.points["C"] * 11 / 10}
    frames = replace(solution.motion.frames, mechanism=replace(mechanism, points=points))
    slipped = replace(solution, motion=replace(solution.motion, frames=frames))
    (check,) = find_checks(write_worked_solution(slipped, ("phi_2",), "en").blocks)
    assert not check.agrees


RATE = re.compile(r"(\d+(?:\.\d+)?)\\,\\unit\{(?:m|rad)/s(?:\^2)?\}")


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_a_check_goes_by_rates_that_stand_on_the_page(name: str) -> None:
    for place in range(len(drawn(name))):
        page = "\n".join(lines(kept(name, place))).split("Check by")[0::1]
        told = set(RATE.findall(" ".join(part.partition("they agree")[2] or part for part in page)))
        for check in read_checks(name, place):
            sums = (RELATION.split(side)[0] for side in (check.left, check.right))
            used = {one for side in sums for one in RATE.findall(side)}
            assert {one for one in used if not any(rounds(one, other) for other in told)} == set()


def rounds(short: str, long: str) -> bool:
    """Whether a number is another one, or that one with fewer decimals."""
    places = len(short.partition(".")[2])
    room = 0.5000001 * 10.0**-places if len(long) > len(short) else 0.0
    return abs(float(short) - float(long)) <= room
