"""The shipped templates: processor time of loading them, and of an exact solve of everything that
can be asked.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from statistics import median
from time import process_time

from kinegrade.draws.examining import Refused, solve_sensible
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.template import Template
from kinegrade.processes.garbage_collection import bulk_work
from kinegrade.proof.checking import choose_drawable

INSTANCES = 20


@dataclass(frozen=True)
class Limit:
    """A processor time that must stay below a limit, both in milliseconds."""

    name: str
    value: float
    limit: float

    @property
    def kept(self) -> bool:
        """Whether the promise is kept."""
        return self.value <= self.limit

    def line(self) -> str:
        """The limit as a line of the report."""
        return (
            f"{self.name:<58} {self.value:9.2f} ms  promised: {self.limit:g} ms  "
            f"{'kept' if self.kept else 'BROKEN'}"
        )


def figures() -> Iterator[Limit]:
    """Loading of all templates; median template and slowest instance, all asks, velocity and
    acceleration.
    """
    start = process_time()
    templates = [load_template(name) for name in find_template_names()]
    yield Limit(f"loading all {len(templates)} templates", (process_time() - start) * 1e3, 1000)
    with bulk_work():  # as in `generate`: else the slowest is who meets a search for cycles
        times = {template.name: solving_times(template) for template in templates}
    yield Limit(
        "the median template, all its asks", median(median(each) for each in times.values()), 3
    )
    slowest = max(times, key=lambda name: max(times[name]))
    yield Limit(f"the slowest drawable instance ({slowest})", max(times[slowest]), 50)


def solving_times(template: Template) -> list[float]:
    """Milliseconds of processor time for acceptable instances of a template."""
    times, plan = [], None
    for values in choose_drawable(template, 20 * INSTANCES):
        try:
            plan = solve_sensible(template, values, template.asked(), plan).motion.plan
        except Refused:
            continue
        start = process_time()
        solve_template(template, values, None, plan)
        times.append((process_time() - start) * 1e3)
        if len(times) == INSTANCES:
            break
    return times
