"""What a statement says in words that the mechanism contradicts: the length beside two points, the
midpoint of a line, the sense of an imposed rotation, the side on which a point lies.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence

from kinegrade.figure.plane import length
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import known_languages
from kinegrade.language.message import Fault, Message
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.floats import Floats
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.driven import find_driven
from kinegrade.problem.template.notation import write_point_symbol
from kinegrade.problem.template.template import Template
from kinegrade.problem.template.texts import list_prose

_DIFFERENT = 1e-6  # of a length: less is what doubles leave
_LETTER = r"[A-Z](?:_\{?\d+\}?)?'*"
_SHAPES = {
    "POINT": rf"\$(?P<point>{_LETTER})\$",
    "OTHER": rf"\$(?P<other>{_LETTER})\$",
    "LINE": rf"\$(?P<start>{_LETTER})(?P<end>{_LETTER})\$",
    "GIVEN": r"\{\{\s*(?P<given>\w+)(?:\s*\.\s*(?:value|size))?\s*\}\}",
    "WORD": r"\w+",
    "REST": r"[^.;。；{}]*?",
}
_TURNS = {"counterclockwise": 1, "clockwise": -1}

_SIDES: Mapping[str, Callable[[Vector, float], bool]] = {
    "above": lambda step, room: abs(step.x) <= room < step.y,
    "below": lambda step, room: abs(step.x) <= room < -step.y,
    "right": lambda step, room: step.x > room,
    "left": lambda step, room: step.x < -room,
}
# A line through a point, or what turns about it, is no place of the point itself
_NO_SUBJECT = "(?<!through )(?<!about )(?<!durch )(?<!um )(?<!过 )(?<!过)(?<!绕 )(?<!绕)"
_OF_ANOTHER = (
    "(?<!above )(?<!below )(?<!of )(?<!über )(?<!unter )(?<!von )"  # which has the distance
)
# Rates by the powers of length, time and angle of their units; words of the first contain others
_KINDS = {
    (0, -2, 1): "angular-acceleration",
    (0, -1, 1): "angular-velocity",
    (1, -2, 0): "acceleration",
    (1, -1, 0): "velocity",
}

_Claim = Mapping[str, str]


def find_false_claims(template: Template, examples: Sequence[Solution]) -> Iterator[Fault]:
    """A fault for each claim of the statement that these instances contradict."""
    found = (
        *_find_wrong_lengths(template, examples),
        *_find_wrong_midpoints(template, examples),
        *_find_wrong_senses(template, examples),
        *_find_wrong_distances(template, examples),
        *_find_wrong_sides(template, examples),
        *_find_second_senses(template),
    )
    yield from (Fault("statement", what) for what in dict.fromkeys(found))


def note_other_kinds(template: Template) -> Iterator[Message]:
    """A remark for each ask whose words name another kind of rate than its unit has: "angular
    velocity" in rad/s^2.
    """
    for name, ask in template.asks.items():
        own = _KINDS.get((ask.unit.length, ask.unit.time, ask.unit.angle))
        named = {kind for text in ask.means.texts for kind in _name_kinds(text.lower())}
        if own and named and own not in named:
            yield Message("template.another-kind", name=name, unit=ask.unit.printed)


def _name_kinds(text: str) -> Iterator[str]:
    """The kinds of rates that a text names; an angular velocity is no velocity besides."""
    for kind in _KINDS.values():
        for language in known_languages():
            for word in open_catalogue(language).text(f"template.kind-{kind}").split("|"):
                if word in text:
                    yield kind
                    text = text.replace(word, "")


def _find_wrong_lengths(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """`$AB$ of length {{ l }}` where the points are at another distance."""
    for claim in _read_claims(template, "length"):
        ends = _find_points(template, claim["start"], claim["end"])
        yield from _compare(template, claim, ends, claim["start"] + claim["end"], examples)


def _compare(
    template: Template,
    claim: _Claim,
    ends: Sequence[str],
    line: str,
    examples: Sequence[Solution],
) -> Iterator[Message]:
    """That a given of a claim is not the distance of its points."""
    given = template.parameters.get(claim["given"])
    if not ends or given is None or not given.unit.is_length:
        return
    scale = Floats().scale(given.unit.scale)
    values = [
        (abs(each.parameters[given.name].value), _measure(each, *ends) / scale) for each in examples
    ]
    wrong = [pair for pair in values if abs(pair[0] - pair[1]) > _DIFFERENT * pair[0]]
    for stated, shown in wrong[:1]:
        yield Message(
            "template.length-contradicted",
            line=line,
            name=given.name,
            shown=f"{shown:.4g} {given.unit.printed}",
            stated=f"{stated:.4g} {given.unit.printed}",
        )


def _find_wrong_midpoints(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """`the midpoint $D$ of $AB$` where D is elsewhere."""
    for claim in _read_claims(template, "midpoint"):
        names = _find_points(template, claim["point"], claim["start"], claim["end"])
        for each in examples if names else ():
            middle, start, end = (each.doubles.points[name] for name in names)
            if length(middle + middle - start - end) > _DIFFERENT * length(end - start):
                line = claim["start"] + claim["end"]
                yield Message("template.no-midpoint", point=claim["point"], line=line)
                break


def _find_wrong_senses(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """`turns clockwise with {{ n }}` where all instances turn the other way."""
    rates = {
        driven.velocity.given: -1 if driven.velocity.turned else 1
        for part in find_driven(template.scheme.drivers, template.parameters).values()
        for driven in part.values()
        if driven.positive == "ccw"
    }
    for sense, said in _TURNS.items():
        for claim in _read_claims(template, sense):
            sign, name = rates.get(claim["given"], 0), claim["given"]
            if sign and all(said * sign * each.parameters[name].value < 0 for each in examples):
                yield Message(f"template.does-not-turn-{sense}", name=name)


def _find_wrong_distances(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """`$C$ at the distance {{ d }} from $A$` where it is at another one."""
    for claim in _read_claims(template, "distance", _NO_SUBJECT + _OF_ANOTHER):
        ends = _find_points(template, claim["point"], claim["other"])
        yield from _compare(template, claim, ends, claim["point"] + claim["other"], examples)


def _find_wrong_sides(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """`$C$, vertically above $O$` where it is elsewhere."""
    for side, holds in _SIDES.items():
        for claim in _read_claims(template, side, _NO_SUBJECT):
            names = _find_points(template, claim["point"], claim["other"])
            for each in examples if names else ():
                point, other = (each.doubles.points[name] for name in names)
                if not holds(point - other, _DIFFERENT * length(point - other)):
                    named = {"point": claim["point"], "other": claim["other"]}
                    yield Message(f"template.not-{side}", **named)
                    break


def _find_second_senses(template: Template) -> Iterator[Message]:
    """`{{ E.moving }}, to the left`: the slot says the sense that each instance has."""
    texts = [text for _, prose in list_prose(template) for text in prose.texts]
    for language in known_languages():
        words = open_catalogue(language).text("template.says-sense").split("|")
        senses = "|".join(map(re.escape, words))
        pattern = rf"(\{{\{{\s*\w+\s*\.\s*(?:moving|turning)\s*\}}\}})[,，]?\s*({senses})(?![\w-])"
        for text in texts:
            for slot, said in re.findall(pattern, text):
                yield Message("template.sense-twice", slot=slot, said=said)


def _read_claims(template: Template, kind: str, before: str = "") -> Iterator[_Claim]:
    """What the sentences of a kind name, in whatever language they are."""
    for text in template.words.statement.texts:
        for language in known_languages():
            spelled = open_catalogue(language).text(f"template.says-{kind}").split("|")
            for pattern in (_make_pattern(sentence, before) for sentence in spelled):
                yield from (match.groupdict() for match in pattern.finditer(text))


def _make_pattern(sentence: str, before: str) -> re.Pattern[str]:
    """A sentence of the catalogue as a pattern: its capital words are shapes, a blank any room."""
    pieces = re.findall(r"[A-Z]+|\s+|[^A-Z\s]+", sentence.strip())
    written = (
        _SHAPES.get(each) or (r"\s*" if each.isspace() else re.escape(each)) for each in pieces
    )
    return re.compile(before + "".join(written), re.ASCII)


def _find_points(template: Template, *letters: str) -> list[str]:
    """The points that go by these letters; none where one of them is no point's."""
    labels = template.figure.labels
    named = {
        _plain(labels.get(name) or write_point_symbol(name)): name
        for name in template.scheme.points
    }
    found = [named.get(_plain(letter), "") for letter in letters]
    return found if all(found) else []


def _measure(solution: Solution, start: str, end: str) -> float:
    """The distance of two points in metres."""
    return length(solution.doubles.points[end] - solution.doubles.points[start])


def _plain(symbol: str) -> str:
    """O_{1} is O_1."""
    return symbol.replace("{", "").replace("}", "")
