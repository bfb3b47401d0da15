"""Symbols as authors write them: LaTeX math without dollar signs, from a small alphabet, so that
every back end can set them and none can be led astray.
"""

from __future__ import annotations

import re

from kinegrade.errors import did_you_mean

_GREEK = re.findall(
    "[A-Za-z]+",
    "alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta kappa lambda mu nu xi pi "
    "rho varrho "
    "sigma tau upsilon phi varphi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega",
)
_COMMANDS = frozenset(
    (
        *_GREEK,
        "mathrm",
        "mathbf",
        "boldsymbol",
        "vec",
        "dot",
        "ddot",
        "bar",
        "sqrt",
        "frac",
        "prime",
        "circ",
        "cdot",
        "infty",
    )
)
_LETTERS = re.compile(r"(?:\\[A-Za-z]+|[A-Za-z0-9 _^{}'()+\-=.,])+")
_DANGLING = re.compile(
    r"[_^]\s*(?:[_^}]|$)|^\s*[_^]|\\(?:sqrt|mathrm|mathbf|boldsymbol|vec|dot|ddot|bar|frac)(?![A-Za-z])\s*(?!\{)"
)
_TWICE = re.compile(r"([_^])(?:\{[^{}]*\}|\\[A-Za-z]+|\w)\s*\1")


def find_symbol_fault(symbol: str) -> str | None:
    """What is wrong with a symbol, or None: LaTeX math from the small alphabet, braces balanced."""
    if not symbol.strip():
        return "a blank symbol - write LaTeX math without dollar signs, such as '\\omega_{AB}'"
    if not _LETTERS.fullmatch(symbol):
        return (
            f"{symbol!r} has characters no symbol needs - use letters, digits, _ ^ {{ }} ' and "
            "LaTeX commands"
        )
    unknown = sorted(set(re.findall(r"\\([A-Za-z]+)", symbol)) - _COMMANDS)
    if unknown:
        return f"unknown LaTeX command \\{unknown[0]} - {did_you_mean(unknown[0], _COMMANDS)}"
    if not _is_complete(symbol):
        return f"{symbol!r} is incomplete - close every brace, give every _ and ^ one thing"
    return None


def _is_complete(symbol: str) -> bool:
    """Whether braces close, every script and every command has what it acts on, and no script comes
    twice.
    """
    depths = [symbol[:end].count("{") - symbol[:end].count("}") for end in range(len(symbol) + 1)]
    fractions = len(re.findall(r"\\frac\{[^{}]+\}\{", symbol))
    return (
        min(depths) == depths[-1] == 0
        and not _DANGLING.search(symbol)
        and not _TWICE.search(symbol)
        and fractions == symbol.count("\\frac")
    )
