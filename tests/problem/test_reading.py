"""A template's text read: every fault is reported with its place, all at once, in one line each."""

from __future__ import annotations

import pytest

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.reading import read_template
from tests.problem.turning_crank import CRANK, faults


def test_the_small_template_is_sound() -> None:
    template = read_template("crank", CRANK)
    assert template.combinations == 8
    assert template.asked() == ()
    assert template.angles == {"phi"}
    assert template.parameters["r"].default == "1"
    assert template.parameters["phi"].default == "60"
    assert template.about.title.in_language("zh") == "曲柄"
    assert template.file.text == CRANK
    assert solve_template(template, {"r": "3/2"})["v_A"].exact == "3"


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        (
            "[lengths]",
            "[length]",
            ['crank.toml:15: length: unknown table or key - did you mean "lengths"?'],
        ),
        (
            'joints = ["pin O: ground OA"]',
            "",
            ["crank.toml: joints: missing - expected in every template"],
        ),
        (
            'family = "crank"\nsource = "by hand"',
            "",
            [
                "crank.toml: family: missing - expected in every template",
                "crank.toml: source: missing - expected in every template",
            ],
        ),
        (
            'gives = { v_A = "omega*r" }',
            'gives = { v_A = "5,335" }',
            ['crank.toml:31: published[1].gives.v_A: "5,335" - write a decimal point: 5.335'],
        ),
        (
            'gives = { v_A = "omega*r" }',
            'gives = { v_A = "5.335 m/s" }',
            [
                'crank.toml:31: published[1].gives.v_A: "5.335 m/s" - write the number alone, 5.335: '
                "it counts in the unit of the ask"
            ],
        ),
        (
            'family = "crank"',
            "",
            ["crank.toml: family: missing - expected in every template"],
        ),
        (
            'statement = { en = "{{ r }} {{ phi }} {{ omega }}", zh = "{{ r }} {{ phi }} {{ omega }}" }',
            "",
            ["crank.toml: statement: missing - expected in every template"],
        ),
        (
            'unit = "m/s"',
            'unit = "m/s²"',
            [
                'crank.toml:27: asks.v_A.unit: unit "m/s²" - expected a product or quotient like '
                "m/s^2 of 1, cm, deg, ft, h, in, km, m, min, mm, r, rad, rpm, s - did you mean "
                '"m/s^2"?'
            ],
        ),
        (
            "magnitude(velocity(A))",
            "speed(A)",
            [
                'crank.toml:27: asks.v_A.quantity: unknown function "speed" - did you mean '
                '"magnitude(velocity(B))"? (all of them: kinegrade words quantities)'
            ],
        ),
        (
            'unit = "m/s", means',
            'unit = "m/s", sign = "right", means',
            [
                'crank.toml:27: asks.v_A.sign: "right" - expected a keyword, or texts by language '
                'like { en = "..." } - did you mean "+x"?'
            ],
        ),
        (
            'A = "polar(O, r, phi)"',
            'A = "meet(circle(O, r), circle(O, r), above)"',
            ['crank.toml:20: points.A: unknown name "above" - did you mean "upper"?'],
        ),
        (
            'joints = ["pin O: ground OA"]',
            'joints = "pin O: ground OA"',
            ['crank.toml:4: joints: "pin O: ground OA" - expected a list'],
        ),
        (
            'family = "crank"',
            "family = 3",
            ['crank.toml:2: family: 3 - expected a text in quotation marks, "..."'],
        ),
        (
            "[parameters]",
            "[parameters]\nq = 3",
            [
                'crank.toml:11: parameters.q: 3 - expected a table like { unit = "m", draw = [1, 2] }'
            ],
        ),
        (
            'published = "60"',
            'publish = "60"',
            [
                'crank.toml:12: parameters.phi.publish: unknown key - did you mean "published"? (known here: draw, means, published, symbol, unit)'
            ],
        ),
        (
            'published = "60"',
            'published = "60,"',
            [
                'crank.toml:12: parameters.phi.published: "60,", character 3: found ",", expected an operator or the end'
            ],
        ),
        (
            'means = { en = "length", zh = "长" }',
            "means = 1",
            [
                'crank.toml:11: parameters.r.means: 1 - expected a text, or texts by language like { en = "..." }'
            ],
        ),
        (
            'means = { en = "length", zh = "长" }',
            'means = { en = "length", zh = " " }',
            ['crank.toml:11: parameters.r.means: " " - expected a text in quotation marks, "..."'],
        ),
        (
            'draw = [1, "3/2"]',
            "draw = [1, 1]",
            ["crank.toml:11: parameters.r.draw: 2 values - expected 1 to 2000 of them, each once"],
        ),
        (
            'draw = [1, "3/2"]',
            "draw = []",
            ["crank.toml:11: parameters.r.draw: 0 values - expected 1 to 2000 of them, each once"],
        ),
        (
            'draw = [1, "3/2"]',
            'draw = "1 to 2"',
            [
                'crank.toml:11: parameters.r.draw: "1 to 2" - expected a list, or a range like "0.1 .. 0.5 step 0.05"'
            ],
        ),
        (
            "r = { unit",
            "left = { unit",
            [
                "crank.toml:11: parameters.left: not usable as a name - expected a name other than clockwise, counterclockwise, ground, left, lower, pi, right, upper",
                'crank.toml:16: lengths.half: unknown name "r" (and at 5 more places) - known here: left, omega, phi, pi',
            ],
        ),
        (
            "half = ",
            "pi = ",
            [
                "crank.toml:16: lengths.pi: not usable as a name - expected a name other than clockwise, counterclockwise, ground, left, lower, pi, right, upper",
                'crank.toml:21: points.M: unknown name "half" - known here: A, O, clockwise and 9 more',
            ],
        ),
        (
            'M = "polar',
            '"M M" = "polar',
            [
                "crank.toml:21: points.M M: not usable as a name - expected letters of A to Z and a to z, digits and _, a letter first; symbol and labels print others",
                'crank.toml:24: bodies.OA: no point "M" - known here: A, M M, O',
            ],
        ),
        (
            'OA = "O A M"',
            'OA = "O A M"\nground = "O"',
            [
                "crank.toml:25: bodies.ground: not usable as a name - expected a name other than clockwise, counterclockwise, ground, left, lower, pi, right, upper"
            ],
        ),
        (
            'half = "r/2"',
            'half = "r/2"\nphi = "1"',
            [
                "crank.toml:17: lengths.phi: one name for two things: parameters.phi is there too - rename one of them"
            ],
        ),
        (
            'OA = "O A M"',
            'OA = "O A M"\nr = "O"',
            [
                "crank.toml:25: bodies.r: one name for two things: parameters.r is there too - rename one of them"
            ],
        ),
        (
            'OA = "O A M"',
            'OA = ""',
            ['crank.toml:24: bodies.OA: "" - expected its points, like "O A", or "particle M"'],
        ),
        (
            'OA = "O A M"',
            'OA = "particle O A"',
            [
                'crank.toml:24: bodies.OA: "particle O A" - expected its points, like "O A", or "particle M"'
            ],
        ),
        (
            "v_A = { quantity",
            '"v A" = { quantity',
            [
                "crank.toml:27: asks.v A: not usable as a name - expected letters of A to Z and a to z, digits and _, a letter first; symbol and labels print others",
                'crank.toml:31: published[1].gives.v_A: no ask "v_A" - did you mean "v A"? (known here: v A)',
            ],
        ),
        (
            'unit = "m/s", means',
            'unit = "m/s", points = 2.5, means',
            ["crank.toml:27: asks.v_A.points: 2.5 - expected a whole number from 0 to 100"],
        ),
        (
            'unit = "m/s", means',
            'unit = "m/s", points = true, means',
            ["crank.toml:27: asks.v_A.points: true - expected a whole number from 0 to 100"],
        ),
        (
            'unit = "m/s", means',
            'unit = "m/s", vanishes = "yes", means',
            ['crank.toml:27: asks.v_A.vanishes: "yes" - expected true or false'],
        ),
        (
            'unit = "m/s", means',
            'unit = "m/s", sign = "up", means',
            [
                'crank.toml:27: asks.v_A.sign: "up" - expected a keyword, or texts by language like { en = "..." } - did you mean "+y"?'
            ],
        ),
        (
            'unit = "m/s", means',
            'unit = "m/s", sign = 1, means',
            [
                'crank.toml:27: asks.v_A.sign: 1 - expected a keyword, or texts by language like { en = "..." }'
            ],
        ),
        (
            'velocity = "omega"',
            'velocity = "omega", speed = 1',
            [
                "crank.toml:5: inputs[1].speed: unknown key - known here: acceleration, motion, velocity"
            ],
        ),
        (
            "inputs = [{",
            'inputs = ["OA turns", {',
            [
                'crank.toml:5: inputs[1]: "OA turns" - expected a table like { motion = "OA turns", velocity = "omega" }'
            ],
        ),
        (
            '"r < 2"',
            '"r = 2"',
            [
                'crank.toml:6: conditions[1]: "r = 2" - expected "left < right", with one of <, <=, >, >=, ==, !='
            ],
        ),
        (
            '"omega*r"',
            '"omega*"',
            [
                'crank.toml:31: published[1].gives.v_A: "omega*", character 7: found the end, expected a number, a name or a bracket'
            ],
        ),
        (
            "gives = {",
            'given = "r = 2"\ngives = {',
            ['crank.toml:31: published[1].given: "r = 2" - expected a table like { r = "1" }'],
        ),
        (
            'gives = { v_A = "omega*r" }',
            "gives = [1]",
            [
                'crank.toml:31: published[1].gives: a list - expected a table like { v_B = "2*omega*r" }'
            ],
        ),
        ('gives = { v_A = "omega*r" }', "", ["crank.toml:29: published[1].gives: missing"]),
        (
            "[bodies]",
            "[figure]\nlength = 1\n[bodies]",
            [
                'crank.toml:24: figure.length: unknown key - did you mean lengths = [{ symbol = "l", from = "A", to = "B" }], lines = [["O", "A"]] or labels = { O1 = "O_1" }? (all of them: kinegrade words figure)'
            ],
        ),
        (
            '"pin O: ground OA"',
            '"OA slides on O"',
            [
                'crank.toml:4: joints[1]: "OA slides on O": no such joint - did you mean "B of AB slides on line(O, 0)", "A of AB slides on line(O, A) of OC" or "AB slides through sleeve along line(O, A)"? (all of them: kinegrade words joints)'
            ],
        ),
        (
            '"pin O: ground OA"',
            '"A of OA slides on line(2, 0)"',
            [
                'crank.toml:4: joints[1]: "line(2, 0)" - expected line(POINT, angle or point) or circle(POINT, radius)'
            ],
        ),
        (
            '"pin O: ground OA"',
            '"A of OA slides on line(O)"',
            [
                'crank.toml:4: joints[1]: "line(O)" - expected line(POINT, angle or point) or circle(POINT, radius)'
            ],
        ),
        (
            '"pin O: ground OA"',
            '"pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA pin O: ground OA "',
            ["crank.toml:4: joints[1]: a sentence of 510 characters - expected at most 400"],
        ),
    ],
)
def test_each_fault_is_reported_with_its_place_and_what_was_expected(
    old: str, new: str, expected: list[str]
) -> None:
    assert faults((old, new)) == expected


