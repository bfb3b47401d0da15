"""Prose as Typst content."""

from __future__ import annotations

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import TypesetError
from kinegrade.language import ENGLISH
from kinegrade.language.prose.typst import write_line, write_prose

WORDS = {
    "box",
    "strong",
    "emph",
    "list",
    "enum",
    "start",
    "parbreak",
    "linebreak",
    "h",
    "em",
    "weak",
    "true",
    "math",
    "equation",
    "alt",
    "block",
    "body",
}


@pytest.mark.parametrize(
    ("markdown", "expected"),
    [
        (
            "The *crank* $OA$",
            '{"The ";emph({"crank";});" ";box(math.equation(alt:"O A",$O A$.body));}',
        ),
        ("a\n\n**b**", '{"a";parbreak();strong({"b";});}'),
        ("- a\n- $b$", '{list({"a";},{box(math.equation(alt:"b",$b$.body));},);}'),
        ("3. a", '{enum(start: 3, {"a";},);}'),
        ("so $$x = 1$$", '{"so ";math.equation(block:true,alt:"x equals 1",$x = 1$.body);}'),
        ("$$\nx\n$$", '{math.equation(block:true,alt:"x",$x$.body);}'),
        ("the rod\nAB", '{"the rod";" ";"AB";}'),
        ("曲柄\n转动", '{"曲柄";"转动";}'),
        ("the slider's pin", '{"the slider’s pin";}'),
        (r"5 \$ \* \# &amp;", r'{"5 $ * # &";}'),
    ],
)
def test_what_an_exam_needs(markdown: str, expected: str) -> None:
    assert write_prose(markdown, "q1", ENGLISH).replace('";"', "") == expected.replace('";"', "")


@given(st.text(st.sampled_from('ab #$*_`\\"(){}[]<>@-1.\n!/;'), max_size=30))
def test_no_text_becomes_code(text: str) -> None:
    """Outside of string literals and formulas there are only the words of the writer itself."""
    try:
        source = write_prose(text, "q1", ENGLISH) + write_line(text, "q1", ENGLISH)
    except TypesetError:
        return
    code = re.sub(r'"(?:[^"\\]|\\.)*"', "", source)
    code = re.sub(r"\$[^$#]*\$", "", code)
    assert set(re.findall(r"[^\W\d]+", code)) <= WORDS
    assert not set(code) & set('#$@\\"`')


def test_a_long_formula_may_end_a_line_only_before_a_relation_or_a_sign() -> None:
    root = r"\sqrt{(x_M - 0.16\,\mathrm{m})^2 + (y_M)^2}"
    assert write_line(rf"So $OM = {root} + a - b = 1$.", "q1", ENGLISH).count("box(") == 5
    short = write_line("So $OM = a + b = 1$.", "q1", ENGLISH)
    assert (
        short
        == '{"So ";box(math.equation(alt:"O M equals a plus b equals 1",$O M = a + b = 1$.body));".";}'
    )


def test_a_chinese_colon_after_a_formula_does_not_begin_a_line() -> None:
    assert (
        write_prose("长 $r$；角 $x$：甲；乙", "q1", ENGLISH)
        == '{"长 ";box(math.equation(alt:"r",$r$.body));"\u2060；角 ";box(math.equation(alt:"x",$x$.body));"\u2060：甲；乙";}'
    )


@pytest.mark.parametrize("formulas", [("a", "b"), ("0", "0"), (r"\frac{1}{2}", "x_1")])
def test_a_text_read_before_takes_other_formulas(formulas: tuple[str, str]) -> None:
    first, second = (write_prose(f"${latex}$", "q1", ENGLISH).strip("{}") for latex in formulas)
    assert write_prose(f"turn ${formulas[0]}$ by **${formulas[1]}$**; box(0);", "q1", ENGLISH) == (
        '{"turn ";' + first + '" by ";strong({' + second + '});"; box(0);";}'
    )


def test_a_fault_in_a_text_read_before_is_told_of_its_place() -> None:
    write_prose("turn $a$ by $b$", "q1", ENGLISH)
    with pytest.raises(TypesetError) as caught:
        write_prose(r"turn $\foo$ by $\baz$", "q2", ENGLISH)
    assert [problem.split(":")[0] for problem in caught.value.problems] == ["q2", "q2"]
