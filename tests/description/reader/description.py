"""A description as a whole: all that its sentences tell."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from tests.description.reader.condition_sentences import CONDITION_PATTERNS
from tests.description.reader.drawing_sentences import DRAWING_PATTERNS
from tests.description.reader.drive_sentences import DRIVE_PATTERNS
from tests.description.reader.drives import Drive
from tests.description.reader.joint_sentences import JOINT_PATTERNS
from tests.description.reader.joints import Joint
from tests.description.reader.lines import MATH
from tests.description.reader.names import ATOM, plain
from tests.description.reader.places import Construction, Equation, Side
from tests.description.reader.sentences import NotUnderstood, read_sentence, sentences_of
from tests.description.reader.vocabulary import Vocabulary, lowered

PATTERNS = [*DRIVE_PATTERNS, *JOINT_PATTERNS, *DRAWING_PATTERNS, *CONDITION_PATTERNS]


@dataclass
class Description:
    """Where the points are, how the bodies are joined, what moves."""

    words: Vocabulary
    constructions: list[Construction] = field(default_factory=list)
    equations: list[Equation] = field(default_factory=list)
    sides: list[Side] = field(default_factory=list)
    joints: list[Joint] = field(default_factory=list)
    drives: list[Drive] = field(default_factory=list)
    placing: list[str] = field(default_factory=list)

    def about(self, points: Iterable[str]) -> str:
        """The sentences on positions that name one of the points."""
        named = set(points)
        return "; ".join(sentence for sentence in self.placing if named & names_in(sentence))

    def take_all(self, sentence: str, items: Iterable[object]) -> None:
        """Takes all that one sentence tells."""
        for item in items:
            self.take(item)
            if isinstance(item, (Construction, Equation, Side)) and sentence not in self.placing:
                self.placing.append(sentence)

    def take(self, item: object) -> None:
        """Puts what a sentence tells where it belongs."""
        match item:
            case Construction():
                self.constructions.append(item)
            case Equation():
                self.equations.append(item)
            case Side():
                self.sides.append(item)
            case Joint():
                self.joints.append(item)
            case Drive():
                self.drives.append(item)
            case _:
                raise TypeError(f"not part of a description: {item!r}")

    def points(self) -> set[str]:
        """The names of all points."""
        found = {construction.name for construction in self.constructions}
        for equation in self.equations:
            found |= equation.gap.needs
        for joint in self.joints:
            found |= joint.needs
        for points in self.words.carried.values():
            found |= set(points)
        return found

    def bare_points(self) -> set[str]:
        """The bodies that are no more than a point: they do not turn."""
        return {
            body
            for body, words in self.words.bodies.items()
            if body not in self.words.carried and is_point(words, self.points())
        }


def names_in(sentence: str) -> set[str]:
    """The names that stand in the formulas of a sentence."""
    found = set[str]()
    for formula in re.findall(MATH, sentence):
        found |= {plain(atom[0]) for atom in ATOM.finditer(formula)}
    return found


def is_point(words: str, points: set[str]) -> bool:
    """Whether the words are the name of a point."""
    return words.startswith("$") and plain(words.strip("$")) in points


def bodies_with_points(sentences: Iterable[str], words: Vocabulary) -> dict[str, str]:
    """The bodies that are not asked for: the list of their points names them."""
    found = {}
    for sentence in sentences:
        listed = re.match(r"Points of (?P<body>[^:]+):", sentence)
        if listed and lowered(listed["body"]) not in words.words:
            found[listed["body"]] = listed["body"]
    return found


def read_description(paragraphs: Iterable[str], bodies: Mapping[str, str]) -> Description:
    """Reads all sentences."""
    words = Vocabulary({body: lowered(name) for body, name in bodies.items()})
    found = Description(words)
    sentences = [one for paragraph in paragraphs for one in sentences_of(paragraph)]
    words.bodies |= bodies_with_points(sentences, words)
    faults = []
    for sentence in sentences:
        try:
            items = read_sentence(sentence, PATTERNS, words)
            found.take_all(sentence, items)
        except NotUnderstood as fault:
            faults.append(str(fault))
    if faults:
        raise NotUnderstood("; ".join(faults))
    for body in found.bare_points():
        words.carried[body] = [plain(bodies[body].strip("$"))]
    return found
