"""Whether a template's expressions make sense before any numbers are put in: functions, kinds and
dimensions.

What is asked for must have the dimension of its unit, points the dimension of a length, inputs that
of a rate or of a velocity.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from kinegrade.errors import ExpressionError, FieldError
from kinegrade.expressions.tree import SUMS, Expression, Name, Operation, find_names, walk
from kinegrade.files.fields.faults import Faults
from kinegrade.files.fields.place import Place, key_path
from kinegrade.language.message import Message, Quoted, list_choices
from kinegrade.mechanics.branches import BRANCHES
from kinegrade.mechanics.joints import GROUND
from kinegrade.problem.kinds.dimension import (
    ACCELERATION,
    CHANGE,
    LENGTH,
    NUMBER,
    RATE,
    SPEED,
    Dimension,
    describe_dimension,
    find_dimension,
)
from kinegrade.problem.kinds.kinds import (
    Arrow,
    BodyKind,
    Kind,
    Ring,
    Scalar,
    Side,
    Straight,
    Unknown,
    advise_on_units,
    describe_kind,
    require_unit,
    unite_dimensions,
)
from kinegrade.problem.kinds.signatures import CONSTRUCTIONS, ELEMENTARY, Signature
from kinegrade.problem.quantities.functions import QUANTITIES
from kinegrade.problem.template.draft import Draft
from kinegrade.problem.template.meaning.meaning import Scope
from kinegrade.problem.template.meaning.radians import evaluate_literals, require_no_radians
from kinegrade.problem.template.meaning.senses import require_fitting_sign
from kinegrade.problem.template.sentences import DriverSentence, JointSentence
from kinegrade.problem.template.template import Ask, Condition, Published, Wording

_Having = Literal["coordinates", "velocity", "acceleration", "direction"]


@dataclass(frozen=True)
class _Inconsistency:
    """What makes no sense at a place of a template's tables."""

    place: Place
    error: FieldError


def note_inconsistencies(draft: Draft, faults: Faults) -> None:
    """Notes what makes no sense in a template; a wrong unit that explains it all is one fault."""
    found = list(_Consistency(draft, _find_given_kinds(draft)).faults())
    several = len(found) > 1 and not draft.steps
    for one in _wrong_unit(draft, found) if several else found:
        faults.note_error(one.place, one.error)


def _wrong_unit(draft: Draft, found: Sequence[_Inconsistency]) -> Sequence[_Inconsistency]:
    """The unit of the parameter without which nothing would be found; else all that was found."""
    first = found[0]
    for name, parameter in draft.parameters.items():
        if not list(_Consistency(draft, {**_find_given_kinds(draft), name: Unknown()}).faults()):
            what = Message(
                "template.unit-misfit",
                unit=Quoted(parameter.unit.text),
                name=name,
                count=len(found),
                place=key_path(first.place),
                fault=first.error.what,
            )
            error = FieldError(what, first.error.expected, first.error.do)
            return [_Inconsistency(("parameters", name, "unit"), error)]
    return found


def _find_given_kinds(draft: Draft) -> dict[str, Kind]:
    """The parameters as numbers of their dimensions."""
    return {
        name: Scalar(find_dimension(parameter.unit)) for name, parameter in draft.parameters.items()
    }


