"""Looking ahead at draws, many at a time: which of them a known mistake would confuse with the
truth.

A look costs about the same for one instance and for hundreds; what it saw is kept until it is asked
for.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from math import ceil

from kinegrade.errors import KinegradeError
from kinegrade.problem.separation import Separation, separation
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template import Template
from kinegrade.problem.tolerance import Tolerance

TRIED = 24  # instances of a sample that are solved in search of a plan
MOST = 32  # attempts of one student that are looked at together
Draw = Mapping[str, str]


@dataclass
class DrawScreening:
    """What was seen of draws, by their values; nothing confuses draws of which no sample could be
    solved.
    """

    separation: Separation | None
    seen: dict[tuple[str, ...], bool] = field(default_factory=dict)

    @property
    def attempts(self) -> int:
        """How many attempts of a student are worth looking at together: most often one of them will
        do.
        """
        usable = 1.0 if self.separation is None else self.separation.usable
        return min(MOST, ceil(2 / max(usable, 1 / MOST)))

    def look(self, draws: Iterable[Draw]) -> None:
        """See which of the draws a mistake would confuse."""
        new = {
            tuple(draw.values()): draw for draw in draws if tuple(draw.values()) not in self.seen
        }
        if self.separation is None or not new:
            self.seen.update(dict.fromkeys(new, False))
        else:
            self.seen.update(
                zip(
                    new, self.separation.confuses(columns(list(new.values()))).tolist(), strict=True
                )
            )


def draw_screening(
    template: Template,
    asks: Sequence[str],
    tolerances: Mapping[str, Tolerance],
    sample: Sequence[Draw],
) -> DrawScreening:
    """Ready to look at draws of a question, of which `sample` shows what mistakes can be kept apart
    at all.

    Where nothing is asked, as of a template whose asks are all on request, no mistake confuses
    anything.
    """
    if not asks:
        return DrawScreening(None)
    for draw in sample[:TRIED]:
        try:
            plan = solve_template(template, draw, asks).motion.plan
        except KinegradeError:
            continue
        return DrawScreening(
            separation(
                template,
                {name: template.asks[name] for name in asks},
                tolerances,
                plan,
                columns(sample),
            )
        )
    return DrawScreening(None)


def columns(draws: Sequence[Draw]) -> dict[str, list[str]]:
    """For each parameter its values in all draws."""
    return {name: [draw[name] for draw in draws] for name in draws[0]}
