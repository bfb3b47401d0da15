"""Claims of what is at rest or constant."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinegrade.expressions.tree import find_names
from kinegrade.figure.plane import length
from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.kinds import name_kinds
from kinegrade.proof.claims.reading import find_points, read_claims

_STILL = 1e-9  # m/s: less is what doubles leave


def find_wrong_states(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """What is said to be at rest or constant, and is not so."""
    yield from _find_moving(template, examples)
    yield from _find_changing(template, examples)


def _find_moving(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """`$A$ is at rest`, `the fixed pin $A$` of a point that moves in an instance."""
    for claim in read_claims(template, "at-rest"):
        letters = [claim[part] for part in ("point", "start", "end") if claim.get(part)]
        points = find_points(template, *letters)
        if any(_moves(template, point, each) for point in points for each in examples):
            yield Message("template.at-rest-moves", said=claim["said"])


def _moves(template: Template, point: str, example: Solution) -> bool:
    """Whether a point moves as one of each body that has it, and no joint ties it to the ground."""
    tied = (
        point == joint.point and GROUND in {joint.body, joint.of, *joint.bodies}
        for joint in template.scheme.joints
        if joint.on is None or joint.body == GROUND
    )
    if any(tied):
        return False
    bodies = [body.name for body in template.scheme.bodies if point in body.points]
    speeds = [length(example.doubles.velocity(point, body)) for body in bodies]
    return min(speeds, default=0.0) > _STILL


def _find_changing(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """`at the constant rate {{ omega }}` of an input whose acceleration is not zero."""
    for claim in read_claims(template, "constant"):
        if any(kind.endswith("acceleration") for kind in name_kinds(claim.get("between", ""))):
            continue
        for place, sentence in enumerate(template.scheme.drivers):
            if claim["given"] in find_names(sentence.velocity):
                drivers = [each.assembly.mechanism.drivers[place] for each in examples]
                if any(float(each.acceleration) for each in drivers):
                    yield Message("template.constant-changes", said=claim["said"])