@dataclass(frozen=True)
class _Consistency:
    """Checks one draft; `parameters` are the kinds of its parameters."""

    draft: Draft
    parameters: Mapping[str, Kind]

    def faults(self) -> Iterator[_Inconsistency]:
        """Every fault with its place."""
        values = dict(self.parameters)
        places: dict[str, Kind] = {}
        yield from self.lengths(values)
        yield from self._steps(values)
        places = {**values, **{side: Side() for side in BRANCHES}}
        yield from self.points(places)
        scope = self.scope(places, CONSTRUCTIONS)
        for number, joint in self.draft.joints.items():
            yield from _try_kinds(("joints", number), self.joint, scope, joint)
        for number, driver in self.draft.drivers.items():
            yield from _try_kinds(("inputs", number), self.driver, scope, driver)
        for number, condition in self.draft.conditions.items():
            yield from _try_kinds(("conditions", number), self.condition, scope, condition)
        for name, wordings in self.draft.texts.items():
            yield from self._wordings(name, wordings)
        bodies = {name: BodyKind() for name in (GROUND, *self.draft.bodies)}
        scope = self.scope({**bodies, **places}, QUANTITIES)
        stated = "unit" if self.draft.steps else "quantity"
        for name, ask in self.draft.asks.items():
            yield from _try_kinds(("asks", name, stated), self.ask, scope, ask)
            yield from _try_kinds(("asks", name, "sign"), require_fitting_sign, ask)
        for number, result in self.draft.published.items():
            yield from self.published(number, result)

    def scope(self, names: Mapping[str, Kind], functions: Mapping[str, Signature]) -> Scope:
        """What may be used where these names and functions are known."""
        return Scope(names, functions, frozenset(self.draft.bodies), self.draft.angles)

    def lengths(self, values: dict[str, Kind]) -> Iterator[_Inconsistency]:
        """The named lengths, added to `values` one after another."""
        for name, tree in self.draft.lengths.items():
            scope = self.scope(dict(values), CONSTRUCTIONS)
            values[name] = Unknown()
            yield from _try_kinds(("lengths", name), self.note, values, name, scope, tree)

    def _steps(self, values: dict[str, Kind]) -> Iterator[_Inconsistency]:
        """The steps, numbers each, added to `values` one after another; and what mistakes take them
        for, of the same dimension.
        """
        for name, tree in self.draft.steps.items():
            scope = self.scope(dict(values), ELEMENTARY)
            values[name] = Unknown()
            yield from _try_kinds(("steps", name), self.note, values, name, scope, tree)
        scope = self.scope(dict(values), ELEMENTARY)
        for identifier, mistake in self.draft.mistakes.items():
            for name, tree in mistake.steps.items():
                place = ("mistakes", identifier, "steps", name)
                yield from _try_kinds(place, self._mistaken_step, scope, name, tree)

    def _mistaken_step(self, scope: Scope, name: str, tree: Expression) -> None:
        """What a mistake takes a step for."""
        unite_dimensions(name, scope.kind(Name(name)), scope.kind(tree))

    def note(self, values: dict[str, Kind], name: str, scope: Scope, tree: Expression) -> None:
        """Put the kind of an expression under its name."""
        values[name] = scope.kind(tree)

    def points(self, places: dict[str, Kind]) -> Iterator[_Inconsistency]:
        """The points, added to `places` one after another; each is a point, even where its
        expression is faulty.
        """
        for name, tree in self.draft.points.items():
            scope = self.scope(dict(places), CONSTRUCTIONS)
            places[name] = Arrow(LENGTH, name)
            yield from _try_kinds(("points", name), self.point, scope, tree)

    def point(self, scope: Scope, tree: Expression) -> None:
        """A point: its coordinates are lengths."""
        kind = scope.kind(tree)
        if not isinstance(kind, Arrow | Unknown):
            raise FieldError(describe_kind(kind), Message("template.point-like"))
        _require_dimension(kind, LENGTH, "coordinates")

    def joint(self, scope: Scope, sentence: JointSentence) -> None:
        """A joint: its lines and circles."""
        for shape in (sentence.circle, sentence.on):
            kind = scope.kind(shape) if shape is not None else Unknown()
            if not isinstance(kind, Straight | Ring | Unknown):
                raise FieldError(describe_kind(kind), Message("template.a-shape"))

    def driver(self, scope: Scope, sentence: DriverSentence) -> None:
        """An input: a rotation in rad/s and rad/s^2, the motion of a point in m/s and m/s^2."""
        velocity, acceleration = (RATE, CHANGE) if sentence.stated.TURNS else (SPEED, ACCELERATION)
        _require_dimension(_require_number(scope.kind(sentence.velocity)), velocity, "velocity")
        _require_dimension(
            _require_number(scope.kind(sentence.acceleration)), acceleration, "acceleration"
        )
        if sentence.along is None:
            return
        require_no_radians(sentence.along)
        direction = scope.kind(sentence.along)
        if not isinstance(direction, Scalar | Unknown):
            raise FieldError(
                Message("template.moves-along", kind=describe_kind(direction)),
                Message("template.a-direction"),
            )
        _require_dimension(direction, NUMBER, "direction")

    def condition(self, scope: Scope, condition: Condition) -> None:
        """A condition: two numbers of one dimension, made of what is known."""
        unite_dimensions(
            Quoted(condition.text),
            _require_number(scope.kind(condition.left)),
            _require_number(scope.kind(condition.right)),
        )

    def _wordings(self, name: str, wordings: Mapping[int, Wording]) -> Iterator[_Inconsistency]:
        """The conditions by which the wording of a text is chosen."""
        scope = self.scope(self.parameters, ELEMENTARY)
        for number, one in wordings.items():
            if one.condition is not None:
                place = ("text", name, number, "if")
                yield from _try_kinds(place, self.condition, scope, one.condition)

    def ask(self, scope: Scope, ask: Ask) -> None:
        """An ask: a number of the dimension of its unit."""
        kind = scope.kind(ask.quantity)
        if not isinstance(kind, Scalar | Unknown):
            raise FieldError(
                describe_kind(kind), Message("template.a-number"), Message("template.of-a-vector")
            )
        require_unit(kind, ask.unit, _list_units)
        for part in walk(ask.quantity):
            if isinstance(part, Operation) and part.sign in SUMS:
                _require_no_number(scope, part.left, part.right)
                _require_no_number(scope, part.right, part.left)

    def published(self, number: int, result: Published) -> Iterator[_Inconsistency]:
        """Published results, of the dimension of what they are results of.

        Where the source states values with units that a result does not name, they are contained
        in its numbers: the dimension is then unknown.
        """
        for name, tree in result.gives.items():
            hidden = bool(self.stated(result) - set(find_names(tree)))
            kinds = dict.fromkeys(self.parameters, Unknown()) if hidden else self.parameters
            scope = self.scope(kinds, ELEMENTARY)
            ask = None if hidden else self.draft.asks.get(name)
            yield from _try_kinds(
                ("published", number, "gives", name), self.result, scope, tree, ask
            )

    def stated(self, result: Published) -> set[str]:
        """The parameters with a dimension for which a source states a value other than zero."""
        return {
            name
            for name, text in result.given.items()
            if text != "0" and self.parameters.get(name) != Scalar(NUMBER)
        }

    def result(self, scope: Scope, tree: Expression, ask: Ask | None) -> None:
        """A published result: a number, of the dimension of the ask's unit where that is known."""
        kind = _require_number(scope.kind(tree))
        if ask is not None:
            require_unit(kind, ask.unit, _list_units)


