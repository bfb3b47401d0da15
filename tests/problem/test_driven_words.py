"""Statements say the true sense in words and print positive numbers; what is not needed for what is
asked is not printed.
"""

from __future__ import annotations

from collections.abc import Collection

import pytest

from kinegrade.errors import TemplateError
from kinegrade.language import Language
from kinegrade.problem.solving import solve_template
from kinegrade.problem.statement import write_statement
from kinegrade.problem.statement_faults import find_statement_faults
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.template import Template
from tests.problem.crank import crank
from tests.said import all_said

SAID = (
    ("with {{ omega }};", "{{ OA.turning }};"),
    ("以 {{ omega }} 转动", "{{ OA.turning }}"),
    ("The crank {{ r }} turns", "The crank {{ r }}"),
)
ALPHA = 'alpha = { unit = "rad/s^2", draw = [3, 0, -3], means = { en = "rate", zh = "角加速度" } }'
DRIVEN = 'velocity = "omega"', 'velocity = "omega", acceleration = "-alpha"'
GIVEN = "[points]", f"{ALPHA}\n[points]"
CHANGE = (
    "[[published]]",
    'a = { quantity = "alpha(OA)", unit = "rad/s^2", means = { en = "a", zh = "a" } }\n'
    "[[published]]",
)
TURNING = (*SAID, DRIVEN, GIVEN, CHANGE)


def printed(
    template: Template,
    language: Language = "en",
    asks: Collection[str] | None = None,
    **values: str,
) -> str:
    parameters = solve_template(template, {"h": "0", **values}).parameters
    return write_statement(template, parameters, language, asks)


@pytest.mark.parametrize(
    ("omega", "alpha", "words"),
    [
        ("2", "-3", r"turns counter-clockwise with the angular velocity $\omega = 2\,\unit{rad/s}$, "
         r"speeding up with the angular acceleration $\alpha = 3\,\unit{rad/s^2}$;"),
        ("2", "3", r"turns counter-clockwise with the angular velocity $\omega = 2\,\unit{rad/s}$, "
         r"slowing down with the angular acceleration $\alpha = 3\,\unit{rad/s^2}$;"),
        ("-2", "3", r"turns clockwise with the angular velocity $\omega = 2\,\unit{rad/s}$, "
         r"speeding up with the angular acceleration $\alpha = 3\,\unit{rad/s^2}$;"),
        ("-2", "0", r"turns clockwise at the constant angular velocity $\omega = 2\,\unit{rad/s}$;"),
        ("0", "3", "starts from rest, turning clockwise with the angular acceleration "
         r"$\alpha = 3\,\unit{rad/s^2}$;"),
        ("0", "0", "The crank $r = 1\\,\\unit{m}$ is at rest;"),
    ],
)  # fmt: skip
def test_a_turning_body_has_its_sense_in_words_and_positive_numbers(
    omega: str, alpha: str, words: str
) -> None:
    assert words in printed(crank(*TURNING), omega=omega, alpha=alpha)


def test_a_rate_in_turns_is_a_rotational_speed_in_each_language() -> None:
    template = load_template("differential-epicyclic-train")
    values = {"z_S": "28", "z_R": "92", "l": "120", "phi": "30", "n_S": "-180", "n_A": "105"}
    parameters = solve_template(template, values).parameters
    english, chinese = (
        write_statement(template, parameters, language) for language in ("en", "zh")
    )
    assert r"turns clockwise with the rotational speed $n_{S} = 180\,\unit{r/min}$" in english
    assert r"以转速 $n_{S} = 180\,\unit{r/min}$ 顺时针转动" in chinese
    assert "angular velocity" not in english
    assert "角速度" not in chinese


def test_each_language_says_it_in_its_own_words() -> None:
    chinese = printed(crank(*TURNING), "zh", omega="2", alpha="3")
    assert chinese.startswith(
        r"曲柄 $r = 1\,\unit{m}$ 以角速度 $\omega = 2\,\unit{rad/s}$ 逆时针转动，"
        r"角加速度为 $\alpha = 3\,\unit{rad/s^2}$（转向与角速度相反）"
    )


