"""Claims of circles by their radii and diameters, in the statement and in what givens mean."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

from kinegrade.figure.plane import length
from kinegrade.language.message import Fault, Message
from kinegrade.numbers.floats import Floats
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Parameter, Template
from kinegrade.proof.claims.patterns import list_words
from kinegrade.proof.claims.reading import DIFFERENT, read_claims

_OTHERS = {"diameter": "radius", "radius": "diameter"}
_SHARES = {"diameter": 0.5, "radius": 1.0}  # of the size that is said, the radius


@dataclass(frozen=True)
class _Sizes:
    """The values of a given length in some instances, in metres, beside their circles and bars."""

    template: Template
    given: Parameter
    values: Sequence[float]
    examples: Sequence[Solution]

    def is_a(self, kind: str) -> bool:
        """Whether a circle of every instance has this radius or diameter."""
        circles = [_list_radii(self.template, each) for each in self.examples]
        return self._is_among(circles, _SHARES[kind])

    def judge(self, place: str, kind: str, said: str) -> Iterator[Fault]:
        """That words at a place say one of radius and diameter where it is the other."""
        if not self.is_a(kind) and self.is_a(_OTHERS[kind]):
            yield Fault(place, Message(f"template.said-{kind}", said=said, name=self.given.name))

    def find_bar(self) -> str:
        """Two points of one body that are so far apart in every instance; none where none are."""
        for body in self.template.scheme.bodies:
            for start, end in combinations(body.points, 2):
                points = [each.doubles.points for each in self.examples]
                if self._is_among([[length(at[end] - at[start])] for at in points], 1.0):
                    return start + end
        return ""

    def _is_among(self, sizes: Sequence[Sequence[float]], share: float) -> bool:
        """Whether a share of each value is one of the sizes of its instance."""
        return bool(self.values) and all(
            any(abs(size - share * value) <= DIFFERENT * value for size in known)
            for value, known in zip(self.values, sizes, strict=True)
        )


def find_wrong_circles(template: Template, examples: Sequence[Solution]) -> Iterator[Fault]:
    """`of diameter {{ r }}` where r is the radius of a circle, or the other way round."""
    lengths = _measure_lengths(template, examples)
    for kind, other in _OTHERS.items():
        for claim in read_claims(template, kind):
            if claim["given"] in lengths:
                yield from lengths[claim["given"]].judge("statement", kind, claim["said"])
                yield from _judge_bars(lengths[claim["given"]], kind, claim["said"])
        for name, sizes in lengths.items():
            for said in template.parameters[name].means.texts:
                if _names(said, kind) and not _names(said, other):
                    yield from sizes.judge(f"parameters.{name}.means", kind, said)


def _judge_bars(sizes: _Sizes, kind: str, said: str) -> Iterator[Fault]:
    """That what is called a diameter is the length of a bar alone, by its meaning too."""
    means = " ".join(sizes.given.means.texts)
    if kind != "diameter" or _names(means, kind) or any(map(sizes.is_a, _OTHERS)):
        return
    bar = sizes.find_bar()
    if bar:
        what = Message("template.diameter-of-bar", said=said, name=sizes.given.name, bar=bar)
        yield Fault("statement", what)


def note_radii_of_bars(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """A remark for each given that is called a radius and is the length of a bar alone."""
    for name, sizes in _measure_lengths(template, examples).items():
        said = " ".join(template.parameters[name].means.texts)
        if _names(said, "radius") and not _names(said, "radius-of-no-circle"):
            bar = "" if any(map(sizes.is_a, _OTHERS)) else sizes.find_bar()
            if bar:
                yield Message("template.radius-of-bar", name=name, bar=bar)


def _measure_lengths(template: Template, examples: Sequence[Solution]) -> Mapping[str, _Sizes]:
    """The given lengths in some instances."""
    return {
        name: _Sizes(
            template,
            given,
            [
                abs(each.parameters[name].value) * Floats().scale(given.unit.scale)
                for each in examples
            ],
            examples,
        )
        for name, given in template.parameters.items()
        if given.unit.is_length
    }


def _names(said: str, kind: str) -> bool:
    """Whether words name a kind, in whatever language."""
    return any(word in said.lower() for word in list_words(f"a-{kind}"))


def _list_radii(template: Template, example: Solution) -> list[float]:
    """The radii of all circles of an instance, those of its joints and of its figure, in metres."""
    joints, at = example.assembly.mechanism.map(float).joints, example.doubles.points
    rims = template.figure.circles
    return [
        *(circle.radius for joint in joints for circle in joint.list_circles()),
        *(length(at[each.through] - at[each.centre]) for each in rims),
    ]
