"""Wheels between two parallel tracks or cords of known motions: the contacts give the rotation."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from kinegrade.language.message import Message, list_all
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import NoSlip, find_rolling
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.shapes import Line
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block
from kinegrade.worked.findings import Fact, Piece
from kinegrade.worked.formulas.atoms import TWO, ZERO, VectorSymbol, add_terms
from kinegrade.worked.formulas.equation import Equation, equate, lead_to
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double, find_sign, length
from kinegrade.worked.formulas.numbers import measure, state_number
from kinegrade.worked.rates.kinds import describe_track, is_cord
from kinegrade.worked.rates.rolled_motion import state_rolled_radius
from kinegrade.worked.senses import find_axis_sense, state_sense_along
from kinegrade.worked.steps.titles import select_scalars
from kinegrade.worked.steps.track_contacts import Contact, find_contact
from kinegrade.worked.vectors.facts import make_key
from kinegrade.worked.vectors.known_vectors import find_positive_sense
from kinegrade.worked.vectors.results import state_rotation_result
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.vectors import UNITS, name_point_vector


@dataclass(frozen=True)
class TwoTracks:
    """A wheel between two tracks, the second contact to the left of the first one, seen along the
    positive direction of the motion of its centre.
    """

    first: Contact
    second: Contact
    along: Vector
    is_centre_needed: bool
    level: Level
    case: Case

    @property
    def body(self) -> str:
        """The wheel."""
        return self.first.roll.body

    @property
    def start(self) -> Contact:
        """The contact from which the centre's motion is found: one that rests before others."""
        return self.second if self.second.letters == ZERO else self.first

    @property
    def centre(self) -> VectorSymbol:
        """The velocity or acceleration of the centre."""
        return name_point_vector(self.first.roll.circle.centre, self.level, self.case)

    def measure_centre(self) -> Any:
        """The motion of the centre along the tracks."""
        return self.measure_from(self.start)

    def measure_from(self, contact: Contact) -> Any:
        """The same from one of the contacts."""
        return contact.moved + self._rate * contact.away

    @property
    def _rate(self) -> Any:
        return self.case.rates(self.level)[make_turning(self.body)]

    def state_rotation(self) -> Equation:
        """The difference of the tracks' motions over the distance of the contacts."""
        rate, contacts = make_turning(self.body), (self.first, self.second)
        moved = [(one.letters, self._measure_track(one)) for one in contacts]
        above = [_add([one, -other]) for one, other in zip(*moved, strict=True)]
        if ZERO in above or not double(self._rate):
            return state_rotation_result(rate, self.case, self.level)
        ratios = (
            (over.size / below).signed(over.sign)
            for over, below in zip(above, self._list_distances(), strict=True)
        )
        return state_rotation_result(rate, self.case, self.level, equate(*ratios))

    def _list_distances(self) -> tuple[Formula, Formula]:
        """The distance of the contacts in letters and in numbers."""
        contacts = (self.second, 1), (self.first, -1)
        letters = [
            state_rolled_radius(one.roll, self.case).signed(sign * find_sign(one.away))
            for one, sign in contacts
        ]
        numbers = [
            measure(abs(one.away), "m").signed(sign * find_sign(one.away)) for one, sign in contacts
        ]
        return _add(letters), _add(numbers)

    def _explain_centre(self, centre: str) -> Message:
        """From which contact the motion of the centre follows."""
        if self.start.roll.of == GROUND:
            return Message("solution.centre-from-fixed-track", centre=centre)
        track = describe_track(self.start.roll, self.case)
        if self.start.letters == ZERO:
            return Message("solution.centre-from-resting-track", centre=centre, track=track)
        return Message("solution.centre-from-moving-track", centre=centre, track=track)

    def state_centre(self) -> Equation:
        """The motion of the centre, from one of the contacts."""
        unit, value = UNITS[self.level, False], self.measure_centre()
        working = self.name_centre_from(self.start), self.find_centre_from(self.start)
        sense = state_sense_along(double(value), self.along, None, self.case)
        links = lead_to(self.centre, working, state_number(value, unit))
        return Equation(self.centre, links, sense)

    def name_centre_from(self, contact: Contact) -> Formula:
        """The motion of a contact and what the rotation adds to it, in letters."""
        radius = state_rolled_radius(contact.roll, self.case)
        turning = self.case.naming.turning(self.body, self.level)
        turned = (radius * turning).signed(find_sign(contact.away))
        return add_terms(_list(contact.letters, turned))

    def find_centre_from(self, contact: Contact) -> Formula:
        """The motion of a contact and what the rotation adds to it, in numbers."""
        rate = measure(self._rate, UNITS[self.level, True])
        turned = ZERO if rate == ZERO else measure(abs(contact.away), "m").dot(rate)
        return add_terms(
            _list(self._measure_track(contact), turned.signed(find_sign(contact.away)))
        )

    def _measure_track(self, contact: Contact) -> Formula:
        """The motion of a track along the positive direction."""
        size = measure(abs(contact.moved), UNITS[self.level, False])
        return size.signed(find_sign(contact.moved))

    def state_idea(self) -> Message:
        """Why both contacts give the rotation: on what it rolls, and which cord does not slip."""
        body, case = self.case.naming.body(self.body), self.case
        rolls = sorted(
            (self.first.roll, self.second.roll),
            key=lambda roll: (is_cord(roll, case), roll.of),
        )
        one, other = (describe_track(roll, case) for roll in rolls)
        cords = sum(is_cord(roll, case) for roll in rolls)
        if cords == 1:
            return Message("solution.idea-track-and-cord", body=body, track=one, cord=other)
        both = list_all((one, other))
        if cords:
            return Message("solution.idea-two-cords", body=body, cords=both)
        return Message("solution.idea-two-tracks", body=body, tracks=both)

    def explain(self) -> Iterator[Block]:
        """The rotation, then the motion of the centre where that is needed, which is noted."""
        case, level = self.case, self.level
        centre = case.naming.point(self.first.roll.circle.centre)
        yield case.say(Message(f"solution.both-tracks-{level}", body=case.naming.body(self.body)))
        yield case.show(self.state_rotation())
        if not self.is_centre_needed:
            return
        if level == "velocity":
            yield case.say(self._explain_centre(centre))
        yield case.show(self.state_centre())
        value = self.along * self.measure_centre()
        fact = Fact(self.centre, value, False, (Piece(self.centre, self.along, value),))
        chain = case.motion.frames.chain(self.body, self.first.roll.circle.centre)
        case.findings.facts.setdefault(make_key(chain, level), fact)


