"""What known mistakes lead to is known, told apart from the truth in every draw, and told in both
languages.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction
from math import cos, isfinite, nan, pi, radians, sin
from typing import Any

import numpy as np
import pytest

import kinegrade
from kinegrade.draws.draw_filter import DrawFilter
from kinegrade.draws.examining import Examined, Refused
from kinegrade.errors import MechanismError
from kinegrade.language import Language
from kinegrade.language.known import known_languages
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.doubles import convert_number
from kinegrade.numbers.refusals import Inexact
from kinegrade.numbers.tolerance import ONE_PER_CENT
from kinegrade.problem.given_values import find_parameter_values, read_values
from kinegrade.problem.solving import solve_certified, solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.template import Template
from kinegrade.problem.tolerance import find_effective_tolerance
from kinegrade.proof.checking import check
from kinegrade.proof.reporting import write_findings
from kinegrade.students.comparison import collect_columns, measure_distance
from kinegrade.students.mistaking.consequences import attach_mistakes
from kinegrade.students.mistaking.mistake_kinds import (
    MISTAKES,
    find_candidates,
    take_degrees_as_radians,
)
from kinegrade.students.mistaking.mistake_names import MISTAKE_NAMES, describe_mistakes
from kinegrade.students.mistaking.mistake_outcomes import RIGHT, find_outcomes
from kinegrade.students.mistaking.mistakes import (
    choose_way,
    convert_parameters,
    find_known_mistakes,
    work_out,
)
from tests.problem.crank import crank, crank_text
from tests.problem.draws import dealt, draw_filter, drawn
from tests.said import said

TURNING = crank_text(  # a crank in millimetres that turns at an angle
    (
        'h     = { unit = "m", draw = [0, "1/2", 3], means = { en = "height of A", zh = "A 的高度" } '
        "}",
        'h     = { unit = "deg", draw = [30, 45, 60], means = { en = "angle", zh = "角" } }',
    ),
    ('r     = { unit = "m", draw = [1, 2]', 'r     = { unit = "mm", draw = [100, 200]'),
    (
        'omega = { unit = "rad/s", draw = [2, 1000000, 20000000]',
        'omega = { unit = "rad/min", draw = [60, 120]',
    ),
    ('P = "(0, h)"\n', ""),
    ('A = "meet(circle(O, r), line(P, 0), right)"', 'A = "polar(O, r, h)"'),
    ("-omega*h", "-omega/60*r/1000*sin(h)"),
)


def turning(**values: str) -> Mapping[str, float]:
    given = {"r": "200", "h": "30", "omega": "120", **values}
    return attach_mistakes(solve_template(read_template("crank", TURNING), given))["v_x"].mistakes


def test_every_mistake_has_a_plain_name_and_a_sentence() -> None:
    assert [mistake.identifier for mistake in MISTAKES] == [*MISTAKE_NAMES[: len(MISTAKES)]]
    english, chinese = describe_mistakes(Language("en")), describe_mistakes(Language("zh"))
    for name in MISTAKE_NAMES:
        assert re.fullmatch("[a-z]+(-[a-z]+)*", name)
        assert english[name].endswith(".")
        assert re.search(r"[\u4e00-\u9fff].*。$", chinese[name])
    sentences = {language: describe_mistakes(language) for language in known_languages()}
    assert [
        (language, name)
        for language, told in sentences.items()
        for name in MISTAKE_NAMES
        if not told[name].endswith((".", "。"))
    ] == []


def test_identifiers_are_a_promise_to_banks() -> None:
    assert MISTAKE_NAMES == (
        "coriolis-dropped",
        "coriolis-halved",
        "coriolis-reversed",
        "coriolis-wrong-omega",
        "relative-normal-dropped",
        "relative-normal-outwards",
        "path-normal-dropped",
        "path-normal-outwards",
        "omega-not-squared",
        "tangential-dropped",
        "relative-for-absolute",
        "absolute-for-relative",
        "meshing-reversed",
        "belt-reversed",
        "arm-for-sum",
        "inverse-ratio",
        "wrong-pole",
        "far-pivot-for-pole",
        "far-end-for-pole",
        "pole-on-velocities",
        "neighbours-omega",
        "translation-assumed",
        "centre-for-pole",
        "transport-for-absolute",
        "transport-of-other-frame",
        "added-as-scalars",
        "other-branch",
        "sine-for-cosine",
        "degrees-for-radians",
        "diameter-for-radius",
        "rpm-not-converted",
        "millimetres-for-metres",
        "supplementary-angle",
        "one-length-for-another",
        "sense-reversed",
        "minus-in-magnitude",
        "power-of-ten-up",
        "power-of-ten-down",
        "two-powers-of-ten-up",
        "two-powers-of-ten-down",
        "three-powers-of-ten-up",
        "three-powers-of-ten-down",
        "degrees-per-second",
        "rpm-typed",
    )


def test_mistakes_with_units_angles_and_writing() -> None:
    # r = 0.2 m, omega = 2 rad/s, h = 30 degrees: v_x = -0.4 sin h = -0.2
    assert turning() == pytest.approx(
        {
            "sine-for-cosine": -0.4 * cos(pi / 6),
            "degrees-for-radians": -0.4 * sin(30),
            "rpm-not-converted": -12.0,
            "millimetres-for-metres": -200.0,
            "sense-reversed": 0.2,
            "power-of-ten-up": -2.0,
            "power-of-ten-down": -0.02,
            "two-powers-of-ten-up": -20.0,
            "two-powers-of-ten-down": -0.002,
            "three-powers-of-ten-up": -200.0,
            "three-powers-of-ten-down": -0.0002,
        }
    )


def test_a_mistake_that_changes_nothing_is_not_listed() -> None:
    assert "sine-for-cosine" not in turning(h="45")
    answers = kinegrade.template("slotted-bar-between-two-rods").solve()
    assert "coriolis-dropped" in answers["alpha_AE"].mistakes
    assert not [
        name for name in answers["omega_AE"].mistakes if "coriolis" in name or "normal" in name
    ]
    assert answers["alpha_AE"].mistakes["coriolis-halved"] == pytest.approx(
        answers["alpha_AE"].value / 2
    )


def test_magnitudes_have_no_sense_givens_no_mistakes_and_zero_no_decimal_point() -> None:
    answers = kinegrade.template("slider-crank").solve(phi=90, k="sqrt(3)")
    assert "sense-reversed" not in answers["v_B"].mistakes
    assert "sense-reversed" in answers["a_B"].mistakes
    assert answers.parameters["phi"].mistakes == {}
    assert not {"sense-reversed", "power-of-ten-up", "power-of-ten-down"} & set(
        answers["omega_AB"].mistakes
    )


def test_a_slider_crank_worked_out_by_hand() -> None:
    # r = 1, OA turns clockwise with 1 at 60 degrees, AB at a right angle to it: B at 2 from O
    answers = kinegrade.template("slider-crank").solve()
    v_B, omega_AB = answers["v_B"].mistakes, answers["omega_AB"].mistakes
    assert v_B["wrong-pole"] == pytest.approx(2)
    assert omega_AB["wrong-pole"] == pytest.approx(-1)
    assert omega_AB["other-branch"] == pytest.approx(-1 / 3)
    assert v_B["sine-for-cosine"] == pytest.approx(
        sin(pi / 6) + cos(pi / 6) * sin(pi / 6) / (3 - 0.25) ** 0.5
    )


def test_a_belt_taken_for_the_other_kind_worked_out_by_hand() -> None:
    # relative to the arm I turns with 8 - 2 = 6, II with 6 * 0.2/0.1 = 12: crossed -12, open 12
    answers = kinegrade.template("crossed-belt-drive").solve(
        r1="0.2", r2="0.1", l="0.7", phi=30, omega1=8, omega0=2, alpha0=4
    )
    omega, alpha = answers["omega_II"], answers["alpha_II"]
    assert (omega.value, omega.mistakes["belt-reversed"]) == (-10, pytest.approx(14))
    # the arm's 4 and, relative to it, that of I: -4, doubled
    assert (alpha.value, alpha.mistakes["belt-reversed"]) == (12, pytest.approx(-4))
    # B moves with 0.7 * 2 across the arm and with 0.1 * 14 along it
    assert answers["v_B"].mistakes["belt-reversed"] == pytest.approx(1.4 * 2**0.5)
    assert "meshing-reversed" not in omega.mistakes


def answers_in(
    template: Template, values: Mapping[str, str], kind: Any, plan: Any, arithmetic: Any
) -> dict[str, float]:
    asks = {name: template.asks[name] for name in template.asked()}
    given = find_parameter_values(template, read_values(template, values), arithmetic)
    found = work_out(
        template, asks, choose_way(kind, template, given, arithmetic), plan, arithmetic
    )
    return {
        name: convert_number(value)
        * (180 / pi if isinstance(value, Angle) and asks[name].unit.degrees else 1)
        for name, value in found.items()
    }


@pytest.mark.parametrize(
    "name",
    [
        "slider-crank",
        "rod-sliding-on-driven-wheel",
        "planetary-gear-external-rim-accelerations",
        "two-wheels-on-cylinder",
        "rod-ground-incline-fixed-centrode",
        "extended-rod-driving-rocker",
        "pin-in-disc-slot-and-rod",
        "pole-four-bar-coupler",
        "pose-four-bar-coupler",
    ],
)
def test_doubles_say_what_certified_arithmetic_says(name: str) -> None:
    template = load_template(name)
    (one,) = drawn(draw_filter(template, "mistakes"), 1)
    plan = one.solution.motion.plan
    asks = {ask: template.asks[ask] for ask in template.asked()}
    kinds = (RIGHT, *find_candidates(template, asks))
    numbers = {
        given: convert_number(one.solution.assembly.values[given]) for given in template.parameters
    }
    doubles = find_outcomes(template, asks, kinds[1:], numbers, plan).answers
    for row, kind in enumerate(kinds):
        try:
            exact = solve_certified(
                lambda arithmetic, kind=kind: answers_in(
                    template, one.values, kind, plan, arithmetic
                )
            )
        except MechanismError:
            assert kind.given  # with another length it cannot be assembled
            continue
        assert {ask: float(doubles[ask][row]) for ask in exact} == pytest.approx(
            exact, rel=1e-9, abs=1e-9
        ), kind


def test_a_class_at_once_gives_what_each_instance_gives() -> None:
    template = load_template("bar-through-swivelling-sleeve")
    several = drawn(draw_filter(template, "mistakes"), 5)
    asks = {name: template.asks[name] for name in template.asked()}
    table = find_known_mistakes(
        template,
        asks,
        collect_columns([one.values for one in several]),
        several[0].solution.motion.plan,
    )
    for place, one in enumerate(several):
        solution = attach_mistakes(one.solution)
        for ask in asks:
            listed = solution[ask].mistakes
            assert listed == pytest.approx({name: table[ask][name][place] for name in listed})


def test_an_angle_of_radians_is_no_exact_angle() -> None:
    template = read_template("crank", TURNING)
    with pytest.raises(Inexact):
        take_degrees_as_radians(template, {"h": Angle(1)}, None)


DECKS = [
    "slider-crank",
    "bar-through-swivelling-sleeve",
    "ring-gear-planet-relative-spin",
    "pin-in-two-rings",
    "flat-faced-follower-curvature-radius",
    "rod-ground-incline-fixed-centrode",
    "wheel-on-circular-track",
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", DECKS)
def test_no_student_who_makes_a_known_mistake_gets_full_marks(name: str) -> None:
    template = load_template(name)
    draws = draw_filter(template)
    separation = draws.separation
    assert separation is not None
    inseparable = separation.inseparable(separation.compare(separation.sample))
    for one in drawn(draws, 4):
        solution = attach_mistakes(one.solution)
        found = draws.dealt.find_roundings(one.values)
        for ask in template.asked():
            answer = solution[ask]
            allowed = find_effective_tolerance(ONE_PER_CENT, answer.value, found[ask].largest)
            low, high = allowed.interval(Fraction(answer.value))
            for mistake, value in answer.mistakes.items():
                typed = Fraction(f"{value:.4g}") if isfinite(value) else Fraction(0)
                assert (
                    mistake in inseparable[ask]
                    or not low <= typed <= high
                    or answer.value == value == 0
                )


def slider_crank(**fixed: tuple[str, ...]) -> DrawFilter:
    return draw_filter(load_template("slider-crank"), fixed=fixed, asks=("v_B", "omega_AB"))


def test_a_draw_that_hides_a_mistake_is_refused_for_that() -> None:
    draws = slider_crank(phi=("30", "45", "60"))
    assert {one.values["phi"] for one in drawn(draws, 20)} == {"30", "60"}
    assert dealt(draws, 20).refused["mistake"] > 0
    hidden = {"r": "0.1", "k": "2", "phi": "45", "omega": "2", "alpha": "0"}
    refused, fit = draws.examine([hidden, {**hidden, "phi": "30"}])
    assert isinstance(refused, Refused)
    assert refused.reason == "mistake"
    assert str(refused).endswith("lands within the tolerance")
    assert isinstance(fit, Examined)


def test_what_no_draw_can_tell_apart_is_not_asked_of_any() -> None:
    draws = slider_crank(phi=("45",))
    assert drawn(draws, 1)[0].values["phi"] == "45"
    assert "mistake" not in dealt(draws, 20).refused


def test_a_question_without_any_solvable_draw_is_left_to_other_reasons() -> None:
    draws = draw_filter(crank(), fixed={"h": ("3",)}, asks=("v_x",))
    assert (draws.plan, draws.separation) == (None, None)
    assert draws.verdicts(range(draws.deck.size)).count("mechanism") == 4


def test_where_nothing_is_asked_no_mistake_confuses_anything() -> None:
    draws = DrawFilter(crank(), (), draw_filter(crank()).deck, {})
    assert draws.plan is not None
    assert draws.separation is None


def test_terms_that_vanish_identically_are_told() -> None:
    # Its coupler translates, whatever is drawn
    template = load_template("parallelogram-with-sliding-rod")
    separation = draw_filter(template).separation
    assert separation is not None
    told = separation.inseparable(separation.compare(separation.sample))
    assert "coriolis-dropped" in told["alpha_AB"]
    assert told["omega_AB"] == told["v_rel"] == ()


def test_the_report_of_a_check_tells_them() -> None:
    report = check(load_template("parallelogram-with-sliding-rod"), sample=60)
    lines = list(map(said, write_findings(report)))
    kept = lines.index("draws kept although a mistake leads to a right answer:")
    refused = lines.index("draws refused because a mistake leads to a right answer:")
    told = "coriolis-dropped 100.0%, coriolis-halved 100.0%, coriolis-reversed 100.0%"
    assert f"  a_rel: {told}" in lines[kept:]
    assert not [line for line in lines[kept:] if line.startswith("  omega_AB: ")]
    assert [line for line in lines[refused:kept] if line.startswith("  omega_AB: sine-for-cosine ")]
    assert re.search(r"refused: .*mistake \d+", "".join(lines))


@pytest.mark.parametrize(
    ("text", "value"), [("30", pi / 6), ("atan(3/4)", 0.6435011), ("sqrt(-1)", nan), ("r", nan)]
)
def test_a_text_that_is_no_number_confuses_nothing(text: str, value: float) -> None:
    template = load_template("slider-crank")
    assert convert_parameters(template, {"phi": [text]})["phi"] == pytest.approx(
        [value], nan_ok=True
    )
    separation = slider_crank().separation
    assert separation is not None
    values = {**{name: ["1"] for name in template.parameters}, "k": ["2"], "phi": [text]}
    assert separation.find_confused(separation.compare(values)).tolist() == [False]


def test_angles_that_turn_round_are_compared_without_full_turns() -> None:
    ask = load_template("triangle-pose-three-frames").asks["theta_2"]
    assert ask.cyclic
    assert measure_distance(np.array([radians(359)]), np.array([0.0]), ask) == pytest.approx(
        [radians(1)]
    )
