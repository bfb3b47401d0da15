"""Templates from strangers: every fault is told with its place, all at once, in one line each;
nothing is executed.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import KinegradeError, MechanismError, TemplateError
from kinegrade.problem.library import load_template, shipped, template_names
from kinegrade.problem.reading import read_template
from kinegrade.problem.solving import solve_template
from kinegrade.problem.toml_text import MAX_CHARACTERS

CRANK = """
family = "crank"
source = "by hand"
joints = ["pin O: ground OA"]
inputs = [{ motion = "OA turns", velocity = "omega" }]
conditions = ["r < 2"]
title = { en = "Crank", zh = "曲柄" }
statement = { en = "{{ r }} {{ phi }} {{ omega }}", zh = "{{ r }} {{ phi }} {{ omega }}" }

[parameters]
r = { unit = "m", draw = [1, "3/2"], means = { en = "length", zh = "长" } }
phi = { unit = "deg", draw = "0 .. 90 step 30", published = "60", means = { en = "angle", zh = "角" } }
omega = { unit = "rad/s", draw = [2], means = { en = "rate", zh = "角速度" } }

[lengths]
half = "r/2"

[points]
O = "(0, 0)"
A = "polar(O, r, phi)"
M = "polar(O, half, phi)"

[bodies]
OA = "O A M"

[asks]
v_A = { quantity = "magnitude(velocity(A))", unit = "m/s", means = { en = "speed", zh = "速度" } }

[[published]]
source = "v = omega r"
gives = { v_A = "omega*r" }
"""


def faults(*changes: tuple[str, str], name: str = "crank") -> list[str]:
    """The faults of the crank's template with some texts replaced."""
    text = CRANK
    for old, new in changes:
        assert text.count(old) >= 1, old
        text = text.replace(old, new, 1)
    with pytest.raises(TemplateError) as refusal:
        read_template(name, text)
    assert all("\n" not in problem and len(problem) < 700 for problem in refusal.value.problems)
    return list(refusal.value.problems)


def solving(*changes: tuple[str, str], **values: str) -> str:
    """What solving the changed template refuses, read as an exam keeps it: without a look at
    dimensions.
    """
    text = CRANK
    for old, new in changes:
        assert text.count(old) >= 1, old
        text = text.replace(old, new, 1)
    with pytest.raises(KinegradeError) as refusal:
        solve_template(read_template("crank", text, kept=True), values)
    assert all("\n" not in problem for problem in refusal.value.problems)
    return str(refusal.value)


def refused(text: str, name: str = "crank") -> tuple[str, ...]:
    """The problems of a template at its default values; none when it is solved."""
    try:
        solve_template(read_template(name, text), {})
    except KinegradeError as error:
        return error.problems
    return ()


def one_line_each(problems: tuple[str, ...]) -> bool:
    return all(problem and "\n" not in problem for problem in problems)


def test_the_small_template_is_sound() -> None:
    template = read_template("crank", CRANK)
    assert template.combinations == 8
    assert template.asked() == ()
    assert template.angles == {"phi"}
    assert template.parameters["r"].default == "1"
    assert template.parameters["phi"].default == "60"
    assert template.title.in_language("zh") == "曲柄"
    assert template.text == CRANK
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


@pytest.mark.parametrize(
    "text",
    [
        "a = [" * 5000,
        "a = " + "[" * 3000 + "]" * 3000,
        "a.b" * 20000,
        "= 1",
        "a = 1\na = 2",
        "\x00",
        'a = "\ud800"',
        "[a]\n[a]",
        "a = 9" + "9" * 5000,
        "a = 0x" + "f" * 5000,
        "a = -" + "9" * 70,
        "[[a]]\nb = [{ c = 1" + "0" * 70 + " }]",
        "",
        "\n" * 1000,
        "x" * 99_999,
    ],
)
def test_hostile_toml_is_refused_in_short_lines(text: str) -> None:
    with pytest.raises(TemplateError) as refusal:
        read_template("hostile", text)
    assert all("\n" not in problem and len(problem) < 700 for problem in refusal.value.problems)


def test_large_files_and_strange_names_are_refused_before_reading() -> None:
    with pytest.raises(
        TemplateError, match=r"hostile.toml: 100001 characters: at most 100000 are read"
    ):
        read_template("hostile", "#" * (MAX_CHARACTERS + 1))
    for name in ("../crank", "crank.toml", "Crank", "", "a b", "-a", "con\n"):
        with pytest.raises(
            TemplateError, match="a template's name is made of small letters, digits and hyphens"
        ):
            read_template(name, CRANK)


