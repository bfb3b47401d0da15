"""Symbols and short prose as HTML: Greek letters, italics, subscripts, primes; any other LaTeX is
left as text.

Every incoming character is escaped; the only tags are those made here.
"""

from __future__ import annotations

import re
from html import escape

from markupsafe import Markup

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
    "vartheta": "ϑ",
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
    "circ": "°",
    "angle": "∠",
    "cdot": "·",
    "times": "×",
    "prime": "′",
    "parallel": "∥",
    "perp": "⊥",
    "pm": "±",
    "infty": "∞",
    ",": "\u202f",
    " ": " ",
    ";": " ",
    ":": " ",
    "!": "",
    "quad": " ",
}
_UPRIGHT = ("mathrm", "text", "mathbf", "unit")
_TOKEN = re.compile(r"\\(?:[A-Za-z]+|.)|[A-Za-z]+|.", re.DOTALL)
_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def write_symbol_html(latex: str) -> Markup:
    r"""A symbol, given as LaTeX math.

    >>> print(write_symbol_html(r"\omega_{AB}"), write_symbol_html("B'"))
    <span class="math"><i>ω</i><sub><i>AB</i></sub></span> <span class="math"><i>B</i>′</span>
    """
    # Made from escaped letters and our own tags
    return Markup(f'<span class="math">{_Reader(latex).whole()}</span>')


def write_prose_html(prose: str) -> Markup:
    """A line of Markdown with `$...$` math: only math and text, no other markup.

    >>> print(write_prose_html("speed of $B$ < $c$"))
    speed of <span class="math"><i>B</i></span> &lt; <span class="math"><i>c</i></span>
    """
    parts = prose.split("$")
    whole = len(parts) % 2 == 1
    return Markup("").join(
        write_symbol_html(part) if whole and index % 2 else Markup(escape(part))
        for index, part in enumerate(parts)
    )


def write_unit_text(unit: str) -> str:
    """A unit with raised exponents; "" for a pure number.

    >>> write_unit_text("m/s^2"), write_unit_text("deg"), write_unit_text("1")
    ('m/s²', '°', '')
    """
    raised = re.sub(r"\^\{?(-?[0-9]+)\}?", lambda power: power[1].translate(_SUPERSCRIPTS), unit)
    return {"deg": "°", "1": ""}.get(unit, raised.replace("*", "·"))


class _Reader:
    """One formula, token by token."""

    def __init__(self, latex: str) -> None:
        self._tokens = _TOKEN.findall(latex)
        self._place = 0

    def whole(self) -> str:
        """The whole formula, whether or not its braces match."""
        rows = []
        while self._place < len(self._tokens):
            rows.append(self.row())
        return "".join(rows)

    def row(self, *, upright: bool = False) -> str:
        """Everything up to a closing brace or the end."""
        pieces = []
        while self._place < len(self._tokens):
            if self._tokens[self._place] == "}":
                self._place += 1
                break
            pieces.append(self._piece(upright))
        return "".join(pieces)

    def _piece(self, upright: bool) -> str:
        """A letter, a sign, a group or an index."""
        if self._place >= len(self._tokens):
            return ""
        token = self._tokens[self._place]
        self._place += 1
        match token:
            case "{":
                return self.row(upright=upright)
            case "_":
                return f"<sub>{self._piece(upright)}</sub>"
            case "^":
                inner = self._piece(upright)
                return inner if inner in ("°", "′") else f"<sup>{inner}</sup>"
            case _ if token.startswith("\\"):
                return self.command(token[1:], upright)
            case _:
                return _write_letters(token, upright)

    def command(self, name: str, upright: bool) -> str:
        """A command without its backslash."""
        if name in _UPRIGHT:
            return self._piece(True)
        if name in _SIGNS:
            return _SIGNS[name]
        return _write_letters(_GREEK[name], upright) if name in _GREEK else escape(name)


def _write_letters(token: str, upright: bool) -> str:
    shown = escape({"'": "′", "-": "−"}.get(token, token))
    return f"<i>{shown}</i>" if token.isalpha() and not upright else shown
