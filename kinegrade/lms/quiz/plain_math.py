r"""Formulas as plain text, for titles and for systems that show no math: `\omega_{AB}` becomes
ω_AB.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache

from kinegrade.exam.formula import TEXT, require_known_math, write_unit

_GREEK = {
    "alpha": "α",
    "beta": "β",
    "gamma": "γ",
    "delta": "δ",
    "epsilon": "ε",
    "varepsilon": "ε",
    "zeta": "ζ",
    "eta": "η",
    "theta": "θ",
    "vartheta": "θ",
    "iota": "ι",
    "kappa": "κ",
    "lambda": "λ",
    "mu": "μ",
    "nu": "ν",
    "xi": "ξ",
    "pi": "π",
    "rho": "ρ",
    "varrho": "ρ",
    "sigma": "σ",
    "tau": "τ",
    "upsilon": "υ",
    "phi": "φ",
    "varphi": "φ",
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
_SIGNS = {
    "cdot": "·",
    "times": "×",
    "div": "÷",
    "pm": "±",
    "mp": "∓",
    "le": "≤",
    "leq": "≤",
    "ge": "≥",
    "geq": "≥",
    "ne": "≠",
    "neq": "≠",
    "approx": "≈",
    "equiv": "≡",
    "sim": "∼",
    "propto": "∝",
    "perp": "⊥",
    "parallel": "∥",
    "angle": "∠",
    "triangle": "△",
    "circ": "°",
    "prime": "′",
    "infty": "∞",
    "ldots": "…",
    "cdots": "⋯",
    "to": "→",
    "rightarrow": "→",
    "leftarrow": "←",
    "Rightarrow": "⇒",
    "implies": "⇒",
    "leftrightarrow": "↔",
    "uparrow": "↑",
    "downarrow": "↓",
    "partial": "∂",
    "int": "∫",
    "sum": "∑",
    "mid": "|",
    "in": "∈",
    "quad": " ",
    "qquad": " ",
}
_UNSEEN = frozenset(
    {
        "left",
        "right",
        "mathrm",
        "mathbf",
        "mathit",
        "boldsymbol",
        "bm",
        "vec",
        "bar",
        "hat",
        "tilde",
        "dot",
        "ddot",
        "overline",
        "underbrace",
        "overrightarrow",
        "widehat",
    }
)
_SPACES = {",": " ", ";": " ", ":": " ", " ": " ", "!": "", "\\": "; "}
_TOKEN = re.compile(r"\\[A-Za-z]+|\\.|[{}^_]|[^\\{}^_]", re.DOTALL)
_ENVIRONMENT = re.compile(r"\\(?:begin|end)\s*\{[^{}]*\}|&")
_ATOM = re.compile(r"[^\W_]+(?:_[^\W_]+)?|[0-9.]+")
_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_DIGITS = re.compile(r"-?[0-9]+")
_BLANKS = re.compile(r"\s+")


@lru_cache(maxsize=4096)
def write_plain_math(latex: str, where: str = "text") -> str:
    r"""A formula in one line of plain text.

    Raises TypesetError where it contains anything but the math that every typesetter prints.

    >>> write_plain_math(r"v_B = \frac{2\sqrt{3}}{3}\,\unit{m/s^2}"), write_plain_math(r"30^\circ")
    ('v_B = (2√3)/3 m/s²', '30°')
    """
    spelled = TEXT.sub(
        lambda found: "{,}" if found[2] else f"{{{write_unit(found[1])}}}",
        require_known_math(latex, where),
    )
    return _BLANKS.sub(
        " ", _write_sequence(iter(_TOKEN.findall(_ENVIRONMENT.sub(" ", spelled))))
    ).strip()


def _write_sequence(tokens: Iterator[str]) -> str:
    """The text up to the closing brace."""
    written = ""
    for token in tokens:
        if token == "}":
            break
        written += _write_part(token, tokens)
    return written


def _write_part(token: str, tokens: Iterator[str]) -> str:
    match token:
        case "{":
            return _write_sequence(tokens)
        case "^":
            return _write_raised(_write_argument(tokens))
        case "_":
            index = _write_argument(tokens)
            return f"_{index}" if index.isalnum() else f"_({index})"
        case r"\frac" | r"\dfrac" | r"\tfrac":
            return (
                f"{_write_bracketed(_write_argument(tokens))}/"
                f"{_write_bracketed(_write_argument(tokens))}"
            )
        case r"\sqrt":
            return f"√{_write_bracketed(_write_argument(tokens))}"
        case _:
            return _write_command(token[1:]) if token.startswith("\\") else token


def _write_argument(tokens: Iterator[str]) -> str:
    for token in tokens:
        if not token.isspace():
            return _write_part(token, tokens).strip()
    return ""


def _write_command(name: str) -> str:
    if name in _UNSEEN:
        return ""
    if name in _GREEK:
        return _GREEK[name]
    return _SPACES.get(name, _SIGNS.get(name, name))


def _write_bracketed(text: str) -> str:
    return text if not text or _ATOM.fullmatch(text) else f"({text})"


def _write_raised(text: str) -> str:
    if text in ("°", "′"):
        return text
    return text.translate(_RAISED) if _DIGITS.fullmatch(text) else f"^{_write_bracketed(text)}"
