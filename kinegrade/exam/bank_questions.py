"""The entries [[questions]] of a bank's file: a template by its name, or some that are drawn by
family or tag.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from pathlib import Path
from typing import Any

from kinegrade.errors import KinegradeError, did_you_mean
from kinegrade.exact.angle import Inexact
from kinegrade.exact.field import Field
from kinegrade.exam.bank_values import Values
from kinegrade.exam.blueprint import BankAsk, BankQuestion, Slot
from kinegrade.exam.points import shared
from kinegrade.exam.shipped_templates import Shelf, read_shelf
from kinegrade.expression import read
from kinegrade.problem.assemble import parameter_value
from kinegrade.problem.domain import read_choices
from kinegrade.problem.library import load_template
from kinegrade.problem.statement import check_statements
from kinegrade.problem.tags import KINDS, asked_about
from kinegrade.problem.template import Template
from kinegrade.problem.tolerance import Tolerance

TEMPLATE_FILE = re.compile(r"[\w. -]{1,100}\.toml")
DRAWN_KEYS = ("number", "without", "asks", "points", "tolerance")
ENTRY_KEYS = {
    "template": ("template", "asks", "draw", "points", "tolerance"),
    "family": ("family", *DRAWN_KEYS),
    "tag": ("tag", *DRAWN_KEYS),
}
MAX_QUESTIONS, MAX_POINTS = 50, 1000


@dataclass(frozen=True)
class Entries:
    """Reads entries; `folder` holds the templates, `values` collects the faults."""

    values: Values
    folder: Path

    def slots(self, place: str, entry: Any, first: int, tolerance: Tolerance) -> tuple[Slot, ...]:
        """The questions of one entry, numbered from `first`; none where it cannot be made out."""
        kinds = [key for key in ENTRY_KEYS if key in entry] if isinstance(entry, dict) else []
        if len(kinds) != 1 or not isinstance(entry[kinds[0]], str):
            self.values.fault(
                place,
                'expected a table with one of template = "...", family = "..." and tag = "..."',
            )
            return ()
        self.values.unknown_keys(place, entry, ENTRY_KEYS[kinds[0]])
        if kinds[0] == "template":
            return self.named(place, entry, f"q{first}", tolerance)
        return self.drawn(place, entry, kinds[0], first, tolerance)

    def named(
        self, place: str, entry: Mapping[str, Any], identifier: str, tolerance: Tolerance
    ) -> tuple[Slot, ...]:
        """The question of a template that the bank names."""
        template = self.template(f"{place}.template", entry["template"])
        if template is None:
            return ()
        own = self.values.tolerance(f"{place}.tolerance", entry.get("tolerance"), tolerance)
        asks = self.asks(place, entry, template, own)
        question = BankQuestion(identifier, template, asks, self.domains(place, entry, template))
        return (Slot(identifier, (question,), drawn=False),)

    def drawn(
        self, place: str, entry: Mapping[str, Any], by: str, first: int, tolerance: Tolerance
    ) -> tuple[Slot, ...]:
        """The questions whose templates are drawn by family or tag."""
        number = self.values.whole(f"{place}.number", entry.get("number", 1), 1, MAX_QUESTIONS)
        own = self.values.tolerance(f"{place}.tolerance", entry.get("tolerance"), tolerance)
        pool = self.pool(place, entry, by)
        asks = self.weighed(place, entry, pool, own)
        candidates = [template for template in pool if template.name in asks]
        if pool and not candidates and entry.get("asks", "") in ("", *KINDS):
            self.values.fault(
                f"{place}.asks", f'no template of the {by} "{entry[by]}" asks this with points'
            )
        return tuple(
            Slot(
                identifier,
                tuple(
                    BankQuestion(identifier, template, asks[template.name], {})
                    for template in candidates
                ),
                drawn=True,
            )
            for identifier in (f"q{first + index}" for index in range(number))
            if candidates
        )

    @cached_property
    def shelf(self) -> Shelf:
        """All shipped templates, read when an entry first draws from them."""
        try:
            return read_shelf(self.folder)
        except KinegradeError as error:
            for problem in error.problems:
                self.values.fault("", problem)
        return Shelf({}, {"family": {}, "tag": {}})

    def pool(self, place: str, entry: Mapping[str, Any], by: str) -> list[Template]:
        """The templates of a family or with a tag, without those that the entry leaves out."""
        found = self.shelf.having(by, entry[by])
        if not found:
            self.values.fault(
                f"{place}.{by}",
                f'no shipped template has the {by} "{entry[by]}": '
                f"{did_you_mean(entry[by], self.shelf.known(by))}",
            )
            return []
        names, without = [template.name for template in found], entry.get("without", [])
        if not isinstance(without, list) or not all(isinstance(name, str) for name in without):
            self.values.fault(
                f"{place}.without", 'expected a list of templates like ["slider-crank"]'
            )
            return []
        for name in (name for name in without if name not in names):
            self.values.fault(
                f"{place}.without", f'"{name}" would not be drawn: {did_you_mean(name, names)}'
            )
        if set(names) <= set(without):
            self.values.fault(
                f"{place}.without", f'leaves no template of the {by} "{entry[by]}": leave out fewer'
            )
        return [template for template in found if template.name not in without]

    def template(self, place: str, name: str) -> Template | None:
        """A shipped template, or a file beside the bank."""
        if name.endswith(".toml") and not TEMPLATE_FILE.fullmatch(name):
            self.values.fault(
                place, f"{name!r:.60}: expected a file beside the bank, without folders"
            )
            return None
        path = str(self.values.path.parent / name) if name.endswith(".toml") else name
        try:
            template = load_template(path, self.folder)
            check_statements(template)
        except KinegradeError as error:
            for problem in error.problems:
                self.values.fault(place, problem)
            return None
        return template

    def asks(
        self, place: str, entry: Mapping[str, Any], template: Template, tolerance: Tolerance
    ) -> tuple[BankAsk, ...]:
        """What is asked: as the bank says, or what the template gives points."""
        chosen = entry.get("asks", "")
        if isinstance(chosen, dict) and chosen:
            if "points" in entry:
                self.values.fault(
                    f"{place}.points", "asks says the points already: leave one of the two out"
                )
            found = [
                self.ask(f"{place}.asks.{name}", name, value, template, tolerance)
                for name, value in chosen.items()
            ]
            return tuple(ask for ask in found if ask is not None)
        asked = self.weighed(place, entry, [template], tolerance).get(template.name, ())
        if not asked and (chosen == "" or chosen in KINDS):
            self.values.fault(
                f"{place}.asks",
                f"{template.name} gives points to nothing of this: expected a table of "
                "asks with their points, like { v_B = 3 }",
            )
        return asked

    def weighed(
        self,
        place: str,
        entry: Mapping[str, Any],
        templates: Sequence[Template],
        tolerance: Tolerance,
    ) -> dict[str, tuple[BankAsk, ...]]:
        """What each template asks of the kind that the entry wants, with its points or shares of
        the entry's.
        """
        about = entry.get("asks", "")
        if about != "" and about not in KINDS:
            named = (
                ", or a table of asks with their points, like { v_B = 3 }"
                if "template" in entry
                else ""
            )
            self.values.fault(f"{place}.asks", f"expected one of {', '.join(KINDS)}{named}")
            return {}
        asked = {
            template.name: {
                name: template.asks[name].points for name in asked_about(template, about)
            }
            for template in templates
        }
        total = self.total(f"{place}.points", entry, asked) if "points" in entry else None
        return {
            name: tuple(
                BankAsk(ask, Fraction(points), tolerance)
                for ask, points in (weights if total is None else shared(total, weights)).items()
            )
            for name, weights in asked.items()
            if weights
        }

    def total(
        self, place: str, entry: Mapping[str, Any], asked: Mapping[str, Mapping[str, int]]
    ) -> int | None:
        """The points that are to be shared out, at least one for each ask."""
        faults = len(self.values.faults)
        total = self.values.whole(place, entry["points"], 1, MAX_POINTS)
        longest = max(asked, key=lambda name: len(asked[name]), default="")
        if len(self.values.faults) > faults or not longest:
            return None
        if total < len(asked[longest]):
            self.values.fault(
                place, f"{longest} asks {len(asked[longest])} quantities: expected a point for each"
            )
            return None
        return total

    def ask(
        self, place: str, name: str, value: Any, template: Template, tolerance: Tolerance
    ) -> BankAsk | None:
        """One ask: points, or a table with points (default: the template's) and tolerance."""
        if name not in template.asks:
            self.values.fault(
                place, f'{template.name} has no ask "{name}": {did_you_mean(name, template.asks)}'
            )
            return None
        table = value if isinstance(value, dict) else {"points": value}
        self.values.unknown_keys(place, table, ("points", "tolerance"))
        points = self.values.amount(
            f"{place}.points", table.get("points", template.asks[name].points)
        )
        if points is not None and not 0 < points <= MAX_POINTS:
            self.values.fault(f"{place}.points", f"expected more than 0 and at most {MAX_POINTS}")
        own = self.values.tolerance(f"{place}.tolerance", table.get("tolerance"), tolerance)
        return BankAsk(name, points or Fraction(1), own)

    def domains(
        self, place: str, entry: Mapping[str, Any], template: Template
    ) -> dict[str, tuple[str, ...]]:
        """Domains that replace the template's."""
        table = entry.get("draw", {})
        if not isinstance(table, dict):
            self.values.fault(f"{place}.draw", "expected a table like { k = [2, 3] }")
            return {}
        found = {}
        for name, draw in table.items():
            if name not in template.parameters:
                self.values.fault(
                    f"{place}.draw",
                    f'no parameter "{name}": {did_you_mean(name, template.parameters)}',
                )
                continue
            try:
                found[name] = read_choices(draw)
                for text in found[name]:
                    with suppress(Inexact):  # then it is a number all the same
                        parameter_value(template.parameters[name], read(text), Field())
            except KinegradeError as error:
                self.values.fault(f"{place}.draw.{name}", error.problems[0])
        return found