@pytest.mark.parametrize(
    ("quantity", "more", "cyclic"),
    [
        ("direction(O, A)", "", True),
        ("pi/2 - direction(O, A)", "", True),
        ("angle((1, 0), velocity(A))", "", True),
        ("atan2(1, 2) + phi", "", True),
        ("direction(O, A)", ", cyclic = false", False),
        ("between(A - O, velocity(A))", "", False),
        ("2*direction(O, A)", "", False),
        ("phi", "", False),
        ("phi", ", cyclic = true", True),
    ],
)
def test_the_angle_of_a_position_is_right_up_to_full_turns(
    quantity: str, more: str, cyclic: bool
) -> None:
    ask = (
        f'psi = {{ quantity = "{quantity}", unit = "deg", means = {{ en = "a", zh = "a" }}{more} }}'
    )
    template = read_template("crank", CRANK.replace("[asks]", f"[asks]\n{ask}"))
    assert template.asks["psi"].cyclic == cyclic


def test_a_key_that_stands_below_a_table_is_told_to_stand_above() -> None:
    said = faults(('source = "by hand"\n', ""), ("[lengths]\n", '[lengths]\nsource = "by hand"\n'))
    assert (
        "crank.toml: source: missing - expected it above the first [table]: what stands below "
        "[lengths] belongs to that"
    ) in said
