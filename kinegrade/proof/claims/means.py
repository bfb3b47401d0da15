"""What asks mean in words against their quantities: another point or body, the other sense."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.expressions.tree import find_names
from kinegrade.language.message import Fault, Message, Quoted, list_plainly
from kinegrade.mechanics.mechanism import Body
from kinegrade.problem.template.meaning.senses import find_positive
from kinegrade.problem.template.template import Ask, Template
from kinegrade.proof.claims.reading import find_points, name_senses, read_texts
from kinegrade.sign_conventions import OPPOSITE

# "The height above O", "to the left of O": no property of O
_NO_SUBJECT = (
    "(?<![到过绕距于对出] )(?<![到过绕距于对出])(?<!left )(?<!right )(?<!links )(?<!rechts )"
)


def find_wrong_means(template: Template) -> Iterator[Fault]:
    """A fault for each ask whose words name another point or body than its quantity, or the sense
    opposite to the one in which it is positive.
    """
    for name, ask in template.asks.items():
        place = f"asks.{name}.means"
        yield from (Fault(place, what) for what in _find_others(template, ask))
        yield from (Fault(place, what) for what in _find_other_senses(ask))


def _find_others(template: Template, ask: Ask) -> Iterator[Message]:
    """`velocity of $B$` of a quantity that has nothing to do with B."""
    names = [name for name in find_names(ask.quantity) if name not in template.parameters]
    groups = [_list_points(template, body) for body in template.scheme.bodies if body.name in names]
    groups.append({name for name in names if name in template.scheme.points})
    for text in ask.means.texts:
        named = {}
        for claim in read_texts([text], "subject", _NO_SUBJECT):
            letters = [claim[part] for part in ("point", "start", "end") if claim.get(part)]
            points = find_points(template, *letters)
            if points:
                named[claim["said"]] = {*points}
        if named and not any(points <= group for points in named.values() for group in groups):
            own = list_plainly(dict.fromkeys(names))
            yield Message("template.means-another", said=next(iter(named)), own=own)


def _list_points(template: Template, body: Body) -> set[str]:
    """The points of a body, and those of its joints: a rocker is named by the block in its slot."""
    found = {*body.points}
    for joint in template.scheme.joints:
        if body.name in {joint.body, joint.of, *joint.bodies}:
            found.add(joint.point)
            found |= {
                name for shape in (joint.circle, joint.on) if shape for name in find_names(shape)
            }
    return found


def _find_other_senses(ask: Ask) -> Iterator[Message]:
    """`, downwards` of a quantity that is positive upwards."""
    positive = find_positive(ask)
    for claim in read_texts(ask.means.texts, "sense-meant"):
        if positive and name_senses(claim["sense"]) == {OPPOSITE[positive]}:
            said = claim["said"].strip(",(，（ ")
            yield Message("template.sign-other-way", said=said, sign=Quoted(positive))
