"""Papers and solutions pass PDF/UA-1, one by one and joined: all templates in all their languages."""

from __future__ import annotations

from pathlib import Path

from kinegrade.exam.printing.sample import print_sample, print_worked_solution
from kinegrade.press.join import join_pages
from tests.press.accessible import list_failed_rules
from tests.prove.draws import seeded_solution


def hold(seed: int, _: Path) -> None:
    """Print the paper and the solution of an instance, in one language after the other."""
    solution = seeded_solution(seed)
    template = solution.template
    languages = template.words.statement.languages
    language = languages[seed % len(languages)]
    paper = print_sample(template, f"prove {seed}", language)
    worked = print_worked_solution(solution, language)
    for pdf in (paper, worked, join_pages([paper, worked])):
        assert list_failed_rules(pdf) == [], f"{template.name} ({language})"
