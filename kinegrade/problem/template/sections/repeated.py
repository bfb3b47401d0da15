"""Points that stand twice where each stands once: in a body, or at both ends of a mark."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from kinegrade.files.fields.faults import Faults
from kinegrade.files.fields.place import Place
from kinegrade.language.message import Message, Quoted
from kinegrade.problem.template.draft import Draft


def note_repeated(draft: Draft, faults: Faults) -> None:
    """Notes each body that lists a point twice, and each mark from a point to itself."""
    for name, body in draft.bodies.items():
        for point, times in Counter(body.points).items():
            if times > 1:
                what = Message("template.listed-twice", point=Quoted(point))
                faults.note(("bodies", name), what, do=Message("template.list-once"))
    for place, point in _find_turned_back(draft):
        what = Message("template.mark-to-itself", point=Quoted(point))
        faults.note(("figure", *place), what, Message("template.another-point"))


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
