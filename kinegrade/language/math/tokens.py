r"""LaTeX math, token by token, and the faults of single tokens: what no writer lets through.

The list of commands is closed. Refused are also comments (`%`), characters by their codes (`^^5c`
is a backslash to TeX), and characters that are code in one of the languages that are written.
`reading` is the next storey up.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from difflib import get_close_matches
from itertools import pairwise
from typing import get_args

from kinegrade.language.math.letters import FUNCTIONS, GREEK, SIGNS
from kinegrade.language.math.tree import (
    AccentName,
    EnvironmentName,
    FractionName,
    SpaceName,
    Style,
)
from kinegrade.language.message import Message, list_choices

ENVIRONMENTS: dict[str, EnvironmentName] = {name: name for name in get_args(EnvironmentName)}
FRACTIONS: dict[str, FractionName] = {name: name for name in get_args(FractionName)}
SPACES: dict[str, SpaceName] = {name: name for name in get_args(SpaceName)}
ACCENTS: dict[str, AccentName] = {name: name for name in get_args(AccentName)}
STYLES: dict[str, Style] = {name: name for name in get_args(Style)} | {"bm": "boldsymbol"}
BRACKETS = frozenset(("(", ")", "[", "]", "|", ".", r"\{", r"\}", r"\|"))  # "." for none
_SIGN_COMMANDS = (sign.removeprefix("\\") for sign in SIGNS if sign.startswith("\\"))
_KNOWN = frozenset(
    (
        *GREEK,
        *FUNCTIONS,
        *_SIGN_COMMANDS,
        *FRACTIONS,
        *SPACES,
        *ACCENTS,
        *STYLES,
        "sqrt",
        "left",
        "right",
        "begin",
        "end",
        "\\",
    )
)
COMMANDS = frozenset(name for name in _KNOWN if name.isalpha())
_TOKEN = re.compile(
    r"\\(?:text|unit)\s*\{[^{}]*\}"  # words, whatever they hold
    r"|\{,\}"  # LaTeX's decimal comma
    r"|\\(?:begin|end)\{[^{}]*\}"
    r"|\\\\(?:\{\})?"
    r"|\\(?:[A-Za-z]+|.|$)"
    r"|//|/\*"
    r"|\s+|.",
    re.DOTALL,
)
_ENVIRONMENT = re.compile(r"\\(?:begin|end)\{([^{}]*)\}")
_WORDS = re.compile(r"\\(?:text|unit)\s*\{")
_FORBIDDEN = re.compile(r'[#"$@`~]|//|/\*|[^\x00-\x7f]')


def split_tokens(latex: str) -> tuple[str, ...]:
    r"""The tokens of a formula without its blanks.

    >>> split_tokens(r"v_B = 2\,\unit{m/s}")
    ('v', '_', 'B', '=', '2', '\\,', '\\unit{m/s}')
    """
    return tuple(token for token in _TOKEN.findall(latex) if not token.isspace())


class TokenCursor:
    """The tokens of a formula, one after the other; "" is after the last."""

    def __init__(self, tokens: Sequence[str]) -> None:
        self._tokens = (*tokens, "")
        self._place = 0

    def peek(self) -> str:
        """The token that is next."""
        return self._tokens[self._place]

    def take(self) -> str:
        """The next token, which is passed."""
        token = self.peek()
        if token:
            self._place += 1
        return token

    def take_number(self) -> str:
        """The digits that are next, with a decimal point if digits follow it."""
        digits = self._take_digits()
        if digits and self.peek() == "." and self._tokens[self._place + 1].isdigit():
            self._place += 1
            digits += "." + self._take_digits()
        return digits

    def _take_digits(self) -> str:
        digits = ""
        while self.peek().isdigit():
            digits += self.take()
        return digits


def is_words(token: str) -> bool:
    r"""Whether a token is a whole `\text{...}` or `\unit{...}`."""
    return _WORDS.match(token) is not None


def ends_row(token: str) -> bool:
    """Whether nothing of a row can follow."""
    return token in ("", "}", r"\right") or token.startswith(r"\end{")


def find_environment(token: str) -> str | None:
    r"""The name of the environment that `\begin{...}` or `\end{...}` names; None for all else."""
    found = _ENVIRONMENT.fullmatch(token)
    return found[1] if found else None


def find_token_faults(tokens: Sequence[str]) -> Iterator[Message]:
    """What is wrong with single tokens, in their order, and with the number of braces."""
    for token in tokens:
        yield from _find_fault(token)
    if any(pair == ("^", "^") for pair in pairwise(tokens)):
        yield Message("typesetting.raised-twice")
    if not _is_balanced(tokens):
        yield Message("typesetting.braces")


def _find_fault(token: str) -> Iterator[Message]:
    environment = find_environment(token)
    if is_words(token) or environment in ENVIRONMENTS:
        return
    if environment is not None:
        known = list_choices(sorted(ENVIRONMENTS))
        yield Message("typesetting.unknown-environment", name=environment, known=known)
    elif token in (r"\begin", r"\end"):
        yield Message("typesetting.bare-environment")
    elif token.startswith("\\"):
        yield from _find_unknown(token.removeprefix("\\").removesuffix("{}"))
    elif token == "%":
        yield Message("typesetting.comment")
    elif _FORBIDDEN.fullmatch(token) or not token.isprintable():
        shown = token if token.isprintable() else repr(token)
        yield Message("typesetting.no-math", text=shown)


def _find_unknown(name: str) -> Iterator[Message]:
    if name not in _KNOWN:
        near = get_close_matches(name, COMMANDS, n=1)
        hint = Message("typesetting.other-commands")
        if near:
            hint = Message("typesetting.near-command", name=near[0])
        yield Message("typesetting.unknown-command", name=name, hint=hint)


def _is_balanced(tokens: Sequence[str]) -> bool:
    depth = 0
    for token in tokens:
        depth += {"{": 1, "}": -1}.get(token, 0)
        if depth < 0:
            return False
    return depth == 0
