"""The family of errors: every message states where - what - what was expected - what to do, in one
line.

Bad input raises one of these and nothing else; the command line prints each problem on its own line
and ends with status 2. An error may carry several problems, because all faults of a file are
reported at once.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

_SUGGESTIONS = 3  # names that a hint suggests for a wrong one
_LONGEST_PART = 300  # characters of each part of a message
_LISTED = 8  # a hint lists all known names up to this many: of more, only the nearest


class KinegradeError(Exception):
    """Something a person can fix; `problems` holds one line for each fault.

    >>> str(KinegradeError("bank.toml: no title", "bank.toml: no questions"))
    'bank.toml: no title\\nbank.toml: no questions'
    """

    def __init__(self, *problems: str) -> None:
        self.problems = tuple(problems)
        super().__init__("\n".join(problems))


class ExpressionError(KinegradeError):
    """An arithmetic expression that cannot be read or evaluated."""


class SyntaxFault(KinegradeError):
    """A text that breaks the syntax of its file; `line` is the line of the error, counted from 1,
    or None where the parser names none.
    """

    def __init__(self, problem: str, line: int | None = None) -> None:
        self.line = line
        super().__init__(problem)


class TomlError(SyntaxFault):
    """A text that is not TOML; the message names the error."""


class JsonError(SyntaxFault):
    """A text that is not JSON; the message names the error."""


class FieldError(KinegradeError):
    """A value that is not what its key needs: what was found, what was expected, what to do."""

    def __init__(self, what: str, expected: str = "", do: str = "") -> None:
        self.what, self.expected, self.do = what, expected, do
        super().__init__(write_message("", what, expected, do))


class TemplateError(KinegradeError):
    """A template file, or a value given for one of its parameters, is faulty."""


class MechanismError(KinegradeError):
    """The mechanism cannot be assembled, is loose, is contradictory or is at a dead point."""


class AtInfinity(MechanismError):
    """A requested point is at infinity, such as the velocity pole of a body that does not turn."""


class DrawError(KinegradeError):
    """No acceptable instance could be drawn."""


class BankError(KinegradeError):
    """An exam blueprint is faulty."""


class PolicyError(KinegradeError):
    """A marking policy is faulty."""


class TableError(KinegradeError):
    """A CSV file (roster or answers) cannot be used at all."""


class ExamError(KinegradeError):
    """An exam folder is missing, incomplete or faulty."""


class OutputError(KinegradeError):
    """An output cannot be written at the requested place."""


class TypesetError(KinegradeError):
    """A page cannot be typeset faithfully."""


class WorkerError(KinegradeError):
    """A worker process was ended from outside."""


class ExportError(KinegradeError):
    """A quiz, or grades, cannot be expressed in the format of another system."""


def write_message(where: str, what: str, expected: str = "", do: str = "") -> str:
    """A fault in one line: where it is, what was found, what was expected, what to do.

    >>> write_message("bank.toml:3: points", "0", "a number above zero", "write points = 1")
    'bank.toml:3: points: 0 - expected a number above zero - write points = 1'
    >>> write_message("bank.toml: title", "missing", "a text")
    'bank.toml: title: missing - expected a text'
    """
    place = f"{where}: " if where else ""
    parts = (f"{place}{shorten(what)}", expected and f"expected {expected}", do)
    return " - ".join(shorten(part, 2 * _LONGEST_PART) for part in parts if part)


def did_you_mean(word: str, choices: Iterable[str]) -> str:
    """A closing hint for an unknown word: the nearest known ones, and all of them if they are few.

    >>> did_you_mean("phy", ["phi", "omega"])
    'did you mean "phi"? (known here: omega, phi)'
    >>> did_you_mean("theta_1", [f"theta_{number}" for number in range(2, 60)])
    'did you mean "theta_51", "theta_41" or "theta_31"?'
    """
    known = sorted(choices)
    near = find_nearest(word, known)
    if len(known) > _LISTED and near:
        return f"did you mean {join_alternatives(near)}?"
    listing = ", ".join(known) if known else "none"
    if len(known) > _LISTED:
        listing = f"{', '.join(known[:_SUGGESTIONS])} and {len(known) - _SUGGESTIONS} more"
    if not near:
        return f"known here: {listing}"
    return f'did you mean "{near[0]}"? (known here: {listing})'


def find_nearest(word: str, choices: Iterable[str]) -> list[str]:
    """The choices that a word probably stands for, the nearest first; a few, or none.

    >>> find_nearest("0O7", ["007", "0012"])
    ['007']
    """
    from difflib import get_close_matches  # only refusals need it, and it would slow every start

    known = sorted(choices)
    same = [name for name in known if name.lower() == word.lower()]
    return same or get_close_matches(word, known, n=_SUGGESTIONS)


def find_misspelt(unknown: Iterable[str], missing: Iterable[str]) -> frozenset[str]:
    """The missing names that an unknown one probably stands for: one slip, to be reported once.

    >>> find_misspelt(["titel", "colour"], ["title", "course"])
    frozenset({'title'})
    """
    words, absent = list(unknown), list(missing)
    if not words:
        return frozenset()
    from difflib import get_close_matches  # as above

    return frozenset(near for word in words for near in get_close_matches(word, absent, 1, 0.7))


def join_alternatives(words: Sequence[str]) -> str:
    """Words to choose from, each in quotation marks.

    >>> join_alternatives(["a", "b", "c"])
    '"a", "b" or "c"'
    """
    quoted = [f'"{word}"' for word in words]
    return " or ".join([", ".join(quoted[:-1]), quoted[-1]] if len(quoted) > 1 else quoted)


def show_in_one_line(text: str) -> str:
    """A text from a file as a message shows it: unprintable characters become dots.

    >>> show_in_one_line("1 +\\n2")
    '1 +·2'
    """
    return "".join(letter if letter.isprintable() else "·" for letter in text)


def shorten(text: str, longest: int = _LONGEST_PART) -> str:
    """A text as a part of a one-line message, cut where it is too long.

    >>> shorten("a very long text", 10)
    'a very lo…'
    """
    line = show_in_one_line(text)
    return line if len(line) <= longest else f"{line[: longest - 1]}…"
