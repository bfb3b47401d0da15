"""Templates from strangers: nothing is executed, and whatever stands in a file is solved or refused
in short lines.
"""

from __future__ import annotations

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import TemplateError
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.sections.keys import MAX_CHARACTERS
from tests.problem.turning_crank import CRANK, faults, one_line_each, refused


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
    assert [
        problem
        for problem in refusal.value.problems
        if not ("\n" not in problem and len(problem) < 700)
    ] == []


def test_large_files_and_strange_names_are_refused_before_reading() -> None:
    with pytest.raises(
        TemplateError,
        match=r"hostile.toml: 100001 characters - expected a template of at most 100000",
    ):
        read_template("hostile", "#" * (MAX_CHARACTERS + 1))
    for name in ("../crank", "crank.toml", "Crank", "", "a b", "-a", "con\n"):
        with pytest.raises(
            TemplateError,
            match="a template's name is made of small letters, digits, hyphens and underscores",
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
