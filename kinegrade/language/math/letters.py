"""The letters and signs that formulas may hold: the one table of what each writer makes of them.

Every LaTeX command that an author may write is here or among the commands that `reading` gives
arguments to.
"""

from __future__ import annotations

from typing import Literal, TypeAlias
from unicodedata import name

from msgspec import Struct

Kind: TypeAlias = Literal[
    "ordinary", "relation", "binary", "opening", "closing", "punctuation", "large"
]


class GreekLetter(Struct, frozen=True):
    """A Greek letter: its character, and its name in Typst."""

    character: str
    typst: str


class SignForms(Struct, frozen=True):
    """A sign: its character, its name in Typst, and how it is spaced."""

    character: str
    typst: str
    kind: Kind = "ordinary"


# The variants: where LaTeX and Typst disagree on which of two shapes has the plain name
_VARIANTS = {
    "epsilon": GreekLetter("ϵ", "epsilon.alt"),
    "varepsilon": GreekLetter("ε", "epsilon"),
    "vartheta": GreekLetter("ϑ", "theta.alt"),
    "varrho": GreekLetter("ϱ", "rho.alt"),
    "phi": GreekLetter("ϕ", "phi.alt"),
    "varphi": GreekLetter("φ", "phi"),
}
_PLAIN = {
    "alpha": "α",
    "beta": "β",
    "gamma": "γ",
    "delta": "δ",
    "zeta": "ζ",
    "eta": "η",
    "theta": "θ",
    "iota": "ι",
    "kappa": "κ",
    "lambda": "λ",
    "mu": "μ",
    "nu": "ν",
    "xi": "ξ",
    "pi": "π",
    "rho": "ρ",
    "sigma": "σ",
    "tau": "τ",
    "upsilon": "υ",
    "chi": "χ",
    "psi": "ψ",
    "omega": "ω",
    "Gamma": "Γ",
    "Delta": "Δ",
    "Theta": "Θ",
    "Lambda": "Λ",
    "Xi": "Ξ",
    "Pi": "Π",
    "Sigma": "Σ",
    "Upsilon": "Υ",
    "Phi": "Φ",
    "Psi": "Ψ",
    "Omega": "Ω",
}
GREEK = {name: GreekLetter(character, name) for name, character in _PLAIN.items()} | _VARIANTS
SIGNS = {
    "+": SignForms("+", "+", "binary"),
    "-": SignForms("−", "-", "binary"),
    "*": SignForms("∗", "*", "binary"),
    "/": SignForms("/", "slash"),
    "=": SignForms("=", "=", "relation"),
    "<": SignForms("<", "<", "relation"),
    ">": SignForms(">", ">", "relation"),
    ":": SignForms(":", "colon", "relation"),
    "(": SignForms("(", "paren.l", "opening"),
    ")": SignForms(")", "paren.r", "closing"),
    "[": SignForms("[", "bracket.l", "opening"),
    "]": SignForms("]", "bracket.r", "closing"),
    r"\{": SignForms("{", "brace.l", "opening"),
    r"\}": SignForms("}", "brace.r", "closing"),
    "|": SignForms("|", "bar.v"),
    r"\|": SignForms("‖", "bar.v.double"),
    ",": SignForms(",", "comma", "punctuation"),
    ";": SignForms(";", "semi", "punctuation"),
    "{,}": SignForms(",", '","'),
    ".": SignForms(".", "."),
    "!": SignForms("!", "!"),
    "?": SignForms("?", "?"),
    r"\%": SignForms("%", "%"),
    r"\cdot": SignForms("·", "dot", "binary"),
    r"\times": SignForms("×", "times", "binary"),
    r"\div": SignForms("÷", "div", "binary"),
    r"\pm": SignForms("±", "plus.minus", "binary"),
    r"\mp": SignForms("∓", "minus.plus", "binary"),
    r"\circ": SignForms("°", "circle.small"),
    r"\le": SignForms("≤", "<=", "relation"),
    r"\leq": SignForms("≤", "<=", "relation"),
    r"\ge": SignForms("≥", ">=", "relation"),
    r"\geq": SignForms("≥", ">=", "relation"),
    r"\ne": SignForms("≠", "!=", "relation"),
    r"\neq": SignForms("≠", "!=", "relation"),
    r"\approx": SignForms("≈", "approx", "relation"),
    r"\equiv": SignForms("≡", "equiv", "relation"),
    r"\sim": SignForms("∼", "tilde", "relation"),
    r"\propto": SignForms("∝", "prop", "relation"),
    r"\perp": SignForms("⊥", "perp", "relation"),
    r"\parallel": SignForms("∥", "parallel", "relation"),
    r"\mid": SignForms("∣", "divides", "relation"),
    r"\in": SignForms("∈", "in", "relation"),
    r"\to": SignForms("→", "->", "relation"),
    r"\rightarrow": SignForms("→", "->", "relation"),
    r"\leftarrow": SignForms("←", "<-", "relation"),
    r"\leftrightarrow": SignForms("↔", "<->", "relation"),
    r"\Rightarrow": SignForms("⇒", "=>", "relation"),
    r"\implies": SignForms("⇒", "=>", "relation"),
    r"\uparrow": SignForms("↑", "arrow.t", "relation"),
    r"\downarrow": SignForms("↓", "arrow.b", "relation"),
    r"\curvearrowleft": SignForms("↶", "arrow.ccw.half"),
    r"\curvearrowright": SignForms("↷", "arrow.cw.half"),
    r"\angle": SignForms("∠", "angle"),
    r"\triangle": SignForms("△", "triangle.t"),
    r"\prime": SignForms("′", "prime"),
    r"\infty": SignForms("∞", "infinity"),
    r"\partial": SignForms("∂", "partial"),
    r"\ldots": SignForms("…", "..."),
    r"\cdots": SignForms("⋯", "dots.h.c"),
    r"\int": SignForms("∫", "integral", "large"),
    r"\sum": SignForms("∑", "sum", "large"),
}
_FUNCTIONS = "sin cos tan cot arcsin arccos arctan sinh cosh tanh exp ln log min max"
FUNCTIONS = frozenset(_FUNCTIONS.split())


def find_letter(name: str) -> str:
    r"""The character of a letter.

    >>> find_letter("A"), find_letter("omega")
    ('A', 'ω')
    """
    return GREEK[name].character if name in GREEK else name


def name_sign(latex: str) -> str:
    r"""What the catalogues call a sign: its name in Unicode.

    >>> name_sign(r"\approx"), name_sign(r"\leq")
    ('almost-equal-to', 'less-than-or-equal-to')
    """
    return name(SIGNS[latex].character).lower().replace(" ", "-")