def test_whole_numbers_of_thousands_of_digits_are_refused() -> None:
    for number in ("9" * 5000, "0x" + "f" * 5000, "9" * 61):
        assert faults(('published = "60"', f"published = {number}")) == [
            "crank.toml: a whole number of more than 60 digits: round it - expected a template in TOML - fix it"
        ]


@pytest.mark.parametrize(
    "code",
    [
        "__import__('os').system('true')",
        "open('/etc/passwd')",
        "().__class__",
        "O.__class__",
        "eval(O)",
        "lambda: 0",
        "[x for x in O]",
        "exec",
        "{{ 7*7 }}",
        "f'{O}'",
    ],
)
def test_code_in_expressions_is_only_a_fault(code: str) -> None:
    quoted = code.replace('"', "'")
    for old in ('"(0, 0)"', '"r/2"', '"omega*r"', '"magnitude(velocity(A))"'):
        problems = refused(CRANK.replace(old, f'"{quoted}"'))
        assert one_line_each(problems)
        assert problems


ODD = (
    "A",
    "r",
    "phi",
    "pi",
    "right",
    "line(O, A)",
    "circle(O, r)",
    "(A, O)",
    "(right, phi)",
    "midpoint(r, 1)",
    "O - O",
    "0",
    "midpoint(right, right)",
    "polar(O, A, phi)",
    "circle(A, O)",
    "line(r, O)",
    "meet(O, A, right)",
    "turned(phi)",
    "1e-300",
    "(r, phi)",
    "distance(O, right)",
    "toward(O, O, r)",
    "foot(O, O)",
    "phi*phi",
    "right + right",
    "-line(O, A)",
    "x(phi)",
    "direction(O, O)",
    "sqrt(A)",
    "abs(A)",
    "atan2(A, O)",
    "meet(line(O, 0), line(O, 0))",
    "velocity(A)",
    "OA",
    "1e99**16",
)
SEATS = (
    'half = "{}"',
    'M = "{}"',
    'M = "({}, 0)"',
    'M = "polar(O, {}, phi)"',
    'M = "polar(O, r, {})"',
    'quantity = "{}"',
    'quantity = "magnitude({})"',
    'quantity = "omega({})"',
    'velocity = "{}"',
    'conditions = ["{} < 1"]',
    'joints = ["pin O: ground OA", "circle(A, {}) of OA touches line(O, 0)"]',
    'gives = {{ v_A = "{}" }}',
    'joints = ["pin O: ground OA", "M of OA slides on line(O, {})"]',
    'half = "r"\nmore = "{}"',
    'inputs = [{{ motion = "A of OA moves along {}", velocity = "1" }}]',
)


@pytest.mark.parametrize("seat", SEATS)
def test_an_odd_expression_in_any_seat_is_refused_or_solved_and_nothing_else(seat: str) -> None:
    key = seat.split("=", maxsplit=1)[0].strip()
    found = re.search(rf'{key} = (\[.*\]|{{.*}}|"[^"]*")', CRANK)
    assert found
    old = found.group(0)
    for odd in ODD:
        assert one_line_each(refused(CRANK.replace(old, seat.format(odd), 1)))


PIECES = st.sampled_from(CRANK.split("\n"))


@given(
    st.lists(
        st.one_of(
            PIECES,
            st.sampled_from(
                ["r = 1", "[points]", "x = {}", "= ", '"', "[[published]]", "gives = 3"]
            ),
        ),
        max_size=30,
    ).map("\n".join)
)
def test_any_mixture_of_lines_is_a_template_or_refused(text: str) -> None:
    assert one_line_each(refused(text))


