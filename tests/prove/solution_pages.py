"""A worked solution takes at most two pages at any draw, as at the published values."""

from __future__ import annotations

from pathlib import Path

from kinegrade.language import Language
from kinegrade.problem.template.library.library import find_template_names, load_template
from tests.prove.draws import seeded_solution
from tests.worked.lengths import measure_length, measure_printed_length

LANGUAGES = (Language("en"), Language("zh"))  # in which every template is written
MOST_PAGES = 2


def hold(seed: int, _: Path) -> None:
    """Print the solution of the instance of a seed, in one language after the other."""
    solution = seeded_solution(seed)
    languages = solution.template.words.statement.languages
    length = measure_printed_length(solution, languages[seed % len(languages)])
    assert length.pages <= MOST_PAGES, f"{solution.template.name}: {length.pages} pages"


def hold_short(seed: int, _: Path) -> None:
    """Print the solutions of all templates at their published values, in the language of a seed."""
    language = LANGUAGES[seed % len(LANGUAGES)]
    names = [name for name in find_template_names() if is_written(name, language)]
    pages = {name: measure_length(name, language).pages for name in names}
    long = {name: count for name, count in pages.items() if count > MOST_PAGES}
    assert not long, f"{language}: {long}"


def is_written(name: str, language: Language) -> bool:
    """Whether a template has its texts in a language."""
    return language in load_template(name).words.statement.languages
