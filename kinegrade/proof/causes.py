"""Why draws are refused, cause by cause: how many, at which values, and what would help."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from kinegrade.draws.deck import Combination
from kinegrade.draws.examining import Examined, Reason, Refused, name_reason
from kinegrade.errors import Problem
from kinegrade.expressions.tree import SUMS, Number, Operation, find_names, walk
from kinegrade.language.message import Fault, Message
from kinegrade.problem.kinds.dimension import find_si_unit
from kinegrade.problem.template.template import Condition, Template

_LEAST = 0.02  # of the draws: a rarer cause is not worth a line
_MOST = 8  # causes that are told
_ALWAYS = (
    0.9  # of a cause's draws have a value that is to blame, and no more than this of all draws
)
_ENOUGH = 5  # draws of a cause from which on a value may be blamed


@dataclass(frozen=True)
class Cause:
    """What refused some of the draws, told by the first of them, and the draws themselves."""

    reason: Reason
    what: Problem
    draws: tuple[Combination, ...]


def find_causes(
    draws: Sequence[Combination], found: Sequence[Examined | Refused]
) -> tuple[Cause, ...]:
    """The causes for which draws were refused, the most frequent first. Refusals for one condition,
    symbol, ask or mistake are of one cause.
    """
    groups: dict[tuple[Reason, object], list[tuple[Combination, Refused]]] = defaultdict(list)
    for values, verdict in zip(draws, found, strict=True):
        if isinstance(verdict, Refused):
            groups[verdict.reason, _identify(verdict)].append((values, verdict))
    causes = [
        Cause(reason, group[0][1].detail, tuple(values for values, _ in group))
        for (reason, _), group in groups.items()
    ]
    return tuple(sorted(causes, key=lambda cause: -len(cause.draws)))


def _identify(refused: Refused) -> object:
    """What tells one cause from another: not the numbers in what is said."""
    detail = refused.detail
    if refused.reason == "mistake":
        return detail
    return refused.ask or (detail.where if isinstance(detail, Fault) else detail)


def write_causes(
    template: Template, causes: Sequence[Cause], draws: Sequence[Combination]
) -> Iterator[Message]:
    """A line for each cause that is worth one: what, in how many draws, at which value, and what
    numbers in a condition mean where that may be the mistake.
    """
    for cause in causes[:_MOST]:
        if len(cause.draws) < _LEAST * len(draws):
            continue
        line = Message(
            "template.report-cause",
            reason=name_reason(cause.reason),
            what=cause.what,
            number=len(cause.draws),
            examined=len(draws),
        )
        yield _explain(template, cause, draws, line)


def _explain(
    template: Template, cause: Cause, draws: Sequence[Combination], line: Message
) -> Message:
    """The line with what would help, where that is seen."""
    blamed = _find_blamed(cause, draws)
    if blamed is not None:
        name, value = blamed
        unit = template.parameters[name].unit.printed
        return Message("template.cause-at", line=line, given=name, value=f"{value} {unit}".strip())
    if cause.reason == "figure":
        return Message("template.cause-in-figure", line=line)
    stated = {each.text: each for each in template.scheme.conditions}
    if cause.reason == "condition" and isinstance(cause.what, str) and cause.what in stated:
        units = _find_converted(template, stated[cause.what])
        if units and len(cause.draws) > len(draws) / 2:
            return Message("template.cause-in-si", line=line, given=units[0])
    return line


def _find_blamed(cause: Cause, draws: Sequence[Combination]) -> tuple[str, str] | None:
    """The given and its one value at which nearly all draws of a cause are, although others are
    drawn as well; None where there is none.
    """
    if len(cause.draws) < _ENOUGH:
        return None
    for name in cause.draws[0]:
        [(value, times)] = Counter(values[name] for values in cause.draws).most_common(1)
        among = sum(values[name] == value for values in draws)
        if times >= _ALWAYS * len(cause.draws) and among < _ALWAYS * len(draws):
            return name, value
    return None


def _find_converted(template: Template, condition: Condition) -> list[str]:
    """The givens of a condition whose units are not those of SI, where a number stands alone in it,
    added or compared.
    """
    sides = (condition.left, condition.right)
    parts = [part for side in sides for part in walk(side)]
    sums = [part for part in parts if isinstance(part, Operation) and part.sign in SUMS]
    alone = [*sides, *(part for each in sums for part in (each.left, each.right))]
    if not any(isinstance(part, Number) and part.value != 0 for part in alone):
        return []
    names = [name for side in sides for name in find_names(side) if name in template.parameters]
    units = {name: template.parameters[name].unit for name in names}
    return [name for name, unit in units.items() if find_si_unit(unit) != unit]
