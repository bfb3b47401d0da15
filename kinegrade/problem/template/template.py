"""A problem template: the mechanism as data, its parameters, asks, texts and published results.

`reading` makes these from TOML; `assemble` puts numbers in. A template holds no code.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from msgspec import Struct, field

from kinegrade.expressions.tree import Expression
from kinegrade.mechanics.mechanism import Body
from kinegrade.numbers.units import Unit
from kinegrade.problem.template.beside import Translations
from kinegrade.problem.template.hints import FigureHints
from kinegrade.problem.template.sentences import DriverSentence, JointSentence
from kinegrade.problem.template.signs import Sign
from kinegrade.problem.template.translated import Translated

Method = Literal["base-point", "projection", "pole"]
METHODS: tuple[Method, ...] = ("base-point", "projection", "pole")
Relation = Literal["<", "<=", "==", "!="]


class Parameter(Struct, frozen=True):
    """A quantity that is given: its unit, what may be drawn (exact texts in that unit), its
    published value.
    """

    name: str
    symbol: str
    unit: Unit
    choices: tuple[str, ...]
    published: str | None
    means: Translated

    @property
    def has_sign(self) -> bool:
        """Whether a drawable value is negative."""
        return any(choice.startswith("-") for choice in self.choices)

    @property
    def is_size(self) -> bool:
        """Whether this is a length that no drawable value makes negative, unlike a coordinate."""
        return self.unit.is_length and not self.has_sign

    @property
    def default(self) -> str:
        """The published value, or the first drawable one."""
        return self.published if self.published is not None else self.choices[0]


class Ask(Struct, frozen=True):
    """A quantity that may be asked for: how it follows from the motion, its unit, sign convention
    and weight.

    `points` is 0 for quantities that are asked only when a bank names them; `vanishes` says that
    zero is a proper answer, `cyclic` that an angle is right with up to three full turns more or
    less, as the angle of a position is unless its author denies it.
    """

    name: str
    symbol: str
    quantity: Expression
    unit: Unit
    means: Translated
    sign: Sign
    points: int
    vanishes: bool
    cyclic: bool


class Condition(Struct, frozen=True):
    """left < right (or <=, or ==), in SI: what drawn values must fulfil, or when a text applies."""

    text: str
    left: Expression
    right: Expression
    relation: Relation


class Wording(Struct, frozen=True):
    """A text for the values at which its condition holds; without a condition, for all values that
    are left.
    """

    condition: Condition | None
    text: Translated


class Published(Struct, frozen=True):
    """What the source gives: parameter values, and results as expressions of the parameters."""

    source: str
    given: Mapping[str, str]
    gives: Mapping[str, Expression]
    texts: Mapping[str, str]


class MechanismFile(Struct, frozen=True):
    """A file that holds the mechanism of several templates: its name without `.toml`, its text, and
    those of the translations beside it.
    """

    name: str
    text: str
    translations: Translations = field(default_factory=dict)


class TemplateFile(Struct, frozen=True):
    """A template as it was read, kept with every exam, with the translations beside it; `mechanism`
    where it shares one.
    """

    text: str
    mechanism: MechanismFile | None = None
    translations: Translations = field(default_factory=dict)


class About(Struct, frozen=True):
    """The data by which a template is found and chosen.

    `tags` are the author's words, besides those that follow from what it asks. `method` is how its
    worked solution finds velocities where several methods serve.
    """

    title: Translated
    family: str
    source: str
    tags: tuple[str, ...] = ()
    method: Method | None = None


class NamedMistake(Struct, frozen=True):
    """A mistake that the author of a question knows, by an identifier and a sentence for those who
    make it: what it takes the named steps for.
    """

    identifier: str
    steps: Mapping[str, Expression]
    means: Translated


class Scheme(Struct, frozen=True):
    """The mechanism as written: what is given, and what is made of it, each in the file's order.

    In place of a mechanism there may be `steps`: quantities that follow one from the other, with
    the `mistakes` known in them.
    """

    parameters: Mapping[str, Parameter]
    lengths: Mapping[str, Expression]
    points: Mapping[str, Expression]
    bodies: tuple[Body, ...]
    joints: tuple[JointSentence, ...]
    drivers: tuple[DriverSentence, ...]
    conditions: tuple[Condition, ...]
    steps: Mapping[str, Expression] = field(default_factory=dict)
    mistakes: tuple[NamedMistake, ...] = ()

    @property
    def has_mechanism(self) -> bool:
        """Whether there is something that moves, and a figure of it, rather than steps alone."""
        return not self.steps


class Words(Struct, frozen=True):
    """What students read: the statement, the texts in it that depend on values, why named lengths
    are what they are, which worked solutions say, and what bodies are called.

    Of the wordings of one name the first whose condition holds applies.
    """

    statement: Translated
    texts: Mapping[str, tuple[Wording, ...]]
    reasons: Mapping[str, Translated]
    called: Mapping[str, Translated] = field(default_factory=dict)


class Template(Struct, frozen=True):
    """One mechanism with its questions; `name` is its file's name without `.toml`."""

    name: str
    file: TemplateFile
    about: About
    words: Words
    scheme: Scheme
    asks: Mapping[str, Ask]
    published: tuple[Published, ...]
    figure: FigureHints

    @property
    def parameters(self) -> Mapping[str, Parameter]:
        """The quantities that are given."""
        return self.scheme.parameters

    @property
    def angles(self) -> frozenset[str]:
        """The names of the parameters that are angles."""
        return list_angles(self.parameters)

    @property
    def combinations(self) -> int:
        """How many combinations of drawable values there are."""
        count = 1
        for parameter in self.parameters.values():
            count *= len(parameter.choices)
        return count

    def asked(self) -> tuple[str, ...]:
        """The asks of an exam that names none: those with points."""
        return tuple(name for name, ask in self.asks.items() if ask.points)


def list_angles(parameters: Mapping[str, Parameter]) -> frozenset[str]:
    """The names of those parameters that are angles."""
    return frozenset(
        name
        for name, parameter in parameters.items()
        if parameter.unit.degrees or parameter.unit.text == "rad"
    )