def find_two_tracks(step: Step, stage: Stage) -> TwoTracks | None:
    """The wheel that a step is about; None where it is about anything else, or where the tracks lie
    aslant, turn, or have motions that the step has to find.
    """
    case = stage.case
    rolls = [find_rolling(relation.source) for relation in select_scalars(step, case)]
    if len(stage.equations) != 1 or len(rolls) != 2:
        return None
    one, other = rolls
    if one is None or other is None or not _is_one_wheel(one, other):
        return None
    relation = stage.equations[0].relation
    terms = (*relation.left, *relation.right)
    own = [term for term in terms if term.frame == GROUND and term.rate.body == one.body]
    seen = [term.rate for term in terms if term.frame != GROUND and term.rate.body == one.body]
    found: set[Rate] = {make_turning(one.body), *(term.rate for term in own), *seen}
    if found != set(step.unknowns) or _is_relative_asked(case):
        return None
    return _place_contacts((one, other), own, stage)


def _is_relative_asked(case: Case) -> bool:
    """Whether a template asks for relative motions, which this way does without."""
    calls = (
        call for ask in case.template.asks.values() for call in find_motion_calls(ask.quantity)
    )
    asked = {MOTION_FUNCTIONS[call.function].derivation for call in calls}
    return not asked.isdisjoint(("relative", "coriolis"))


def _is_one_wheel(one: NoSlip, other: NoSlip) -> bool:
    """Whether it is one wheel that rolls on two lines."""
    lines = isinstance(one.on, Line) and isinstance(other.on, Line)
    return lines and (one.body, one.circle.centre) == (other.body, other.circle.centre)


def _place_contacts(
    rolls: tuple[NoSlip, NoSlip], own: list[Term], stage: Stage
) -> TwoTracks | None:
    """The contacts from right to left, seen along the motion of the centre."""
    case, level = stage.case, stage.level
    tracks = [roll.on for roll in rolls if isinstance(roll.on, Line)]
    if double(tracks[0].direction.cross(tracks[1].direction)):
        return None
    along = find_positive_sense(own[0], case, level) if own else tracks[0].direction
    along = along / length(along, case.arithmetic)
    if not own and double(along.x + along.y) < 0:
        along = -along
    contacts = [
        find_contact(roll, track, along, stage) for roll, track in zip(rolls, tracks, strict=True)
    ]
    known = [one for one in contacts if one is not None]
    if len(known) < 2 or find_axis_sense(along) is None:
        return None
    first, second = sorted(known, key=lambda one: double(one.away))
    rates = [rate for rate in stage.equations[0].unknowns if rate.kind != "turning"]
    needed = not all(case.findings.spares(rate, level) for rate in rates)
    return TwoTracks(first, second, along, needed, level, case)


def _list(*terms: Formula) -> tuple[Formula, ...]:
    """The terms that are not zero."""
    return tuple(term for term in terms if ZERO not in (term, -term))


def _add(terms: Sequence[Formula]) -> Formula:
    """The sum, those first that count positive; the opposite of one where none does, twice the one
    of two that are the same.
    """
    left = sorted(_list(*terms), key=lambda one: -one.sign)
    if len(left) == 2 and left[0].looks_like(left[1]):
        return (TWO * left[0].size).signed(left[0].sign)
    if left and left[0].sign < 0:
        return -add_terms(-one for one in left)
    return add_terms(left)
