"""The practice sheet that the site shows in a frame, made anew."""

from __future__ import annotations

from pathlib import Path

import kinegrade
from kinegrade.language import ENGLISH
from kinegrade.public.practice import PracticeOptions, write_practice

NAME = "practice-sheet.html"
_OPTIONS = PracticeOptions(draws=3, seed="practice", scorm=False)


def write_shown_sheet(folder: Path) -> Path:
    """Write the sheet of the demonstration's bank into a folder that the site takes in whole."""
    folder.mkdir(parents=True, exist_ok=True)
    blueprint = kinegrade.Bank.read("demo").blueprint
    return write_practice(blueprint, folder / NAME, ENGLISH, _OPTIONS, force=True).path
