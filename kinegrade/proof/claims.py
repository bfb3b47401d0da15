"""What a statement says in words that the mechanism contradicts: the length beside two points, the
midpoint of a line, the sense of an imposed rotation.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from kinegrade.figure.plane import length
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import known_languages
from kinegrade.language.message import Fault, Message
from kinegrade.numbers.floats import Floats
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.driven import find_driven
from kinegrade.problem.template.notation import write_point_symbol
from kinegrade.problem.template.template import Template

_DIFFERENT = 1e-6  # of a length: less is what doubles leave
_LETTER = r"[A-Z](?:_\{?\d+\}?)?'*"
_SHAPES = {
    "POINT": rf"\$(?P<point>{_LETTER})\$",
    "LINE": rf"\$(?P<start>{_LETTER})(?P<end>{_LETTER})\$",
    "GIVEN": r"\{\{\s*(?P<given>\w+)(?:\s*\.\s*(?:value|size))?\s*\}\}",
    "WORD": r"\w+",
    "REST": r"[^.;。；{}]*?",
}
_TURNS = {"counterclockwise": 1, "clockwise": -1}

_Claim = Mapping[str, str]


def find_false_claims(template: Template, examples: Sequence[Solution]) -> Iterator[Fault]:
    """A fault for each claim of the statement that these instances contradict."""
    found = (
        *_find_wrong_lengths(template, examples),
        *_find_wrong_midpoints(template, examples),
        *_find_wrong_senses(template, examples),
    )
    yield from (Fault("statement", what) for what in dict.fromkeys(found))


def _find_wrong_lengths(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """`$AB$ of length {{ l }}` where the points are at another distance."""
    for claim in _read_claims(template, "length"):
        ends = _find_points(template, claim["start"], claim["end"])
        given = template.parameters.get(claim["given"])
        if not ends or given is None or not given.unit.is_length:
            continue
        scale = Floats().scale(given.unit.scale)
        values = [
            (abs(each.parameters[given.name].value), _measure(each, *ends) / scale)
            for each in examples
        ]
        wrong = [pair for pair in values if abs(pair[0] - pair[1]) > _DIFFERENT * pair[0]]
        for stated, shown in wrong[:1]:
            yield Message(
                "template.length-contradicted",
                line=claim["start"] + claim["end"],
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


def _read_claims(template: Template, kind: str) -> Iterator[_Claim]:
    """What the sentences of a kind name, in whatever language they are."""
    for text in template.words.statement.texts:
        for language in known_languages():
            spelled = open_catalogue(language).text(f"template.says-{kind}").split("|")
            for pattern in map(_make_pattern, spelled):
                yield from (match.groupdict() for match in pattern.finditer(text))


def _make_pattern(sentence: str) -> re.Pattern[str]:
    """A sentence of the catalogue as a pattern: its capital words are shapes, a blank any room."""
    pieces = re.findall(r"[A-Z]+|\s+|[^A-Z\s]+", sentence.strip())
    written = (
        _SHAPES.get(each) or (r"\s*" if each.isspace() else re.escape(each)) for each in pieces
    )
    return re.compile("".join(written), re.ASCII)


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
