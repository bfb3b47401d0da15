"""What asks mean in words against their quantities: another point or body, the other sense."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain, combinations

from kinegrade.expressions.tree import find_names
from kinegrade.figure.plane import length
from kinegrade.language.message import Fault, Message, Quoted, list_plainly
from kinegrade.numbers.floats import Floats
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.driven import find_driven
from kinegrade.problem.template.meaning.senses import find_positive
from kinegrade.problem.template.template import Ask, Parameter, Template
from kinegrade.proof.claims.nouns import Nouns
from kinegrade.proof.claims.patterns import find_words
from kinegrade.proof.claims.reading import DIFFERENT, find_points, name_senses, read_texts
from kinegrade.sign_conventions import OPPOSITE, Convention

# "The height above O", "to the left of O": no property of O
_NO_SUBJECT = (
    "(?<![到过绕距于对出] )(?<![到过绕距于对出])(?<!left )(?<!right )(?<!links )(?<!rechts )"
)


def find_wrong_means(template: Template, examples: Sequence[Solution]) -> Iterator[Fault]:
    """A fault for each ask whose words name another point or body than its quantity, or the sense
    opposite to the one in which it is positive, for each given whose words name another sense than
    that in which it drives, and for each length that is said to be another's.
    """
    for name, given in template.parameters.items():
        if given.unit.is_length:
            found = _find_other_lengths(template, given, examples)
            yield from (Fault(f"parameters.{name}.means", what) for what in found)
    for name, what in _find_other_drives(template):
        yield Fault(f"parameters.{name}.means", what)
    for name, ask in template.asks.items():
        place = f"asks.{name}.means"
        yield from (Fault(place, what) for what in _find_others(template, ask))
        yield from (Fault(place, what) for what in _find_other_senses(ask))
        yield from (Fault(place, what) for what in _find_other_parts(ask))


def _find_others(template: Template, ask: Ask) -> Iterator[Message]:
    """`velocity of $B$` of a quantity that has nothing to do with B."""
    names = [name for name in find_names(ask.quantity) if name not in template.parameters]
    nouns = Nouns(template)
    groups = [nouns.list_points(name) for name in names if name not in template.scheme.points]
    groups.append(frozenset(name for name in names if name in template.scheme.points))
    for text in ask.means.texts:
        named = {}
        for claim in read_texts([text], "subject", _NO_SUBJECT):
            letters = [claim[part] for part in ("point", "start", "end") if claim.get(part)]
            points = find_points(template, *letters)
            if points:
                named[claim["said"]] = any({*points} <= group for group in groups)
        for said, things in nouns.read_nouns(text):
            named[said] = any(nouns.belongs(thing, names) for thing in things)
        if named and not any(named.values()):
            own = list_plainly(dict.fromkeys(names))
            yield Message("template.means-another", said=next(iter(named)), own=own)


def _find_other_senses(ask: Ask) -> Iterator[Message]:
    """`, downwards` of a quantity that is positive upwards."""
    positive = find_positive(ask)
    for claim in read_texts(ask.means.texts, "sense-meant"):
        if positive and name_senses(claim["sense"]) == {OPPOSITE[positive]}:
            said = claim["said"].strip(",(，（ ")
            yield Message("template.sign-other-way", said=said, sign=Quoted(positive))


def _find_other_drives(template: Template) -> Iterator[tuple[str, Message]]:
    """By given `, clockwise` of one, never negative, that drives counter-clockwise alone."""
    for name, senses in _list_drives(template).items():
        given = template.parameters[name]
        if len(senses) > 1 or any(choice.startswith("-") for choice in given.choices):
            continue
        opposite = {OPPOSITE[sense] for sense in senses}
        for claim in read_texts(given.means.texts, "sense-meant"):
            if name_senses(claim["sense"]) == opposite:
                said = claim["said"].strip(",(，（ ")
                yield name, Message("template.drives-other-way", said=said)


def _list_drives(template: Template) -> Mapping[str, set[Convention]]:
    """By given the senses in which it drives what it is a rate of."""
    senses: dict[str, set[Convention]] = defaultdict(set)
    driven = find_driven(template.scheme.drivers, template.parameters)
    for each in chain.from_iterable(named.values() for named in driven.values()):
        for rate in filter(None, (each.velocity, each.acceleration)):
            senses[rate.given].add(OPPOSITE[each.positive] if rate.turned else each.positive)
    return senses


def _find_other_parts(ask: Ask) -> Iterator[Message]:
    """`vertical component` of the component along the x axis."""
    axis = (find_positive(ask) or "")[1:]
    for other, kind in (("x", "vertical-part"), ("y", "horizontal-part")):
        said = [word for text in ask.means.texts for word in find_words(kind, text)]
        if axis == other and said:
            yield Message("template.means-other-part", said=said[0], axis=axis)


def _find_other_lengths(
    template: Template, given: Parameter, examples: Sequence[Solution]
) -> Iterator[Message]:
    """`length of the rocker` of a given that is the length of the crank alone."""
    nouns = Nouns(template)
    bars = {
        start + end: {body.name}
        for body in template.scheme.bodies
        for start, end in combinations(body.points, 2)
        if examples and all(_is_distance(each, given, start, end) for each in examples)
    }
    for text in given.means.texts if bars else ():
        if not find_words("a-length", text.lower()):
            continue
        for said, things in nouns.read_nouns(text):
            named = [name for thing in things for name in nouns.list_bodies(thing)]
            if named and not {*named} & {*chain(*bars.values())}:
                yield Message(
                    "template.length-of-another",
                    said=said,
                    named=list_plainly(dict.fromkeys(named)),
                    name=given.name,
                    bar=next(iter(bars)),
                )


def _is_distance(each: Solution, given: Parameter, start: str, end: str) -> bool:
    """Whether a given length is the distance of two points in an instance."""
    at = each.doubles.points
    value = abs(each.parameters[given.name].value) * Floats().scale(given.unit.scale)
    return abs(length(at[end] - at[start]) - value) <= DIFFERENT * value
