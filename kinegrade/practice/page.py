"""The page of a practice sheet: one HTML file that loads nothing from anywhere."""

from __future__ import annotations

from base64 import b64encode
from hashlib import sha256

from markupsafe import Markup

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.practice.document import PracticeSheet
from kinegrade.practice.packing import pack
from kinegrade.practice.script import join_scripts
from kinegrade.practice.vocabulary import list_vocabulary
from kinegrade.practice.wording import collect_wording
from kinegrade.press.html.filled_page import load_layout


def write_page(sheet: PracticeSheet, language: Language, *, scorm: bool = False) -> str:
    """The page; with `scorm` it tells the score to the system around it.

    The script is the only one that a browser runs in it, and nothing may be fetched.
    """
    catalogue = open_catalogue(language)
    script = join_scripts(scorm=scorm)
    return load_layout("practice.html").render(
        tag=catalogue.text("language.tag"),
        sheet=sheet,
        rules=[Markup(rule) for rule in sheet.rules],
        words=catalogue.raw("practice"),
        title=catalogue.text("practice.title", title=sheet.title),
        note=catalogue.text("practice.reported" if scorm else "practice.note"),
        script=Markup(script),
        hash=_hash_script(script),
        baked=Markup(pack(sheet, vocabulary=list_vocabulary(), wording=collect_wording(language))),
    )


def _hash_script(script: str) -> str:
    """The script as a content security policy names it."""
    return f"sha256-{b64encode(sha256(script.encode()).digest()).decode()}"
