"""LaTeX math becomes Typst math that compiles, and never Typst code."""

from __future__ import annotations

import json
import re

import pytest
import typst
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import TypesetError
from kinegrade.language.math.tokens import COMMANDS
from kinegrade.language.math.typst.formula import write_typst_math
from kinegrade.language.math.units import write_unit
from kinegrade.language.typst_text import write_literal


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\omega_{AB}", "omega_(A B)"),
        ("O_1A", "O_(1) A"),
        (r"\varphi = 30^\circ", "phi = 30 degree"),
        (r"\boldsymbol{a}_{BA}^{\mathrm{n}}", "bold(a)_(B A)^(upright(n))"),
        (r"\frac{\sqrt{382 - 9 \sqrt{3}}}{20}", "frac(sqrt(382 - 9 sqrt(3)), 20)"),
        (r"3\,\unit{m/s^2}", '3 thin"m/s²"'),
        (r"0{,}866", '0","866'),
        (r"v_{\text{牵连}}", 'v_("牵连")'),
        (r"x\begin{aligned} a \\ b \end{aligned}^2", r"x attach(a \ b)^(2)"),
        (r"x\begin{aligned}\end{aligned}_a", 'x attach("")_(a)'),
    ],
)
def test_the_formulas_of_mechanics(latex: str, expected: str) -> None:
    assert write_typst_math(latex, "q1") == expected


def test_every_supported_command_compiles() -> None:
    operands = {"frac": "{a}{b}", "dfrac": "{a}{b}", "tfrac": "{a}{b}", "left": "(a", "right": ")"}
    skipped = {"begin", "end", "right"}
    formulas = [rf"\{name}{operands.get(name, ' x')}" for name in sorted(COMMANDS - skipped)]
    formulas[formulas.index(r"\left(a")] = r"\left(a\right)"
    formulas += [
        r"\begin{cases} x = 1 \\ y = 2 \end{cases}",
        r"\begin{aligned} x &= 1 \\ y &= 2 \end{aligned}",
    ]
    source = "\n".join(f"${write_typst_math(latex, 'all')}$" for latex in formulas)
    assert typst.compile(source.encode(), format="svg", ignore_system_fonts=True)


@pytest.mark.parametrize(
    ("latex", "message"),
    [
        (
            r"\omgea",
            r"q1: formula $\omgea$: unknown command \omgea - expected plain LaTeX math - did you "
            r"mean \omega?",
        ),
        (r"\input{/etc/passwd}", "unknown command \\input"),
        (r"\zzzzzz", "write it with other commands"),
        (
            r"\begin{tikzpicture}\end{tikzpicture}",
            "unknown environment tikzpicture - expected aligned or cases",
        ),
        (
            '#read("secret")',
            "# in math - expected letters, numbers and LaTeX commands - put it into",
        ),
        (
            "圆",
            "圆 in math - expected letters, numbers and LaTeX commands - put it into \\text{...}",
        ),
        (
            r"\end{cases} x",
            r"q1: formula $\end{cases} x$: cannot be read - expected whole LaTeX math - fix it",
        ),
        ("a // b", "// in math - expected"),
        (r"\frac{1}{2", "braces do not match - expected a } for every { - count them"),
        ("a}{", "braces do not match"),
    ],
)
def test_refusals_say_what_and_where(latex: str, message: str) -> None:
    with pytest.raises(TypesetError) as refusal:
        write_typst_math(latex, "q1")
    assert message in "\n".join(refusal.value.problems)


def test_all_faults_of_a_formula_are_told_at_once() -> None:
    with pytest.raises(TypesetError) as refusal:
        write_typst_math(r"\foo + \bra # {", "q1")
    assert len(refusal.value.problems) == 4


def test_code_in_text_stays_text() -> None:
    assert write_typst_math(r'\text{#read("/etc/passwd")}', "q1") == r'"#read(\"/etc/passwd\")"'


@given(st.text(st.characters(exclude_categories=["Cc", "Cs", "Zl", "Zp"]), max_size=20))
def test_a_literal_is_read_back_as_the_same_text(text: str) -> None:
    assert json.loads(typst.eval(b"", write_literal(text))) == text


def test_control_characters_become_blanks() -> None:
    assert write_literal("a\nb\x00c\u2028") == '"a b c "'


TOKENS = [f"\\{name} " for name in sorted(COMMANDS - {"begin", "end"})] + list(
    "ab12{}()[]|^_&,;:=+-*/.'!<>? %#"
)
TOKENS += [r"\text{#a}", r"\{", r"\\", r"\,", r"\begin{cases}", r"\end{cases}"]


BOX = "#box(stroke:0.5pt,inset:(x:2.4pt),outset:(y:2.6pt),math.equation(alt:,$"


@given(st.lists(st.sampled_from(TOKENS), max_size=9).map("".join))
def test_no_formula_becomes_code(latex: str) -> None:
    try:
        source = write_typst_math(latex, "q1")
    except TypesetError:
        return
    code = re.sub(r'"(?:[^"\\]|\\.)*"', "", source)
    boxes = code.count(BOX)
    assert boxes == latex.count("boxed")  # the one function that the writer itself calls
    code = code.replace(BOX, "").replace("$.body)) ", "", boxes)
    assert not set(code) & set('#$@"')
    assert "//" not in code
    assert "/*" not in code


def test_units_are_printed_as_books_do() -> None:
    units = ["m/s^2", "rad/s", "deg", "1", "s^-1", "N*m"]
    assert [write_unit(unit) for unit in units] == ["m/s²", "rad/s", "°", "–", "s⁻¹", "N·m"]