def _try_kinds(
    place: Place, work: Callable[..., None], *arguments: Any
) -> Iterator[_Inconsistency]:
    """The fault that `work` finds in its arguments, with its place."""
    try:
        work(*arguments)
    except FieldError as error:
        yield _Inconsistency(place, error)
    except ExpressionError as error:
        for problem in error.faults:
            yield _Inconsistency(place, FieldError(problem))


def _require_number(kind: Kind) -> Kind:
    """A kind that must be a number. Raises FieldError for anything else."""
    if not isinstance(kind, Scalar | Unknown):
        raise FieldError(describe_kind(kind), Message("template.a-number"))
    return kind


def _require_dimension(kind: Kind, expected: Dimension, having: _Having) -> None:
    """Raises FieldError where a kind has another dimension than is expected."""
    found = kind.dimension if isinstance(kind, Scalar | Arrow) else None
    if found is not None and found != expected:
        raise FieldError(
            Message(f"template.its-{having}", dimension=describe_dimension(found)),
            describe_dimension(expected),
            advise_on_units(found, expected),
        )


def _require_no_number(scope: Scope, one: Expression, other: Expression) -> None:
    """Raises FieldError for a number other than zero that is added to what has a dimension."""
    number, kind = evaluate_literals(one), scope.kind(other)
    found = kind.dimension if isinstance(kind, Scalar) else None
    if number and found not in (None, NUMBER):
        what = Message(
            "template.added-number", number=str(number), dimension=describe_dimension(found)
        )
        raise FieldError(what, do=Message("template.added-with-unit"))


def _list_units(found: Dimension) -> Message:
    """The units in SI that a dimension may be counted in."""
    units = ("rad", "deg", "1") if found == NUMBER else (found.unit,)
    return Message("template.write-unit", units=list_choices(map(Quoted, units)))
