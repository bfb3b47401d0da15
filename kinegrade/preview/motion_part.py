"""The figure that moves: a page of its own, which stands inside the preview."""

from __future__ import annotations

from markupsafe import Markup

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.press.html.filled_page import load_layout
from kinegrade.preview.instance import Instance
from kinegrade.preview.subject import Subject
from kinegrade.public.cycles import animate


def write_motion(subject: Subject, language: Language) -> str:
    """The mechanism through its cycle, from the instance that is shown. Raises MechanismError where
    nothing can move.
    """
    moving, words = animate(Instance(subject.question).solution, language), open_catalogue(language)
    return load_layout("preview-motion.html").render(
        tag=words.text("language.tag"),
        title=words.text("preview.page.motion"),
        moving=Markup(moving.html),
    )
