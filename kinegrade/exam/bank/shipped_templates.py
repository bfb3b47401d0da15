"""The shelf of shipped templates, from which a bank draws by family or tag."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, TypeAlias

from kinegrade.errors import BankError, KinegradeError, Problem
from kinegrade.problem.template.library.library import list_names, load_template
from kinegrade.problem.template.tags import list_tags
from kinegrade.problem.template.template import Template

Grouping: TypeAlias = Literal["family", "tag"]  # what a bank may draw by


@dataclass(frozen=True)
class Shelf:
    """Templates in alphabetical order, found by words: `words["tag"][name]` are the tags of a
    template.
    """

    templates: Mapping[str, Template]
    words: Mapping[Grouping, Mapping[str, frozenset[str]]]

    def having(self, by: Grouping, word: str) -> tuple[Template, ...]:
        """The templates of a family or with a tag."""
        return tuple(
            template for name, template in self.templates.items() if word in self.words[by][name]
        )

    def known(self, by: Grouping) -> frozenset[str]:
        """All families, or all tags."""
        return frozenset().union(*self.words[by].values())


def read_shelf(folder: Path, *, kept: bool = False) -> Shelf:
    """All templates of a folder; in one that is `kept` with an exam, none is refused by a rule
    introduced after the exam.

    Raises BankError with the faults of all of them.
    """
    templates: dict[str, Template] = {}
    faults: list[Problem] = []
    for name in list_names(folder):
        try:
            templates[name] = load_template(name, folder, kept=kept)
        except KinegradeError as error:
            faults += error.faults
    if faults:
        raise BankError(*faults)
    families = {name: frozenset({template.about.family}) for name, template in templates.items()}
    return Shelf(
        templates,
        {
            "family": families,
            "tag": {name: list_tags(template) for name, template in templates.items()},
        },
    )
