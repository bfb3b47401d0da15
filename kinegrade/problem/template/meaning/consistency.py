"""Whether a template's expressions make sense before any numbers are put in: functions, kinds and
dimensions.

What is asked for must have the dimension of its unit, points the dimension of a length, inputs that
of a rate or of a velocity.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from kinegrade.errors import ExpressionError, FieldError
from kinegrade.expressions.tree import Expression, Name, find_names
from kinegrade.files.fields.faults import Faults
from kinegrade.files.fields.place import Place, key_path
from kinegrade.language.message import Message, Quoted
from kinegrade.mechanics.branches import BRANCHES
from kinegrade.mechanics.joints import GROUND
from kinegrade.problem.kinds.dimension import LENGTH, NUMBER, find_dimension
from kinegrade.problem.kinds.kinds import (
    Arrow,
    BodyKind,
    Kind,
    Scalar,
    Side,
    Unknown,
    require_unit,
    unite_dimensions,
)
from kinegrade.problem.kinds.signatures import CONSTRUCTIONS, ELEMENTARY, Signature
from kinegrade.problem.quantities.functions import QUANTITIES
from kinegrade.problem.template.draft import Draft
from kinegrade.problem.template.meaning.meaning import Scope
from kinegrade.problem.template.meaning.required_kinds import list_units, require_number
from kinegrade.problem.template.meaning.senses import require_fitting_sign
from kinegrade.problem.template.meaning.stated_parts import (
    check_ask,
    check_condition,
    check_driver,
    check_joint,
    check_point,
)
from kinegrade.problem.template.template import Ask, Published, Wording


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
            yield from _try_kinds(("joints", number), check_joint, scope, joint)
        for number, driver in self.draft.drivers.items():
            yield from _try_kinds(("inputs", number), check_driver, scope, driver)
        for number, condition in self.draft.conditions.items():
            yield from _try_kinds(("conditions", number), check_condition, scope, condition)
        for name, wordings in self.draft.texts.items():
            yield from self._wordings(name, wordings)
        bodies = {name: BodyKind() for name in (GROUND, *self.draft.bodies)}
        scope = self.scope({**bodies, **places}, QUANTITIES)
        stated = "unit" if self.draft.steps else "quantity"
        for name, ask in self.draft.asks.items():
            yield from _try_kinds(("asks", name, stated), check_ask, scope, ask)
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
            yield from _try_kinds(("points", name), check_point, scope, tree)

    def _wordings(self, name: str, wordings: Mapping[int, Wording]) -> Iterator[_Inconsistency]:
        """The conditions by which the wording of a text is chosen."""
        scope = self.scope(self.parameters, ELEMENTARY)
        for number, one in wordings.items():
            if one.condition is not None:
                place = ("text", name, number, "if")
                yield from _try_kinds(place, check_condition, scope, one.condition)

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
        kind = require_number(scope.kind(tree))
        if ask is not None:
            require_unit(kind, ask.unit, list_units)


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