def test_nothing_is_said_of_an_acceleration_that_nothing_asked_for_needs() -> None:
    template = crank(*TURNING)
    velocities = printed(template, asks=["v_x"], omega="2", alpha="-3")
    assert r"with the angular velocity $\omega = 2\,\unit{rad/s}$; $A$" in velocities
    assert "speeding up" in printed(template, asks=["v_x", "a"], omega="2", alpha="-3")
    still = printed(template, asks=["v_x"], omega="2", alpha="0")
    assert "constant" not in still


def test_an_input_without_an_acceleration_is_constant_where_one_is_asked_for() -> None:
    assert "at the constant angular velocity" in printed(crank(*SAID, CHANGE), omega="2")
    assert "with the angular velocity" in printed(crank(*SAID), omega="2")


@pytest.mark.parametrize(
    ("direction", "v", "words"),
    [
        ("+x", "2", r"moves to the right at the speed $v = 2\,\unit{m/s}$;"),
        ("-x", "2", r"moves to the left at the speed $v = 2\,\unit{m/s}$;"),
        ("+y", "-2", r"moves downwards at the speed $v = 2\,\unit{m/s}$;"),
        ("-pi/2", "-2", r"moves upwards at the speed $v = 2\,\unit{m/s}$;"),
    ],
)
def test_a_point_moves_in_the_sense_that_a_reader_sees(direction: str, v: str, words: str) -> None:
    assert words in printed(moving_crank(direction), v=v, h="1/2")


def moving_crank(direction: str, slot: str = "{{ A.moving }};") -> Template:
    """The crank, driven by the velocity of its end."""
    return crank(
        ('"OA turns", velocity = "omega"', f'"A of OA moves along {direction}", velocity = "v"'),
        ("omega = { unit", "v = { unit"),
        ("rad/s", "m/s"),
        ("omega < 10000000", "v < 10000000"),
        ("turns with {{ omega }};", slot),
        ("以 {{ omega }} 转动", "的 $A$ 端 {{ A.moving }}"),
        ('gives = { v_x = "-omega*h" }', 'gives = { v_x = "-v" }'),
    )


def test_a_point_on_a_circle_has_a_sense_of_rotation_and_a_tangential_acceleration() -> None:
    template = crank(
        *SAID,
        ("OA.turning", "A.moving"),
        (
            'OA turns", velocity = "omega"',
            'A of OA circles O", velocity = "-omega", acceleration = "alpha"',
        ),
        ('"rad/s"', '"m/s"'),
        ("-omega*h", "-omega*h/r"),
        ("[points]", f"{ALPHA.replace('rad', 'm')}\n[points]"),
        CHANGE,
    )
    assert (
        r"moves clockwise at the speed $\omega = 2\,\unit{m/s}$, "
        r"slowing down with the tangential acceleration $\alpha = 3\,\unit{m/s^2}$;"
    ) in printed(template, omega="2", alpha="3")


def test_the_size_of_a_given_is_its_value_without_the_sign() -> None:
    template = crank(("turns with {{ omega }};", "goes at {{ omega.size }};"))
    assert r"goes at $\omega = 2\,\unit{rad/s}$;" in printed(template, omega="-2")
    assert find_statement_faults(template) == []


SIGNED = "draw = [2, 1000000, 20000000]", "draw = [-2, 0, 2]"
BY_SIGN = (
    "[points]",
    """[[text.sense]]
if = "omega > 0"
en = "counter-clockwise"
zh = "逆时针"
[[text.sense]]
en = "clockwise"
zh = "顺时针"
[points]""",
)


def lost(*statement: str) -> list[str]:
    """The faults of a crank whose English statement says this of its rotation of both senses."""
    zh = "以 {{ omega }} 转动{{ sense }}，" if "sense" in statement[0] else "以 {{ omega }} 转动，"
    changes = ("turns with {{ omega }};", statement[0]), ("以 {{ omega }} 转动，", zh)
    by_sign = (BY_SIGN,) if "sense" in statement[0] else ()
    return all_said(find_statement_faults(crank(SIGNED, *by_sign, *changes)))


