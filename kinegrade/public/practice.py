"""`kinegrade practice`: a sheet to practise on, as one page or as a SCORM package."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from kinegrade.exam.bank.blueprint import Blueprint
from kinegrade.files.output import write_file
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message
from kinegrade.lms.scorm import write_scorm_package
from kinegrade.practice.making import make_practice_sheet
from kinegrade.practice.page import write_page
from kinegrade.public.outcome import Outcome


@dataclass(frozen=True)
class PracticeOptions:
    """How many draws of each question the sheet has, chosen by the words `seed`; with `scorm` it is
    a package that tells its score to the system around it.
    """

    draws: int = 20
    seed: str = "practice"
    scorm: bool = False


def write_practice(
    blueprint: Blueprint,
    target: Path,
    language: Language,
    options: PracticeOptions,
    *,
    force: bool = False,
) -> Outcome:
    """Write the practice sheet of a bank. Raises KinegradeError; then nothing is written."""
    made = make_practice_sheet(blueprint, options.draws, options.seed, language)
    page = write_page(made.sheet, language, scorm=options.scorm)
    if options.scorm:
        title = open_catalogue(language).text("practice.title", title=made.sheet.title)
        write_scorm_package(page, title, target, force=force)
    else:
        write_file(target, page.encode(), "html", force=force)
    size = max(1, round(len(page.encode()) / 1000))
    count = len(made.sheet.questions)
    written = Message("practice.written", file=str(target), count=count, size=size)
    return Outcome(target, (written, *made.notes))
