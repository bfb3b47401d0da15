"""What `kinegrade check` says of the template that is shown."""

from __future__ import annotations

from kinegrade.exam.printing.template_proof import prove_template
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.press.html.filled_page import load_layout
from kinegrade.preview.subject import Subject

_SAMPLE = 200  # as of the command


def write_check(subject: Subject, language: Language) -> str:
    """The verdict and what was found, a line each."""
    words, proof = open_catalogue(language), prove_template(subject.question.template, _SAMPLE)
    return load_layout("preview-check.html").render(
        sound=proof.sound,
        verdict=words.write(proof.verdict),
        findings=[words.write(finding) for finding in proof.findings],
    )
