"""Whether the parts of a template name only what the template has: points, bodies, values, asks."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from msgspec import Struct, field

from kinegrade.errors import suggest
from kinegrade.expressions.tree import Expression, find_names
from kinegrade.files.fields.faults import Faults
from kinegrade.files.fields.place import Place
from kinegrade.language.message import Message, Quoted, Text
from kinegrade.mechanics.branches import BRANCHES
from kinegrade.mechanics.joints import GROUND
from kinegrade.problem.template.conditions import mixes_angle_and_number
from kinegrade.problem.template.draft import Draft
from kinegrade.problem.template.driven import find_driven
from kinegrade.problem.template.sections.values import NamedKind, explain_missing
from kinegrade.problem.template.slots import Fillings, find_slot_faults
from kinegrade.problem.template.template import Condition, Published, Wording
from kinegrade.problem.template.translated import Translated


class _Miss(Struct, frozen=True):
    """A name that is used at a place and does not exist, and what to do."""

    place: Place
    what: Message
    do: Text


def check_uses(draft: Draft, faults: Faults) -> None:
    """Notes every name that is used where it is not known, once, at the first such place."""
    uses = _Uses(draft, faults)
    uses.check()
    for first, *others in uses.unknown.values():
        more = len(dict.fromkeys(others))
        again = Message("template.more-places", what=first.what, count=more)
        faults.note(first.place, again if more else first.what, do=first.do)


class _Uses(Struct, frozen=True):
    """Checks one draft; `unknown` collects the names that do not exist."""

    draft: Draft
    faults: Faults
    unknown: dict[str, list[_Miss]] = field(default_factory=dict)

    def check(self) -> None:
        """Goes through all parts, in the order in which they build on each other."""
        draft = self.draft
        values = {*draft.parameters, "pi"}
        places = {*values, *draft.lengths, *BRANCHES}
        self._in_order("lengths", draft.lengths, values)
        for name in draft.reasons:
            self._listed(("reasons", name), "length", (name,), draft.lengths)
        self._in_order("steps", draft.steps, values)
        self._mistakes(values)
        places |= set(draft.steps)
        self._in_order("points", draft.points, places)
        places |= set(draft.points)
        self._marked_points()
        self.joints(places)
        self.drivers(places)
        for name, ask in draft.asks.items():
            self.known(("asks", name, "quantity"), ask.quantity, places | self.bodies)
        for number, condition in draft.conditions.items():
            self.condition(("conditions", number), condition, places)
        self.words()
        for number, result in draft.published.items():
            self.published(number, result)

    @property
    def bodies(self) -> set[str]:
        """The names of the bodies, with the ground."""
        return {GROUND, *self.draft.bodies}

    def _in_order(self, key: str, trees: Mapping[str, Expression], known: Collection[str]) -> None:
        """Lengths and points may name what stands before them."""
        before = set(known)
        for name, tree in trees.items():
            self.known((key, name), tree, before)
            before.add(name)

    def _mistakes(self, known: Collection[str]) -> None:
        """A mistaken step names what the right one may name."""
        steps = [*self.draft.steps]
        for identifier, mistake in self.draft.mistakes.items():
            for name, tree in mistake.steps.items():
                place = ("mistakes", identifier, "steps", name)
                before = {*known, *steps[: steps.index(name)]} if name in steps else {*known}
                self.known(place, tree, before)
                if tree == self.draft.steps.get(name):
                    self.faults.note(place, Message("template.no-mistake"))

    def _marked_points(self) -> None:
        """Bodies mark points."""
        for name, body in self.draft.bodies.items():
            self._listed(("bodies", name), "point", body.points, self.draft.points)

    def joints(self, known: Collection[str]) -> None:
        """Joints connect bodies at points, lines and circles."""
        for number, joint in self.draft.joints.items():
            place = ("joints", number)
            bodies = (joint.body, joint.of, joint.carrier, *joint.bodies)
            self._listed(place, "body", bodies, self.bodies)
            self._listed(place, "point", (joint.point,), self.draft.points)
            self.known(place, joint.circle, known)
            self.known(place, joint.on, known)

    def drivers(self, known: Collection[str]) -> None:
        """Inputs move bodies and points."""
        for number, driver in self.draft.drivers.items():
            place = ("inputs", number)
            motion = (*place, "motion")
            self._listed(motion, "body", (driver.body, driver.of), self.bodies)
            self._listed(motion, "point", (driver.point, driver.centre), self.draft.points)
            self.known(motion, driver.along, known)
            self.known((*place, "velocity"), driver.velocity, known)
            self.known((*place, "acceleration"), driver.acceleration, known)

    def condition(self, place: Place, condition: Condition, known: Collection[str]) -> None:
        """A condition names what is known, and compares angles with angles."""
        sides = (condition.left, condition.right)
        for tree in sides:
            self.known(place, tree, known)
        faulty = any(name in self.draft.faulty for tree in sides for name in find_names(tree))
        if not faulty and mixes_angle_and_number(condition, self.draft.angles):
            what = Message("template.angle-against-number", condition=Quoted(condition.text))
            self.faults.note(place, what, do=Message("template.parts-of-pi"))

    def words(self) -> None:
        """Statements name parameters, what is driven, and texts; texts name no texts."""
        givens = {*self.draft.parameters, *self.draft.faulty}
        driven = find_driven(self.draft.drivers.values(), givens)
        for name, wordings in self.draft.texts.items():
            for number, wording in wordings.items():
                self._wording(("text", name, number), wording, Fillings(givens, (), driven))
        if self.draft.statement is not None:
            fillings = Fillings(givens, self.draft.texts, driven)
            self.slots(("statement",), self.draft.statement, fillings)

    def _wording(self, place: Place, wording: Wording, fillings: Fillings) -> None:
        """A wording names parameters, in its condition too."""
        if wording.condition is not None:
            givens = {*self.draft.parameters, "pi"}
            self.condition((*place, "if"), wording.condition, givens)
        self.slots(place, wording.text, fillings)

    def slots(self, place: Place, text: Translated, fillings: Fillings) -> None:
        """A fault for everything in double braces that is no name known here, once a language."""
        for where, written in text.list_written(place):
            for fault in dict.fromkeys(find_slot_faults(written, fillings)):
                if fault.name:
                    self._miss(fault.name, _Miss(where, fault.what, fault.do))
                else:
                    self.faults.note(where, fault.what, do=fault.do)

    def published(self, number: int, result: Published) -> None:
        """Published results hold for parameters, and are those of asks."""
        place = ("published", number)
        for name in result.given:
            self._listed((*place, "given", name), "parameter", (name,), self.draft.parameters)
        for name, tree in result.gives.items():
            self._listed((*place, "gives", name), "ask", (name,), self.draft.asks)
            self.known((*place, "gives", name), tree, {*self.draft.parameters, "pi"})

    def _listed(
        self, place: Place, kind: NamedKind, named: Collection[str], there: Collection[str]
    ) -> None:
        """A name of each kind is there; parts that a sentence lacks are empty."""
        for name in named:
            if name and name not in there:
                what = explain_missing(kind, Quoted(name))
                self._miss(name, _Miss(place, what, suggest(name, there)))

    def known(self, place: Place, tree: Expression | None, known: Collection[str]) -> None:
        """Every name in an expression is known at this place."""
        for name in dict.fromkeys(find_names(tree)) if tree is not None else ():
            if name in known:
                continue
            if name in self.draft.steps:
                what, do = Message("template.step-later", name=name), Message("template.step-order")
                self.faults.note(place, what, do=do)
            else:
                what = Message("template.unknown-name", name=Quoted(name))
                self._miss(name, _Miss(place, what, suggest(name, known)))

    def _miss(self, name: str, miss: _Miss) -> None:
        """Note that a name is used and does not exist, unless its declaration in the file cannot be
        read.
        """
        if name not in self.draft.faulty:
            self.unknown.setdefault(name, []).append(miss)
