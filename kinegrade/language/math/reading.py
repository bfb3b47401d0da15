r"""LaTeX math, read once into its tree, whoever prints it.

What one writer cannot write is refused for all of them: every formula that is read can be printed
by every press and shown by every page.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from msgspec import Struct
from msgspec.structs import replace

from kinegrade.errors import TypesetError
from kinegrade.language.lines import shorten
from kinegrade.language.math.letters import FUNCTIONS, GREEK, SIGNS
from kinegrade.language.math.tokens import (
    ACCENTS,
    BRACKETS,
    ENVIRONMENTS,
    FRACTIONS,
    SPACES,
    STYLES,
    TokenCursor,
    ends_row,
    find_environment,
    find_token_faults,
    is_words,
    split_tokens,
)
from kinegrade.language.math.tree import (
    PRIME,
    Accent,
    Environment,
    Fenced,
    Function,
    Group,
    Letter,
    Lettering,
    LineBreak,
    Mark,
    Node,
    Number,
    Quotient,
    Root,
    Row,
    Scripts,
    Sign,
    Space,
    Text,
    Unit,
    carries_scripts,
)
from kinegrade.language.message import Fault, Location, Message

_DEEPEST = 40  # levels of braces and arguments; a formula of an exam has five
_TOO_DEEP = Message("typesetting.too-deep", most=_DEEPEST)
_SCRIPTS = frozenset(("_", "^", "'"))
_NO_ATOM = _SCRIPTS | {"&", r"\\", r"\\{}"}
_WHOLE = Message("typesetting.not-whole")
_STRAY = Message("typesetting.right-alone")
_MISSING = {
    r"\right": Message("typesetting.left-alone"),
    "]": Message("typesetting.root-open"),
}


def read_math(latex: str, where: Location) -> Row:
    r"""The tree of LaTeX math without dollar signs.

    Raises TypesetError with every fault of the formula, each naming `where`.

    >>> read_math("v_B", "q1")
    (Scripts(base=Letter(name='v'), lower=(Letter(name='B'),), primes=0, upper=None),)
    """
    read = _read(latex)
    if read.faults:
        place = write_formula_place(latex, where)
        raise TypesetError(*(Fault(place, fault) for fault in read.faults))
    return read.row


def write_formula_place(latex: str, where: Location) -> Message:
    """How a message names a formula, cut if it is long."""
    return Message("typesetting.formula", where=where, formula=shorten(latex))


class _Formula(Struct, frozen=True):
    """The tree of a formula, or its faults."""

    row: Row
    faults: tuple[Message, ...] = ()


class _Refused(Exception):
    """Why a formula cannot be read to its end."""

    def __init__(self, fault: Message) -> None:
        self.fault = fault
        super().__init__()


@lru_cache(maxsize=8192)
def _read(latex: str) -> _Formula:
    """The same wherever it is used, so that the papers of a class share it."""
    tokens = split_tokens(latex)
    faults = tuple(find_token_faults(tokens))
    if faults:
        return _Formula((), faults)
    try:
        return _Formula(_Reader(tokens).whole())
    except _Refused as refusal:
        return _Formula((), (refusal.fault,))


class _Reader:
    """One formula, token by token."""

    def __init__(self, tokens: Sequence[str]) -> None:
        self._tokens = TokenCursor(tokens)
        self._depth = 0

    def whole(self) -> Row:
        """The whole formula."""
        return self._row("")

    def _row(self, closing: str) -> Row:
        """Everything up to `closing`, which is passed, or to the end of what is around."""
        self._deepen()
        row = []
        while self._tokens.peek() != closing and not ends_row(self._tokens.peek()):
            row.append(self._scripted())
        found = self._tokens.take()
        if found != closing:
            raise _Refused(_STRAY if found == r"\right" else _MISSING.get(closing, _WHOLE))
        self._depth -= 1
        return tuple(row)

    def _deepen(self) -> None:
        self._depth += 1
        if self._depth > _DEEPEST:
            raise _Refused(_TOO_DEEP)

    def _scripted(self) -> Node:
        """An atom with what stands below and above it."""
        if self._tokens.peek() in _SCRIPTS:
            return self._read_scripts(None)
        digits = self._tokens.take_number()
        node = Number(digits) if digits else self._atom()
        if self._tokens.peek() in _SCRIPTS and carries_scripts(node):
            return self._read_scripts(None if node == Group(()) else node)
        return node

    def _read_scripts(self, base: Node | None) -> Scripts:
        depth = self._depth
        scripts = Scripts(base, None, 0, None)
        while self._tokens.peek() in _SCRIPTS:
            scripts = self._add_script(scripts, self._tokens.take())
        self._depth = depth
        return scripts

    def _add_script(self, scripts: Scripts, sign: str) -> Scripts:
        if sign == "'":
            return replace(scripts, primes=scripts.primes + 1)
        argument = self._argument(sign)
        if sign == "_":
            return replace(self._free(scripts, scripts.lower), lower=argument)
        if argument and all(each == PRIME for each in argument):
            return replace(scripts, primes=scripts.primes + len(argument))
        return replace(self._free(scripts, scripts.upper), upper=argument)

    def _free(self, scripts: Scripts, taken: Row | None) -> Scripts:
        """Scripts with a free place: around those whose place is taken, if it is."""
        if taken is None:
            return scripts
        self._deepen()
        return Scripts(Group((scripts,)), None, 0, None)

    def _argument(self, command: str) -> Row:
        """What a command acts on: a group, or one atom."""
        token = self._tokens.peek()
        if token == "{":
            self._tokens.take()
            return self._row("}")
        if token in _NO_ATOM or ends_row(token):
            raise _Refused(Message("typesetting.nothing-after", command=command))
        self._deepen()
        atom = self._atom()
        self._depth -= 1
        return (atom,)

    def _atom(self) -> Node:
        """A letter, a digit, a sign, a group, or a command with its arguments."""
        token = self._tokens.take()
        if token == "{":
            return Group(self._row("}"))
        if token == "&":
            return Mark()
        if is_words(token):
            words = token[token.index("{") + 1 : -1]
            return Unit(words) if token.startswith(r"\unit") else Text(words)
        if token in SIGNS:
            return Sign(token)
        if token.startswith("\\"):
            return self._command(token)
        return Number(token) if token.isdigit() else Letter(token)

    def _command(self, token: str) -> Node:
        name = token.removeprefix("\\")
        if name in GREEK:
            return Letter(name)
        if name in FUNCTIONS:
            return Function(name)
        if name in SPACES:
            return Space(SPACES[name])
        if name in STYLES:
            return Lettering(STYLES[name], self._argument(token))
        if name in ACCENTS:
            return Accent(ACCENTS[name], self._argument(token))
        if name in FRACTIONS:
            return Quotient(FRACTIONS[name], self._argument(token), self._argument(token))
        return self._structure(token)

    def _structure(self, token: str) -> Node:
        """What has a beginning and an end; the end of a line."""
        environment = find_environment(token)
        if environment is not None:
            return Environment(ENVIRONMENTS[environment], self._row(rf"\end{{{environment}}}"))
        match token:
            case r"\sqrt":
                return self._root()
            case r"\left":
                left = self._bracket(token)
                return Fenced(left, self._row(r"\right"), self._bracket(r"\right"))
            case _:
                return LineBreak()

    def _root(self) -> Root:
        if self._tokens.peek() != "[":
            return Root(self._argument(r"\sqrt"), None)
        self._tokens.take()
        degree = self._row("]")
        return Root(self._argument(r"\sqrt"), degree)

    def _bracket(self, command: str) -> str:
        bracket = self._tokens.take()
        if bracket not in BRACKETS:
            raise _Refused(Message("typesetting.no-bracket", command=command))
        return bracket
