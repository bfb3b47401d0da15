"""LaTeX math into Typst math: the formulas of statements, symbols and exact values.

tylax converts. It passes unknown commands on as letters and `\\text{...}` on as Typst code;
therefore what it may see is listed here, and text is taken out before and put back as string
literals. Nothing a formula holds can become Typst code. `kinegrade.exam.markup` is the next storey
up.
"""

from __future__ import annotations

import re
from difflib import get_close_matches
from functools import lru_cache

import tylax

from kinegrade.errors import TypesetError, write_message
from kinegrade.language.lines import shorten

_GREEK = """
    alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta iota kappa lambda mu nu xi pi
    rho varrho sigma tau upsilon phi varphi chi psi omega
    Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega
"""
_LETTERING = """
    mathrm mathbf mathit boldsymbol bm vec bar hat tilde dot ddot overline underbrace overrightarrow
    widehat
"""
_STRUCTURE = "frac dfrac tfrac sqrt left right quad qquad"
_SYMBOLS = """
    cdot times div pm mp le leq ge geq ne neq approx equiv sim propto perp parallel angle triangle
    circ prime infty ldots cdots to rightarrow leftarrow Rightarrow leftrightarrow uparrow downarrow
    implies partial int sum mid in
"""
_FUNCTIONS = "sin cos tan cot arcsin arccos arctan sinh cosh tanh exp ln log min max"
COMMANDS = frozenset(
    " ".join((_GREEK, _LETTERING, _STRUCTURE, _SYMBOLS, _FUNCTIONS, "begin end")).split()
)
_ENVIRONMENTS = frozenset({"cases", "aligned"})

_COMMAND = re.compile(r"\\([A-Za-z]+|.|$)", re.DOTALL)
_SPACING = frozenset(",;:! ")
_ESCAPED = frozenset("{}%|\\")
TEXT = re.compile(r"\\(?:text|unit)\s*\{([^{}]*)\}|\{(,)\}")  # {,} is LaTeX's decimal comma
_ENVIRONMENT = re.compile(r"\\(?:begin|end)\s*\{([^{}]*)\}")
_FORBIDDEN = re.compile(r'[#"$@`~]|//|/\*|[^\x00-\x7f]')  # beyond ASCII, tylax may lose its place
_LEFTOVER = re.compile(r'[#"$]|/\*|//')  # code, or the comment in which tylax reports a fault
RAISED = re.compile(r"\^\{?([-\u2212]?\d+)\}?")
_SUPERSCRIPTS = str.maketrans("-\u22120123456789", "⁻⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_OPTIONS = tylax.L2TOptions(frac_to_slash=False)
# All of Unicode's Cc, Zl, Zp and Cs
_CONTROL = re.compile("[\\x00-\\x1f\\x7f-\\x9f\\u2028\\u2029\\ud800-\\udfff]")
_PLACE = "@"  # stands for a text during the conversion
_PLACED = re.compile(rf"\s*{_PLACE}\s*")  # a blank beside a string literal would be printed


def write_literal(text: str) -> str:
    """`text` as a Typst string literal, whatever it contains; control characters become spaces.

    >>> print(write_literal('a "b" #read(1)'))
    "a \\"b\\" #read(1)"
    """
    return '"' + _CONTROL.sub(" ", text).replace("\\", "\\\\").replace('"', '\\"') + '"'


def write_unit(unit: str) -> str:
    """A unit as it is printed: exponents raised, a degree sign, a thin dash for a pure number.

    >>> write_unit("rad/s^2"), write_unit("deg"), write_unit("1")
    ('rad/s²', '°', '–')
    """
    raised = RAISED.sub(lambda match: match[1].translate(_SUPERSCRIPTS), unit)
    return {"deg": "°", "1": "–"}.get(unit, raised.replace("*", "·"))


def convert_formula(latex: str, where: str) -> str:
    """Typst math (to stand between dollar signs) for `latex`, LaTeX math without dollar signs.

    Raises TypesetError naming `where` and every unknown command, environment and stray character.

    >>> convert_formula(r"v_B = \\frac{2\\sqrt{3}}{3}\\,\\mathrm{m/s}", "q1")
    'v_(B) = frac(2 sqrt(3), 3)thin upright(m slash s)'
    """
    try:
        return _convert_once(latex)
    except TypesetError:
        return _convert(latex, where)


@lru_cache(maxsize=8192)
def _convert_once(latex: str) -> str:
    """The same wherever it is used, so that the papers of a class share it."""
    return _convert(latex, "")


def _convert(latex: str, where: str) -> str:
    texts = ["".join(groups) for groups in TEXT.findall(require_known_math(latex, where))]
    converted = tylax.latex_to_typst(TEXT.sub(f"{{{_PLACE}}}", latex), options=_OPTIONS)
    if _LEFTOVER.search(converted) or converted.count(_PLACE) != len(texts):
        raise TypesetError(
            write_message(
                formula_place(latex, where), "cannot be read", "whole LaTeX math", "fix it"
            )
        )
    following = iter(texts)
    placed = _PLACED.sub(lambda _: write_literal(write_unit(next(following))), converted)
    return placed.replace("^(circle.small)", "degree").strip()


def formula_place(latex: str, where: str) -> str:
    """How a message names a formula, cut if it is long."""
    return f"{where}: formula ${shorten(latex)}$"


def require_known_math(latex: str, where: str) -> str:
    """`latex` itself, when it holds nothing but the math that every press prints.

    Raises TypesetError naming `where` and every unknown command, environment and stray character.
    """
    problems = _find_problems(latex, where)
    if problems:
        raise TypesetError(*problems)
    return latex


def _find_problems(latex: str, where: str) -> list[str]:
    place = formula_place(latex, where)
    outside = TEXT.sub("", latex)
    found = [
        write_message(place, f"unknown command \\{name}", "plain LaTeX math", _find_nearest(name))
        for name in _COMMAND.findall(outside)
        if not _is_known(name)
    ]
    found += [
        write_message(
            place,
            f"unknown environment {name}",
            " or ".join(sorted(_ENVIRONMENTS)),
            "use one of these",
        )
        for name in _ENVIRONMENT.findall(outside)
        if name not in _ENVIRONMENTS
    ]
    found += [
        write_message(
            place,
            f"{stray} in math",
            "letters, numbers and LaTeX commands",
            "put it into \\text{...} or outside the formula",
        )
        for stray in _FORBIDDEN.findall(outside)
    ]
    if not _is_balanced(outside):
        found.append(write_message(place, "braces do not match", "a } for every {", "count them"))
    return found


def _find_nearest(command: str) -> str:
    near = get_close_matches(command, COMMANDS, n=1)
    return f"did you mean \\{near[0]}?" if near else "write it with other commands"


def _is_known(command: str) -> bool:
    return command in COMMANDS or command in _SPACING or command in _ESCAPED


def _is_balanced(latex: str) -> bool:
    depth = 0
    for brace in re.findall(r"(?<!\\)[{}]", latex):
        depth += 1 if brace == "{" else -1
        if depth < 0:
            return False
    return depth == 0