def test_a_sense_that_no_word_says_by_value_is_refused() -> None:
    assert lost("turns counter-clockwise with {{ omega.size }};") == [
        "crank.toml: statement.en: {{ omega.size }} is printed without its sign, and the words are "
        "the same for omega = -2 and omega = 2: say the sense by value, with {{ omega }}, the "
        ".turning or .moving of what it drives, or a [text] whose wordings are chosen by the sign"
    ]


@pytest.mark.parametrize(
    "said",
    [
        "turns with {{ omega }};",
        "{{ OA.turning }}, at {{ omega.size }};",
        "turns {{ sense }} with {{ omega.size }};",
        "turns with {{ omega.size }}. Its sense is {{ sense }};",
    ],
)
def test_a_sense_that_is_said_by_value_is_told(said: str) -> None:
    assert lost(said) == []


def test_two_senses_that_are_said_only_of_each_other_are_refused() -> None:
    faults = all_said(
        find_statement_faults(
            crank(
                SIGNED,
                DRIVEN,
                GIVEN,
                CHANGE,
                (
                    "[points]",
                    '[[text.change]]\nif = "omega*alpha > 0"\nen = "faster"\nzh = "快"\n'
                    '[[text.change]]\nen = "slower"\nzh = "慢"\n[points]',
                ),
                ("with {{ omega }};", "with {{ omega.size }}, {{ alpha.size }} {{ change }};"),
                ("以 {{ omega }} 转动，", "以 {{ omega }} 转动{{ change }}{{ alpha }}，"),
            )
        )
    )
    assert [fault[:42] for fault in faults] == [
        "crank.toml: statement.en: {{ alpha.size }}",
        "crank.toml: statement.en: {{ omega.size }}",
    ]


def test_the_size_of_an_angle_beyond_half_a_turn_is_what_is_left_of_a_turn() -> None:
    template = load_template("crossed-belt-drive")
    for phi, size, sense in (
        ("165", "165", "counter-clockwise"),
        ("180", "180", "counter-clockwise"),
        ("345", "15", "clockwise"),
    ):
        parameters = solve_template(template, {"phi": phi}).parameters
        assert (
            rf"$\varphi = {size}^\circ$ with the $x$ axis (to the right), measured {sense}"
        ) in write_statement(template, parameters, "en")


def test_what_is_said_of_a_driven_body_gives_its_rates_to_the_student() -> None:
    assert find_statement_faults(crank(*TURNING)) == []


def test_a_text_whose_givens_nothing_asked_for_needs_is_left_out() -> None:
    text = "[[text.change]]\nen = ', {{ alpha.size }}'\nzh = '，{{ alpha.size }}'\n[parameters]"
    template = crank(
        DRIVEN,
        GIVEN,
        CHANGE,
        ("[parameters]", text),
        ("{{ omega }};", "{{ omega }}{{ change }};"),
        ("转动，", "转动{{ change }}，"),
    )
    assert r"\alpha = 3" in printed(template, asks=["a"], omega="2", alpha="-3")
    assert r"\unit{rad/s}$; $A$" in printed(template, asks=["v_x"], omega="2", alpha="-3")


@pytest.mark.parametrize(
    ("slot", "fault"),
    [
        (
            "{{ O.turning }}",
            "{{ O.turning }}: no input turns that body by a given - "
            'did you mean "OA"? (known here: OA)',
        ),
        (
            "{{ A.moving }}",
            "{{ A.moving }}: no input moves that point by a given, in a circle or along an axis - "
            "known here: none",
        ),
    ],
)
def test_what_no_input_drives_has_no_motion_to_print(slot: str, fault: str) -> None:
    with pytest.raises(TemplateError) as caught:
        crank(("with {{ omega }};", f"{slot} {{{{ omega }}}};"))
    assert caught.value.problems == (f"crank.toml:10: statement.en: {fault}",)


def test_a_motion_that_words_do_not_fit_is_left_to_the_author() -> None:
    for changed in (
        (('velocity = "omega"', 'velocity = "2*omega"'),),
        (('velocity = "omega"', 'velocity = "omega", acceleration = "omega**2"'),),
    ):
        with pytest.raises(TemplateError, match="no input turns that body by a given"):
            crank(*SAID, *changed)
    with pytest.raises(TemplateError, match="in a circle or along an axis"):
        moving_crank("pi/3")
