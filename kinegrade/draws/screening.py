"""What need not be solved exactly to be refused: instances that doubles, many at once, show to be
unfit for students.

Only what is clear is refused here; whatever lies next to a limit is left to the exact solution.
"""

from __future__ import annotations

from math import isfinite

from kinegrade.draws.examining import Refused, explain_rounding
from kinegrade.language.message import Message
from kinegrade.students.comparison import Comparison
from kinegrade.students.rounding.accuracy import Accuracy
from kinegrade.students.separation import Separation


def screen(separation: Separation, accuracy: Accuracy, seen: Comparison) -> list[Refused | None]:
    """For each instance that was compared why it is refused, None where doubles see no reason."""
    confused = separation.find_confused(seen)
    conditions = separation.template.scheme.conditions
    found: list[Refused | None] = []
    for place, unmet in enumerate(seen.unmet.tolist()):
        if confused[place]:
            found.append(_name_mistake(separation, seen, place))
        elif unmet >= 0:
            found.append(Refused("condition", conditions[unmet].text))
        else:
            valued = separation.template.scheme.has_mechanism or _has_values(seen, place)
            found.append(_find_strayed(accuracy, seen, place) if valued else None)
    return found


def _name_mistake(separation: Separation, seen: Comparison, place: int) -> Refused:
    """The refusal for the first mistake that lands too near the truth, with its ask."""
    ask, mistake = separation.find_confusing(seen, place)
    return Refused("mistake", Message("template.mistake-lands", ask=ask, mistake=mistake), ask)


def _has_values(seen: Comparison, place: int) -> bool:
    """Whether all steps of an instance have a value; why one has none, the exact solution says."""
    return all(isfinite(right[place]) for right in seen.right.values())


def _find_strayed(accuracy: Accuracy, seen: Comparison, place: int) -> Refused | None:
    """The refusal for the first ask whose tolerance honest rounding leaves."""
    for name, strayed in seen.strayed.items():
        if strayed[place]:
            why = explain_rounding(name, float(seen.roundings[name].bound[place]), accuracy)
            return Refused("rounding", why, name)
    return None
