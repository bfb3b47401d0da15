"""Plain text and math for LaTeX: what is typed is printed, and nothing of it is obeyed."""

from __future__ import annotations

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import TypesetError
from kinegrade.language.math.latex import write_latex_math
from kinegrade.language.math.latex_text import write_comment, write_plain, write_signed, write_unit
from kinegrade.language.math.tokens import COMMANDS

OWN = re.compile(r"\\(?:text[a-z]+\{\}|[{}$&#%_,])|\$-\$|\{\[\}|\{\]\}|\{\}")


@given(st.text(max_size=20))
def test_plain_text_leaves_no_character_that_tex_obeys(text: str) -> None:
    assert not set(OWN.sub("", write_plain(text)).replace("~", "")) & set("\\{}$&#%_^\0\n\r")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ('O\'Neil--"x"', r"O\textquotesingle{}Neil-{}-\textquotedbl{}x\textquotedbl{}"),
        ("a\nb\x00c\u2028", "a b c "),
        ("a\u00a0b\u202fm \u2212 1", r"a~b\,m $-$ 1"),
        ("\u202eabc\u200b", "abc{}"),
        ("e\u0301", "é"),
    ],
)
def test_plain_text(text: str, expected: str) -> None:
    assert write_plain(text) == expected


def test_units_and_numbers_are_printed_as_books_do() -> None:
    assert [write_unit(text) for text in ("m/s^2", "deg", "1", "s^-1", "N*m")] == [
        r"m/s\textsuperscript{2}",
        "°",
        "–",
        r"s\textsuperscript{$-$1}",
        "N·m",
    ]
    assert write_signed("-1.5") == "$-$1.5"


def test_a_comment_stays_on_its_line() -> None:
    assert write_comment("a\nb") == "%% a·b"


@pytest.mark.parametrize(
    ("latex", "message"),
    [
        (r"\input{x}", r"q1: formula $\input{x}$: unknown command \input"),
        (
            "a %",
            r"q1: formula $a %$: % in math - expected a percent sign that starts no comment - "
            r"write \%",
        ),
        (r"a \\% b", r"% in math - expected a percent sign"),
        (
            "^^5cinput",
            r"q1: formula $^^5cinput$: ^ after ^ - expected one thing after each ^ - write ^{...}",
        ),
        (
            r"\begin L",
            r"q1: formula $\begin L$: \begin or \end without braces - expected braces right "
            r"after it - write \begin{cases}",
        ),
        ("圆", "圆 in math - expected"),
    ],
)
def test_math_beyond_the_closed_list_is_refused(latex: str, message: str) -> None:
    with pytest.raises(TypesetError) as refusal:
        write_latex_math(latex, "q1")
    assert message in "\n".join(refusal.value.problems)


def test_text_inside_math_is_plain_text() -> None:
    assert write_latex_math(r"v = 1{,}5\,\text{m/s^2 \par & 5}", "q1") == (
        r"v = 1{,}5\,\text{m/s\textsuperscript{2} \textbackslash{}par \& 5}"
    )
    assert write_latex_math(r"5\% \text{曲柄}", "q1") == r"5\%\text{曲柄}"


TOKENS = [f"\\{name} " for name in sorted(COMMANDS - {"begin", "end"})] + list(
    "ab12{}()^_&,=+-'!<>%#\n"
)
TOKENS += [
    r"\text{#\a}",
    r"\{",
    r"\\",
    r"\begin{cases}",
    r"\end{cases}",
    r"\text{}",
    r"\begin",
    "^^",
]


@given(st.lists(st.sampled_from(TOKENS), max_size=9).map("".join))
def test_no_formula_comments_or_codes(latex: str) -> None:
    try:
        source = write_latex_math(latex, "q1")
    except TypesetError:
        return
    assert "^^" not in source
    assert "\n" not in source
    assert not re.search(r"(?<!\\)(?:\\\\)*%", source)
