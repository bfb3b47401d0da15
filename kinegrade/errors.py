"""The family of errors: every message states where - what - what was expected - what to do, in one
line.

Bad input raises one of these and nothing else; the command line prints each problem on its own line
and ends with status 2. An error may carry several problems, because all faults of a file are
reported at once.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TypeAlias

from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import (
    Fault,
    Message,
    Part,
    Quoted,
    Text,
    list_choices,
    list_first,
)

_SUGGESTIONS = 3  # names that a hint suggests for a wrong one
# What people say for names that are known, where these are what was asked for
EVERYDAY: Mapping[str, str] = {
    "above": "upper",
    "below": "lower",
    "rightmost": "right",
    "leftmost": "left",
    "right": "+x",
    "left": "-x",
    "up": "+y",
    "down": "-y",
    "counterclockwise": "ccw",
    "clockwise": "cw",
    "speed": "magnitude",
    "norm": "magnitude",
    "angular_velocity": "omega",
    "angular_acceleration": "alpha",
}
_LISTING = "kinegrade words"
_LISTED = 8  # a hint lists all known names up to this many: of more, only the nearest


Problem: TypeAlias = Text | Fault


class KinegradeError(Exception):
    """Something a person can fix; `faults` holds what is wrong, a line each and each once, to be
    said in any language.

    >>> str(KinegradeError(Fault("bank.toml", "no title"), Fault("bank.toml", "no questions")))
    'bank.toml: no title\\nbank.toml: no questions'
    """

    def __init__(self, *faults: Problem) -> None:
        self.faults = tuple(dict.fromkeys(faults))
        super().__init__(*self.faults)

    @property
    def problems(self) -> tuple[str, ...]:
        """The faults in English, a line each: for logs and tests; people read `faults`, written in
        their language.
        """
        return tuple(map(open_catalogue(ENGLISH).write, self.faults))

    def faults_at(self, where: Text) -> tuple[Fault, ...]:
        """The faults as faults of what stands at a place.

        >>> str(KinegradeError(*KinegradeError("no unit").faults_at("asks.v_B")))
        'asks.v_B: no unit'
        """
        return tuple(Fault(where, fault) for fault in self.faults)

    def __str__(self) -> str:
        return "\n".join(self.problems)


class ExpressionError(KinegradeError):
    """An arithmetic expression that cannot be read or evaluated."""


class SyntaxFault(KinegradeError):
    """A text that breaks the syntax of its file; `line` is the line of the error, counted from 1,
    or None where the parser names none.
    """

    def __init__(self, problem: Problem, line: int | None = None) -> None:
        self.line = line
        super().__init__(problem)


class TomlError(SyntaxFault):
    """A text that is not TOML; the message names the error."""


class JsonError(SyntaxFault):
    """A text that is not JSON; the message names the error."""


class FieldError(KinegradeError):
    """A value that is not what its key needs: what was found, what was expected, what to do."""

    def __init__(self, what: Problem, expected: Text = "", do: Text = "") -> None:
        self.what, self.expected, self.do = what, expected, do
        super().__init__(Fault("", what, expected, do))

    def __reduce__(self) -> tuple[type[FieldError], tuple[Problem, Text, Text]]:
        return type(self), (self.what, self.expected, self.do)


class OptionError(KinegradeError):
    """An option has a value that is none of those it may have, or contradicts another option."""


class TemplateError(KinegradeError):
    """A template file, or a value given for one of its parameters, is faulty."""


class NoSuchAsk(TemplateError, KeyError):
    """An answer is looked up by a name that the template does not ask for."""


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


class InstallationError(KinegradeError):
    """A package that a command needs is not installed."""


class ExportError(KinegradeError):
    """A quiz, or grades, cannot be expressed in the format of another system."""


def suggest(word: str, choices: Iterable[str]) -> Message:
    """A closing hint for an unknown word: the nearest known ones, and all of them if they are few.

    >>> english = open_catalogue(ENGLISH)
    >>> english.write(suggest("phy", ["phi", "omega"]))
    'did you mean "phi"? (known here: omega, phi)'
    >>> english.write(suggest("theta_1", [f"theta_{number}" for number in range(2, 60)]))
    'did you mean "theta_51", "theta_41" or "theta_31"?'
    """
    known = sorted(choices)
    near = find_nearest(word, known)
    if len(known) > _LISTED and near:
        return Message("grammar.did-you-mean", names=list_choices(map(Quoted, near)))
    names = _list_names(known)
    if not near:
        return Message("grammar.known", names=names)
    return Message("grammar.did-you-mean-of", name=Quoted(near[0]), names=names)


def _list_names(known: Sequence[str]) -> Part:
    if not known:
        return Message("grammar.no-names")
    return list_first(known, _LISTED if len(known) <= _LISTED else _SUGGESTIONS)


def find_nearest(word: str, choices: Iterable[str]) -> list[str]:
    """The choices that a word probably stands for, the nearest first; a few, or none.

    >>> find_nearest("0O7", ["007", "0012"])
    ['007']
    """
    from difflib import get_close_matches  # only refusals need it, and it would slow every start

    known = sorted(choices)
    same = [name for name in known if name.lower() in {word.lower(), EVERYDAY.get(word.lower())}]
    return same or get_close_matches(word, known, n=_SUGGESTIONS)


def suggest_examples(word: str, examples: Mapping[str, str], group: str) -> Message:
    """A closing hint for an unknown word: the three nearest known ones by an example of each, and
    the group of `kinegrade words` that lists them all.

    >>> english = open_catalogue(ENGLISH)
    >>> english.write(suggest_examples("velo", {"velocity": "velocity(B)"}, "quantities"))
    'did you mean "velocity(B)"? (all of them: kinegrade words quantities)'
    """
    from difflib import get_close_matches  # as above

    meant = EVERYDAY.get(word.lower(), "")
    near = [meant] if meant in examples else get_close_matches(word, examples, _SUGGESTIONS, 0.0)
    names = list_choices(_quote(examples[name]) for name in near)
    return Message("grammar.did-you-mean-like", names=names, command=f"{_LISTING} {group}")


def _quote(example: str) -> Part:
    """An example between quotation marks, where it has none itself."""
    return example if '"' in example else Quoted(example)


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