@given(
    st.text(max_size=40),
    st.sampled_from(
        [
            '"(0, 0)"',
            '"polar(O, r, phi)"',
            '"pin O: ground OA"',
            '"OA turns"',
            '"r/2"',
            '"omega"',
            '"0 .. 90 step 30"',
            '"deg"',
            '"O A M"',
            '"r < 2"',
            '"magnitude(velocity(A))"',
            '"omega*r"',
        ]
    ),
)
def test_any_text_in_any_place_is_refused_in_one_line_or_solved(text: str, place: str) -> None:
    quoted = (
        '"'
        + "".join(f"\\U{ord(letter):08X}" for letter in text if not 0xD800 <= ord(letter) < 0xE000)
        + '"'
    )
    assert one_line_each(refused(CRANK.replace(place, quoted)))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (
            ('A = "polar(O, r, phi)"', 'A = "r"'),
            "crank: points.A: expected a point, like (x, y) or polar(O, r, phi)",
        ),
        (
            ('A = "polar(O, r, phi)"', 'A = "O + r"'),
            'crank: points.A: "+" between things that do not go together',
        ),
        (
            ('A = "polar(O, r, phi)"', 'A = "meet(circle(O, r), line((0, 3), 0), right)"'),
            "crank: points.A: the circle about O of radius 1 does not reach the line y = 3",
        ),
        (
            ('"pin O: ground OA"', '"pin O: ground OA", "A of OA slides on line(O, right)"'),
            "crank: A of OA slides on line(O, right): line cannot be made of what stands in its "
            "brackets",
        ),
        (
            ('"pin O: ground OA"', '"pin O: ground OA", "A of OA slides on line(r, 0)"'),
            "crank: A of OA slides on line(r, 0): line cannot be made of what stands in its "
            "brackets",
        ),
        (
            ('"pin O: ground OA"', '"pin O: ground OA", "circle(O, A) of OA touches line(A, 0)"'),
            "crank: circle(O, A) of OA touches line(A, 0): expected a number",
        ),
        (
            ('"OA turns", velocity = "omega"', '"OA turns", velocity = "A"'),
            "crank: OA turns: expected a number",
        ),
        (
            ('"OA turns"', '"A of OA moves along A - O"'),
            "moves along ...: expected +x, -x, +y, -y or an angle",
        ),
        (('A = "polar(O, r, phi)"', 'A = "(right, 0)"'), "crank: points.A: expected a number"),
        (
            ("magnitude(velocity(A))", "velocity(A)"),
            "crank: v_A: expected a number: take magnitude(...), x(...), y(...)",
        ),
        (("magnitude(velocity(A))", "OA"), "crank: v_A: expected a number"),
        (("magnitude(velocity(A))", "line(O, A)"), "crank: v_A: expected a number"),
        (
            ('omega(OA)", unit = "deg"', 'omega(OA)", unit = "deg"'),
            "crank: turned: expected an angle: degrees count angle(...)",
        ),
        (
            ("magnitude(velocity(A))", "magnitude(velocity(r))"),
            "crank: v_A: expected a point's name here",
        ),
        (
            ("magnitude(velocity(A))", "magnitude(velocity(A + O))"),
            "crank: v_A: expected a point's name here",
        ),
        (
            ("magnitude(velocity(A))", "omega(A)"),
            'crank: v_A: "A" is a point: expected the name of a body here',
        ),
        (
            ("magnitude(velocity(A))", "x(pole(OA)) + speed(A)"),
            'crank: v_A: unknown function "speed"',
        ),
        (
            ("magnitude(velocity(A))", "y(velocity(P))"),
            "crank: v_A: point P belongs to no body: name the body that "
            "carries it, like velocity(P, OA)",
        ),
        (
            ("magnitude(velocity(A))", "y(velocity(A))/(r - 1)"),
            "crank: v_A: division by zero: check the values given",
        ),
        (
            ("magnitude(velocity(A))", "angle(velocity(O), velocity(A))"),
            "crank: v_A: angle(...): the direction of a zero vector",
        ),
    ],
)
def test_what_shows_only_at_an_instance_is_told_with_its_place(
    change: tuple[str, str], message: str
) -> None:
    more = (
        '[asks]\nturned = { quantity = "omega(OA)", unit = "deg", means = { en = "turned", zh = '
        '"转" } }'
    )
    more = more if "deg" in change[0] else "[asks]"
    assert message in solving(
        ('M = "polar(O, half, phi)"', 'M = "polar(O, half, phi)"\nP = "(1, 1)"'),
        ("[asks]", more),
        change,
    )


def test_a_point_of_two_bodies_that_are_not_pinned_needs_its_body() -> None:
    text = solving(
        ('OA = "O A M"', 'OA = "O A M"\nBC = "A"'),
        (
            '"pin O: ground OA"',
            '"pin O: ground OA", "BC turns with OA", '
            '"A of BC slides on line(O, A) of OA", "A of BC slides on line(O, pi/2)"',
        ),
        ('"O A M"', '"O A M"'),
        phi="90",
    )
    assert (
        "dead point" in text or "can still" in text or "name the body, like velocity(A, OA)" in text
    )


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"R": "1"}, 'crank: no parameter "R": did you mean "r"? (known here: omega, phi, r)'),
        (
            {"r": "1,5"},
            'crank: r = 1,5: "1,5", character 2: found ",", expected an operator or the end',
        ),
        ({"r": "x\ny"}, 'crank: r = x·y: "x·y", character 3'),
        ({"r": "q"}, 'crank: r: unknown name "q": known here: pi'),
        ({"r": "sqrt(-1)"}, "crank: r: sqrt(...): square root of a negative number"),
        ({"phi": "60 + pi"}, 'crank: phi: "+" between things that do not go together'),
    ],
)
def test_values_that_are_no_numbers(values: dict[str, str], message: str) -> None:
    with pytest.raises(TemplateError) as refusal:
        solve_template(read_template("crank", CRANK), values)
    assert refusal.value.problems == (str(refusal.value),)
    assert message in str(refusal.value)


