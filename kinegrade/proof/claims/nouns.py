"""What nouns stand for by the statement, the names of bodies and the inputs: the rocker of `the
rocker $CB$` is CB.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from kinegrade.expressions.tree import find_names
from kinegrade.mechanics.ground import GROUND
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.patterns import LETTER, list_words, write_words
from kinegrade.proof.claims.reading import find_points, read_texts

_NAMED = r"\$([A-Za-z]+|(?:LETTER)+)\$".replace("LETTER", LETTER)
_ENDING = 2  # letters that a declined noun may have behind its stem
_LONG = 4  # letters of a noun that is declined


@dataclass(frozen=True)
class Thing:
    """What a noun stands for: a body, or points by their letters."""

    body: str = ""
    points: frozenset[str] = frozenset()


@dataclass(frozen=True)
class Nouns:
    """The nouns of a template."""

    template: Template

    def read_nouns(self, text: str) -> Iterator[tuple[str, Sequence[Thing]]]:
        """`of the rocker`: the words of a text that name something, with all that it may be."""
        for claim in read_texts([text], "of-noun"):
            words = claim["noun"].split()
            for count in range(len(words), 0, -1):
                things = [*self.find_things(" ".join(words[:count]))]
                if things:
                    yield claim["said"], things
                    break

    def find_things(self, noun: str) -> Iterator[Thing]:
        """All that a noun may stand for; nothing for one that says little, as point."""
        if noun.lower() in {*list_words("generic")}:
            return
        for body in self.template.scheme.bodies:
            if body.name.lower() == noun.lower():
                yield Thing(body.name)
        for text in self.template.words.statement.texts:
            for match in _write_named(noun).finditer(text):
                yield from self._find_named(match["named"])
        yield from self._driven.get(noun.lower(), ())

    def _find_named(self, named: str) -> Iterator[Thing]:
        """What letters between dollar signs stand for, all of a list of them."""
        for letters in re.findall(_NAMED, named):
            for body in self.template.scheme.bodies:
                if body.name == letters:
                    yield Thing(body.name)
            points = find_points(self.template, *re.findall(LETTER, letters))
            if points:
                yield Thing(points=frozenset(points))

    @cached_property
    def _driven(self) -> Mapping[str, Sequence[Thing]]:
        """What the nouns of givens stand for that drive a body, seen from the ground or from
        another one: the rate of a cylinder is that of its rod in it.
        """
        found: dict[str, list[Thing]] = {}
        for sentence in self.template.scheme.drivers:
            for name in {*find_names(sentence.velocity), *find_names(sentence.acceleration)}:
                given = self.template.parameters.get(name)
                for claim in read_texts(given.means.texts if given else (), "of-noun"):
                    bodies = (name for name in (sentence.body, sentence.of) if name != GROUND)
                    found.setdefault(claim["noun"].lower(), []).extend(map(Thing, bodies))
        return found

    def list_points(self, body: str) -> frozenset[str]:
        """The points of a body, and those of its joints: a rocker is named by the block in its
        slot.
        """
        found = {
            point
            for each in self.template.scheme.bodies
            if each.name == body
            for point in each.points
        }
        for joint in self.template.scheme.joints:
            if body in {joint.body, joint.of, *joint.bodies}:
                found.add(joint.point)
                shapes = (joint.circle, joint.on)
                found |= {name for shape in shapes if shape for name in find_names(shape)}
        return frozenset(found)

    def list_bodies(self, thing: Thing) -> list[str]:
        """The bodies that a thing may be: the one that it names, those of all its letters, and the
        wheel of which it is the centre.
        """
        if thing.body:
            return [thing.body]
        several = len(thing.points) > 1
        bodies = [each.name for each in self.template.scheme.bodies]
        return [each for each in bodies if several and thing.points <= self.list_points(each)] or [
            joint.body
            for joint in self.template.scheme.joints
            if joint.circle and thing.points & {*find_names(joint.circle)} and not several
        ]

    def belongs(self, thing: Thing, names: Sequence[str]) -> bool:
        """Whether a quantity of these points and bodies is one of the thing."""
        bodies = self.list_bodies(thing)
        own = frozenset().union(thing.points, *map(self.list_points, bodies))
        rates = [
            self.list_points(name) for name in names if name not in self.template.scheme.points
        ]
        return any(name in own or name in bodies for name in names) or (
            not thing.body and any(thing.points <= each for each in rates)
        )


def _write_named(noun: str) -> re.Pattern[str]:
    """A noun before letters between dollar signs, declined, and a list of them."""
    stem = re.sub("(?:es|en|s|n|e)$", "", noun) if len(noun) > _LONG else noun
    ending = rf"\w{{0,{_ENDING}}}" if noun[0].isascii() else ""
    start = r"(?<![\w-])" if noun[0].isascii() else ""
    more = rf"(?:\s*(?:{write_words('listed')})\s*{_NAMED})*"
    return re.compile(rf"(?i:{start}{re.escape(stem)}{ending})\s*(?P<named>{_NAMED}{more})")
