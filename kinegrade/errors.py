"""The family of errors: every message says where - what - what was expected - what to do, in one line.

Bad input raises one of these and nothing else; the command line prints each problem on its own line and
ends with status 2. An error may carry several problems, because all faults of a file are reported at once.
"""

from __future__ import annotations

from collections.abc import Iterable


class KinegradeError(Exception):
    """Something a person can mend; `problems` holds one line for each fault.

    >>> str(KinegradeError("bank.toml: no title", "bank.toml: no questions"))
    'bank.toml: no title\\nbank.toml: no questions'
    """

    def __init__(self, *problems: str) -> None:
        self.problems = tuple(problems)
        super().__init__("\n".join(problems))


class ExpressionError(KinegradeError):
    """An arithmetic expression that cannot be read or evaluated."""


class TemplateError(KinegradeError):
    """A template file, or a value given for one of its parameters, is at fault."""


class MechanismError(KinegradeError):
    """The mechanism cannot be assembled, is loose, is contradictory or stands at a dead point."""


class AtInfinity(MechanismError):
    """A point that is asked for lies at infinity, such as the velocity pole of a body that does not turn."""


class DrawError(KinegradeError):
    """No acceptable instance could be drawn."""


class BankError(KinegradeError):
    """An exam blueprint is at fault."""


class PolicyError(KinegradeError):
    """A policy by which answers are to be marked is at fault."""


class TableError(KinegradeError):
    """A CSV file (roster or answers) cannot be used at all."""


class ExamError(KinegradeError):
    """An exam folder is missing, incomplete or at fault."""


class OutputError(KinegradeError):
    """An output cannot be written where it was asked for."""


class TypesetError(KinegradeError):
    """A page cannot be typeset faithfully."""


class ExportError(KinegradeError):
    """A quiz, or grades, cannot be said in the format that another system takes."""


def did_you_mean(word: str, choices: Iterable[str]) -> str:
    """A closing hint for an unknown word: the nearest known one, or all known ones.

    >>> did_you_mean("phy", ["phi", "omega"])
    'did you mean "phi"? (known here: omega, phi)'
    """
    from difflib import get_close_matches  # only refusals need it, and it would slow every start

    known = sorted(choices)
    near = [name for name in known if name.lower() == word.lower()] or get_close_matches(
        word, known, n=1
    )
    listing = ", ".join(known) if known else "none"
    return (
        f'did you mean "{near[0]}"? (known here: {listing})' if near else f"known here: {listing}"
    )


def one_line(text: str) -> str:
    """A text from a file as a message can hold it: what does not print is shown by a dot.

    >>> one_line("1 +\\n2")
    '1 +·2'
    """
    return "".join(letter if letter.isprintable() else "·" for letter in text)
