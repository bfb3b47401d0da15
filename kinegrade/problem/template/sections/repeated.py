"""What stands twice where it stands once: a point in a body, or at both ends of a mark; a joint."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace

from kinegrade.files.fields.faults import Faults
from kinegrade.files.fields.place import Place
from kinegrade.language.message import Message, Quoted
from kinegrade.problem.template.draft import Draft
from kinegrade.problem.template.sentences import JointSentence


def note_repeated(draft: Draft, faults: Faults) -> None:
    """Notes each body that lists a point twice, each joint that says what another one does, and
    each mark from a point to itself.
    """
    for name, body in draft.bodies.items():
        for point, times in Counter(body.points).items():
            if times > 1:
                what = Message("template.listed-twice", point=Quoted(point))
                faults.note(("bodies", name), what, do=Message("template.list-once"))
    for number, first in _find_said_again(draft):
        what = Message("template.joint-again", first=first + 1)
        faults.note(("joints", number), what, do=Message("template.state-once"))
    for place, point in _find_turned_back(draft):
        what = Message("template.mark-to-itself", point=Quoted(point))
        faults.note(("figure", *place), what, Message("template.another-point"))


def _find_said_again(draft: Draft) -> Iterator[tuple[int, int]]:
    """The joints that say what one before them says, each with that one."""
    said: list[tuple[int, JointSentence]] = []
    for number, joint in draft.joints.items():
        alike = replace(joint, text="", bodies=tuple(sorted(joint.bodies)))
        first = next((each for each, other in said if other == alike), None)
        if first is None:
            said.append((number, alike))
        else:
            yield number, first


def _find_turned_back(draft: Draft) -> Iterator[tuple[Place, str]]:
    """The marks that go from a point to itself, with the point."""
    for number, length in enumerate(draft.figure.lengths):
        if length.start == length.end:
            yield ("lengths", number, "to"), length.end
    for number, angle in enumerate(draft.figure.angles):
        if angle.start in {angle.at, angle.end}:
            yield ("angles", number, "from"), angle.start
        elif angle.end == angle.at:
            yield ("angles", number, "to"), angle.end
    for number, frame in enumerate(draft.figure.frames):
        if frame.start == frame.end:
            yield ("frames", number, "to"), frame.end
