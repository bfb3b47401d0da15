"""Why a moving frame serves: along what points move relative to it, and which directions that
tells.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from kinegrade.language.message import Message, list_all
from kinegrade.mechanics.vector_equation import Part, VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.symbols import join_letters
from kinegrade.worked.steps.flat_faces import find_profile
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.table.tracks import find_path_ends


def explain_frames(stage: Stage, accelerated: bool) -> Iterator[Message]:
    """Why a moving frame serves, or two, where there are as many unknowns as these can give."""
    case, compositions = stage.case, stage.equations[0].compositions
    point = case.naming.point(compositions[0].point) if compositions else ""
    frames = [case.naming.body(part.frame) for part in compositions]
    unknown = len(stage.equations[0].unknowns)
    yield from _replace_profiles(compositions, case)
    if unknown == 1 and len(frames) == 1:
        yield Message("solution.idea-composed-known", point=point, frame=frames[0])
    if unknown != 2 or not frames:
        return
    way = {
        "path": _describe_path(compositions, case),
        "directions": _describe_directions(stage.equations[0], accelerated),
    }
    if len(frames) == 1:
        yield Message("solution.idea-composed", point=point, frame=frames[0], **way)
    elif len({part.point for part in compositions}) == 1:
        every = list_all(frames)
        yield Message("solution.idea-composed-twice", point=point, frames=every, **way)
    else:
        yield Message(
            "solution.idea-composed-on",
            first=point,
            frame=frames[0],
            second=case.naming.point(compositions[1].point),
            other=frames[1],
            **way,
        )


def _replace_profiles(compositions: Iterable[Part], case: Case) -> Iterator[Message]:
    """Why the circle of curvature serves where no more of a profile is known."""
    for relative in compositions:
        profile = find_profile(relative, case)
        if profile is not None and profile.of_curvature:
            point, body = case.naming.point(relative.point), case.naming.body(profile.body)
            yield Message("solution.idea-curvature", point=point, body=body)


def _describe_directions(equation: VectorEquation, accelerated: bool) -> Message:
    """What the paths say of relative velocities, and where they are straight of relative
    accelerations too: in words, as their letters are explained at the composition.
    """
    terms = [part.term for part in equation.compositions if part.term is not None]
    if all(term.kind == "sliding" for term in terms):
        key = "straight-accelerated" if accelerated else "straight"
    else:
        key = "tangent" if all(term.kind == "arc" for term in terms) else "known"
    return Message(f"solution.directions-{key}", count=len(equation.compositions))


def _describe_path(relatives: Sequence[Part], case: Case) -> Message:
    """Along what points move relative to frames: a line, which is named where there is one, or a
    circle about a centre.
    """
    terms = [part.term for part in relatives if part.term is not None]
    centres = {term.base for term in terms}
    line = find_path_ends(relatives[0], case) if len(terms) == 1 else None
    if line is not None:
        start, end = (case.motion.points[point] for point in line)
        off = double((end - start).cross(case.motion.points[terms[0].point] - start))
        letters = case.text(join_letters(map(case.naming.letter, line)))
        if off:
            return Message("solution.path-parallel", line=letters)
        return Message("solution.path-line", line=letters)
    if all(term.kind == "sliding" for term in terms):
        return Message("solution.path-straight")
    if all(term.kind == "arc" for term in terms):
        if len(centres) > 1:
            return Message("solution.path-circles")
        return Message("solution.path-circle", centre=case.naming.point(*centres))
    return Message("solution.path-known")
