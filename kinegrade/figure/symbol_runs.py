"""A LaTeX symbol as runs of text, for back ends that have fonts but no formula typesetter.

Letters are italic, digits and `\\mathrm` upright, scripts small and shifted, as in print. Lengths
are in em at the symbol's size.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace

from kinegrade.figure.extent import EM, measure_symbol

_SCRIPT = 0.72  # relative to the size of the script's base
_RAISED, _LOWERED = 0.38, -0.2  # the baseline of a script, in em of its base
_GREEK = {
    "alpha": "α",
    "beta": "β",
    "gamma": "γ",
    "delta": "δ",
    "epsilon": "ϵ",
    "varepsilon": "ε",
    "zeta": "ζ",
    "eta": "η",
    "theta": "θ",
    "vartheta": "ϑ",
    "kappa": "κ",
    "lambda": "λ",
    "mu": "μ",
    "nu": "ν",
    "xi": "ξ",
    "pi": "π",
    "rho": "ρ",
    "varrho": "ϱ",
    "sigma": "σ",
    "tau": "τ",
    "upsilon": "υ",
    "phi": "ϕ",
    "varphi": "φ",
    "chi": "χ",
    "psi": "ψ",
    "omega": "ω",
}
_UPRIGHT = {
    "Gamma": "Γ",
    "Delta": "Δ",
    "Theta": "Θ",
    "Lambda": "Λ",
    "Xi": "Ξ",
    "Pi": "Π",
    "Sigma": "Σ",
    "Phi": "Φ",
    "Psi": "Ψ",
    "Omega": "Ω",
    "prime": "′",
    "circ": "°",
    "cdot": "·",
    "infty": "∞",
    "-": "−",
}
_ACCENTS = {"vec": "\u20d7", "dot": "\u0307", "ddot": "\u0308", "bar": "\u0304"}
_TOKEN = re.compile(r"\\[A-Za-z]+|\S")
_LOW, _DEEP, _BOTH = (
    frozenset("acemnorsuvwxzαγεικνοπστυωϵ"),
    frozenset("gpqyηχμ"),
    frozenset("jβζξρφϕψϱ,;()"),
)


@dataclass(frozen=True)
class Run:
    """Letters in one style; `shift` is the height of their baseline, `back` how far to move back
    before them.
    """

    text: str
    italic: bool = False
    bold: bool = False
    size: float = 1.0
    shift: float = 0.0
    back: float = 0.0

    @property
    def top(self) -> float:
        """How high above the symbol's baseline the letters reach."""
        low = all(letter in _LOW | _DEEP for letter in self.text)
        return self.shift + self.size * (0.46 if low else 0.68)

    @property
    def bottom(self) -> float:
        """How far above the symbol's baseline the letters begin; negative below it."""
        deep = any(letter in _DEEP | _BOTH for letter in self.text)
        return self.shift - self.size * (0.21 if deep else 0.0)


def split_symbol(symbol: str) -> tuple[Run, ...]:
    """The runs of a symbol that `kinegrade.problem.symbols.find_symbol_fault` finds no fault with.

    >>> [run.text for run in split_symbol("O_1'")]
    ['O', '1', '′']
    """
    return tuple(_merge(_Reader(symbol).row(Run(""))))


class _Reader:
    """One symbol, token by token."""

    def __init__(self, latex: str) -> None:
        self._tokens = _TOKEN.findall(latex)
        self._place = 0

    def row(self, style: Run) -> list[Run]:
        """Everything up to a closing brace or the end, in a style; scripts belong to the atom
        before them.
        """
        runs: list[Run] = []
        while token := self._next():
            if token == "}":
                break
            runs += self._scripts(token, style) if token in "_^" else self.atom(token, style)
        return runs

    def _scripts(self, token: str, style: Run) -> list[Run]:
        """One script, or two, the second of which stands above or below the first."""
        first_place = self._place
        runs = self.script(token, style)
        width = measure_symbol("".join(self._tokens[first_place : self._place]))[0] / EM - 0.12
        if self._peek() in ("_", "^"):
            second = self.script(self._next(), style)
            runs += (
                [replace(second[0], back=width * _SCRIPT * style.size), *second[1:]]
                if second
                else []
            )
        return runs

    def script(self, token: str, style: Run) -> list[Run]:
        """A small atom, raised or lowered; a prime or a degree sign is already raised."""
        raised = style.shift + style.size * (_RAISED if token == "^" else _LOWERED)
        inner = self.atom(self._next(), replace(style, size=style.size * _SCRIPT, shift=raised))
        plain = token == "^" and all(run.text in "′°" for run in inner)
        return (
            [replace(run, size=style.size, shift=style.shift) for run in inner] if plain else inner
        )

    def atom(self, token: str, style: Run) -> list[Run]:
        """A letter, a sign, a group or a command with its arguments."""
        name = token.removeprefix("\\")
        match name:
            case "":
                return []
            case "{":
                return self.row(style)
            case "mathrm":
                return [replace(run, italic=False) for run in self.atom(self._next(), style)]
            case "mathbf":
                return [
                    replace(run, italic=False, bold=True) for run in self.atom(self._next(), style)
                ]
            case "boldsymbol":
                return [replace(run, bold=True) for run in self.atom(self._next(), style)]
            case "sqrt":
                return self.root(style)
            case "frac":
                return [
                    *self.atom(self._next(), style),
                    replace(style, text="/"),
                    *self.atom(self._next(), style),
                ]
            case "'":
                return [replace(style, text="′")]
            case _:
                return self.lettered(name, style)

    def lettered(self, name: str, style: Run) -> list[Run]:
        """A letter, a sign or an accent over the atom that follows."""
        if name in _ACCENTS:
            return [
                replace(run, text=run.text + _ACCENTS[name])
                for run in self.atom(self._next(), style)
            ]
        if name in _UPRIGHT:
            return [replace(style, text=_UPRIGHT[name])]
        letter = _GREEK.get(name, name)
        return [replace(style, text=letter, italic=letter.isalpha())]

    def root(self, style: Run) -> list[Run]:
        """A root sign before one letter or digit, or before brackets."""
        inner = self.atom(self._next(), style)
        if len("".join(run.text for run in inner)) == 1:
            return [replace(style, text="√"), *inner]
        return [replace(style, text="√("), *inner, replace(style, text=")")]

    def _next(self) -> str:
        self._place += 1
        return self._tokens[self._place - 1] if self._place <= len(self._tokens) else ""

    def _peek(self) -> str:
        return self._tokens[self._place] if self._place < len(self._tokens) else ""


def _merge(runs: Iterable[Run]) -> list[Run]:
    """Adjacent runs of one style as one run."""
    merged: list[Run] = []
    for run in runs:
        if merged and replace(run, text="") == replace(merged[-1], text="", back=0.0):
            merged[-1] = replace(merged[-1], text=merged[-1].text + run.text)
        else:
            merged.append(run)
    return merged