def test_all_unknown_parameters_are_told_at_once_and_unknown_asks_too() -> None:
    template = read_template("crank", CRANK)
    with pytest.raises(TemplateError) as refusal:
        solve_template(template, {"a": "1", "b": "2", "r": "("})
    assert len(refusal.value.problems) == 3
    with pytest.raises(TemplateError, match='crank: no ask "v_B": did you mean "v_A"'):
        solve_template(template, {}, ["v_B"])


def test_values_that_no_precision_tells_from_degenerate_ones_are_refused() -> None:
    # 2 cos(1 degree) cos(2 degrees) = cos(3 degrees) + cos(1 degree): zero, but not for balls
    zero = "2*cos(pi/180)*cos(pi/90) - cos(pi/60) - cos(pi/180)"
    assert "cannot be told from a degenerate one" in solving(
        ('quantity = "magnitude(velocity(A))"', f'quantity = "y(velocity(A))/({zero})"')
    )


@pytest.mark.parametrize(
    ("value", "exact"),
    [
        ("60", "1"),
        ("pi/3", "1"),
        ("2*atan(1/2)", "8/5"),
        ("acos(3/5)", "8/5"),
        ("37", None),
        ("sqrt(2)", None),
        ("180/pi", None),
    ],
)
def test_degrees_may_be_numbers_or_angles(value: str, exact: str | None) -> None:
    text = CRANK.replace("magnitude(velocity(A))", "y(A)*2/sqrt(3)" if exact == "1" else "y(A)*2")
    answer = solve_template(read_template("crank", text, kept=True), {"phi": value, "r": "1"})[
        "v_A"
    ]
    assert answer.exact == exact


def test_lengths_and_rates_with_pi_in_them_are_certified() -> None:
    text = CRANK.replace('A = "polar(O, r, phi)"', 'A = "(r*phi, 0)"').replace(
        'velocity = "omega"', 'velocity = "2*pi*omega/60"'
    )
    answer = solve_template(read_template("crank", text), {"phi": "90"})["v_A"]
    assert not answer.is_exact
    assert abs(answer.value - 3.141592653589793**2 / 30) < 1e-14  # pi/2 * 2 pi 2/60


def test_numbers_that_would_grow_without_end_are_cut_to_certified_balls() -> None:
    lengths = "\n".join(f'l{i + 1} = "l{i}**16 + 1e-9"' for i in range(12))
    text = CRANK.replace('half = "r/2"', f'half = "r/2"\nl0 = "9/10"\n{lengths}').replace(
        "polar(O, half, phi)", "(l12, 0)"
    )
    assert abs(solve_template(read_template("crank", text), {})["v_A"].value - 2) < 1e-15


def test_templates_are_found_by_name_or_by_path(tmp_path: Path) -> None:
    (tmp_path / "crank.toml").write_text(CRANK, encoding="utf-8")
    assert (
        load_template("crank", tmp_path).name
        == "crank"
        == load_template(str(tmp_path / "crank.toml")).name
    )
    assert "slider-crank" in template_names()
    assert load_template("slider-crank").family == "slider-crank"
    assert shipped("templates").is_dir()
    with pytest.raises(
        TemplateError, match=r'no template "slider-cranc": did you mean "slider-crank"'
    ):
        load_template("slider-cranc")
    with pytest.raises(TemplateError, match=r'no template "../slider-crank"'):
        load_template("../slider-crank")
    with pytest.raises(
        TemplateError, match=r"absent.toml: cannot be read: No such file or directory"
    ):
        load_template(str(tmp_path / "absent.toml"))
    (tmp_path / "latin.toml").write_bytes(b'title = "\xe9"')
    with pytest.raises(
        TemplateError, match=r"latin.toml: not UTF-8 at byte 9: save the template as UTF-8"
    ):
        load_template(str(tmp_path / "latin.toml"))
    (tmp_path / "large.toml").write_bytes(b"#" * (4 * MAX_CHARACTERS + 10))
    with pytest.raises(TemplateError, match=r"too large: at most 100000 characters are read"):
        load_template(str(tmp_path / "large.toml"))


def test_a_mechanism_that_is_refused_names_its_template() -> None:
    with pytest.raises(
        MechanismError, match=r"slider-crank: points\.B: the circle about A of radius 0\.5 does not"
    ):
        solve_template(load_template("slider-crank"), {"k": "1/2", "phi": "90"})
