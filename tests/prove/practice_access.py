"""Practice sheets of all templates are open to everybody, each in a language at random."""

from __future__ import annotations

from pathlib import Path
from random import Random

from tests.browsers.page import open_page
from tests.practice.accessible_sheet import find_barriers
from tests.practice.test_accessible_sheet import write_sheet
from tests.prove.draws import seeded_template


def hold(seed: int, folder: Path) -> None:
    """Look for barriers on the sheet of the template of a seed."""
    template = seeded_template(seed)
    languages = template.words.statement.languages
    language = Random(seed).choice(languages)
    with open_page() as page:
        found = list(find_barriers(page, write_sheet(template.name, language, folder)))
    assert not found, f"{template.name} ({language}): " + " ".join(found)
