"""A template's text read: every fault is reported with its place, all at once, in one line each."""

from __future__ import annotations

import pytest

from kinegrade.problem.reading import read_template
from kinegrade.problem.solving import solve_template
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


def test_a_template_with_many_faults_reports_all_of_them_each_with_its_place() -> None:
    found = faults(
        ('family = "crank"', 'familie = "crank"'),
        ("pin O: ground OA", "pin O ground OA"),
        ("OA turns", "OA spins"),
        ("r < 2", "r = 2"),
        (', zh = "曲柄" }', " }"),
        ('unit = "m",', 'unit = "ft",'),
        ("0 .. 90 step 30", "0 .. 90 step 0"),
        ("draw = [2], means", "means"),
        ('half = "r/2"', 'half = "r/"'),
        ('A = "polar(O, r, phi)"', 'A = "polar(O, r phi)"'),
        ('OA = "O A M"', 'OA = "O B"'),
        ("magnitude(velocity(A))", "magnitude(velocity(A)"),
        ('"v = omega r"', '"v"\nyear = 1'),
    )
    places = [
        "crank.toml: unknown table or key 'familie': did you mean \"family\"?",
        'crank.toml: parameters.r: unit "ft"',
        'crank.toml: parameters.phi: draw: "0 .. 90 step 0": the step',
        "crank.toml: parameters.omega: draw is missing",
        'crank.toml: lengths.half: "r/", character 3',
        'crank.toml: points.A: "polar(O, r phi)", character 12',
        'crank.toml: bodies.OA: no point "B"',
        'crank.toml: joints[0]: "pin O ground OA": no such joint',
        'crank.toml: inputs[0]: "OA spins": no such input',
        'crank.toml: conditions[0]: "r = 2": expected "left < right"',
        'crank.toml: asks.v_A: "magnitude(velocity(A)"',
        'crank.toml: published[0]: unknown key "year"',
        "crank.toml: title: title: expected texts in both languages",
    ]
    for place in places:
        assert any(problem.startswith(place) for problem in found), (place, found)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("[lengths]", "[length]", "unknown table or key 'length': did you mean \"lengths\"?"),
        (
            'joints = ["pin O: ground OA"]',
            "",
            "crank.toml: joints is missing: every template needs it",
        ),
        (
            'joints = ["pin O: ground OA"]',
            'joints = "pin O: ground OA"',
            "crank.toml: joints: expected a list",
        ),
        ('family = "crank"', "family = 3", "crank.toml: family: expected a text"),
        ('[lengths]\nhalf = "r/2"', "", 'unknown name "half"'),
        (
            "[parameters]",
            "[parameters]\nq = 3",
            "crank.toml: parameters.q: expected a table with draw, unit",
        ),
        (
            'published = "60"',
            'publish = "60"',
            'parameters.phi: unknown key "publish": did you mean "published"?',
        ),
        ('published = "60"', 'published = "60,"', 'parameters.phi: "60,", character 3'),
        (
            'means = { en = "length", zh = "长" }',
            'means = "length"',
            "parameters.r: means: expected texts in both languages",
        ),
        (
            'means = { en = "length", zh = "长" }',
            'means = { en = "length", zh = " " }',
            "parameters.r: means: expected texts",
        ),
        (
            'draw = [1, "3/2"]',
            "draw = [1, 1]",
            "parameters.r: draw: expected 1 to 2000 values, each once",
        ),
        (
            'draw = [1, "3/2"]',
            "draw = []",
            "parameters.r: draw: expected 1 to 2000 values, each once",
        ),
        (
            'draw = [1, "3/2"]',
            'draw = "1 to 2"',
            'parameters.r: draw: "1 to 2": expected a list, or a range like',
        ),
        (
            "r = { unit",
            "left = { unit",
            "left: not usable as a name: a letter, then letters, digits and _ ; not",
        ),
        ("half = ", "pi = ", "pi: not usable as a name"),
        ('M = "polar', '"M M" = "polar', "M M: not usable as a name"),
        ('OA = "O A M"', 'OA = "O A M"\nground = "O"', "ground: not usable as a name"),
        (
            'half = "r/2"',
            'half = "r/2"\nphi = "1"',
            "phi: one name for two things: rename one of them",
        ),
        ('OA = "O A M"', 'OA = "O A M"\nr = "O"', "r: one name for two things: rename one of them"),
        ('OA = "O A M"', 'OA = ""', 'bodies.OA: expected its points, like "O A", or "particle M"'),
        (
            'OA = "O A M"',
            'OA = "particle O A"',
            'bodies.OA: expected its points, like "O A", or "particle M"',
        ),
        ("v_A = { quantity", '"v A" = { quantity', "asks.v A: not usable as a name"),
        (
            'unit = "m/s", means',
            'unit = "m/s", points = 2.5, means',
            "asks.v_A: points: expected a whole number from 0 to 100",
        ),
        (
            'unit = "m/s", means',
            'unit = "m/s", points = true, means',
            "asks.v_A: points: expected a whole number",
        ),
        (
            'unit = "m/s", means',
            'unit = "m/s", vanishes = "yes", means',
            "asks.v_A: vanishes: expected true or false",
        ),
        (
            'unit = "m/s", means',
            'unit = "m/s", sign = "up", means',
            'asks.v_A: sign "up": known here: +x, +y, ccw, magnitude',
        ),
        (
            'unit = "m/s", means',
            'unit = "m/s", sign = 1, means',
            "asks.v_A: sign: expected a keyword, or texts",
        ),
        (
            'velocity = "omega"',
            'velocity = "omeg"',
            'OA turns: unknown name "omeg": did you mean "omega"?',
        ),
        ('velocity = "omega"', 'velocity = "omega", speed = 1', 'inputs[0]: unknown key "speed"'),
        (
            "inputs = [{",
            'inputs = ["OA turns", {',
            "inputs[0]: expected a table with motion, velocity",
        ),
        ('"r < 2"', '"R < 2"', 'conditions[0]: unknown name "R": did you mean "r"?'),
        ('"r < 2"', '"phi < 90"', 'conditions[0]: "phi < 90": an angle against a number'),
        (
            '"r < 2"',
            '"r = 2"',
            'conditions[0]: "r = 2": expected "left < right", with one of <, <=, >, >=, ==',
        ),
        ('half = "r/2"', 'half = "R/2"', 'lengths.half: unknown name "R": did you mean "r"?'),
        (
            "gives = { v_A",
            "gives = { v_B",
            'published[0]: no ask "v_B": did you mean "v_A"? (known here: v_A)',
        ),
        ('"omega*r"', '"omega*R"', 'published[0].gives.v_A: unknown name "R": did you mean "r"?'),
        ('"omega*r"', '"omega*"', 'published[0].gives.v_A: "omega*", character 7'),
        (
            "gives = {",
            "given = { R = 2 }\ngives = {",
            'published[0]: given: no parameter "R": did you mean "r"?',
        ),
        (
            "gives = {",
            'given = "r = 2"\ngives = {',
            "published[0]: given and gives: expected tables",
        ),
        (
            'gives = { v_A = "omega*r" }',
            "gives = [1]",
            "published[0]: given and gives: expected tables",
        ),
        ('gives = { v_A = "omega*r" }', "", "published[0]: gives is missing"),
        (
            'A = "polar(O, r, phi)"',
            'A = "polar(O, r, psi)"',
            'points.A: unknown name "psi": did you mean',
        ),
        (
            'A = "polar(O, r, phi)"',
            'A = "polar(M, r, phi)"',
            'points.A: unknown name "M": known here: O, clockwise, counterclockwise and 9 more',
        ),
        ('half = "r/2"', 'half = "whole/2"\nwhole = "r"', 'lengths.half: unknown name "whole"'),
        (
            "pin O: ground OA",
            "pin O: ground OAB",
            'pin O: ground OAB: no body "OAB": did you mean "OA"? (known here: OA, ground)',
        ),
        (
            "pin O: ground OA",
            "pin Q: ground OA",
            'pin Q: ground OA: no point "Q": known here: A, M, O',
        ),
        (
            "pin O: ground OA",
            "A of OA slides on line(Q, psi)",
            'A of OA slides on line(Q, psi): unknown name "psi"',
        ),
        ('"OA turns"', '"OB turns relative to OC"', 'OB turns relative to OC: no body "OC"'),
        ('"OA turns"', '"B of OA circles C"', 'B of OA circles C: no point "C"'),
        ('"OA turns"', '"A of OA moves along direction(O, B)"', 'unknown name "B"'),
        ("magnitude(velocity(A))", "omega(AB)", 'asks.v_A: unknown name "AB"'),
        ('"omega*r"', '"omega*half"', 'published[0].gives.v_A: unknown name "half"'),
        ("[bodies]", "[figure]\nlength = 1\n[bodies]", "crank.toml: figure: "),
        (
            '"pin O: ground OA"',
            '"OA slides on O"',
            'joints[0]: "OA slides on O": no such joint: write one of',
        ),
        (
            '"pin O: ground OA"',
            '"A of OA slides on line(2, 0)"',
            '"line(2, 0)": expected line(POINT, angle or point)',
        ),
        (
            '"pin O: ground OA"',
            '"A of OA slides on line(O)"',
            '"line(O)": expected line(POINT, angle or point)',
        ),
        (
            '"pin O: ground OA"',
            '"' + "pin O: ground OA " * 30 + '"',
            "joints[0]: a sentence of 510 characters: at most 400 are read",
        ),
    ],
)
def test_each_fault_is_told_with_its_place_and_what_was_expected(
    old: str, new: str, message: str
) -> None:
    found = faults((old, new))
    assert any(message in problem for problem in found), found
