"""Where templates and banks are found: those shipped with the package, and files given by their
path.
"""

from __future__ import annotations

from functools import partial
from pathlib import Path

import kinegrade
from kinegrade.errors import FieldError, TemplateError, suggest
from kinegrade.files.fields.document import read_text
from kinegrade.language.message import Message, Quoted
from kinegrade.problem.template.beside import is_translation, read_translations
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.sections.opening import FOLDER, TEMPLATE
from kinegrade.problem.template.template import MechanismFile, Template


def find_shipped(folder: str) -> Path:
    """The folder of shipped "templates" or "banks": inside an installed package, beside it in a
    checkout.
    """
    package = Path(kinegrade.__file__).parent
    inside = package / folder
    return inside if inside.is_dir() else package.parent / folder


def find_template_names() -> tuple[str, ...]:
    """The names of the shipped templates, sorted."""
    return tuple(list_names(find_shipped("templates")))


def list_names(folder: Path) -> list[str]:
    """The names of the TOML files in a folder, sorted, without translations beside others."""
    return sorted(path.stem for path in folder.glob("*.toml") if not is_translation(path))


def load_template(
    name: str, folder: Path | None = None, *, kept: bool = False, steps: bool = False
) -> Template:
    """The template of that name in `folder` (default: the shipped ones), or of a path that ends in
    .toml.

    The mechanism that it shares is looked for in the folder `mechanisms` beside it. Raises
    TemplateError when there is no such template, or with all faults of the file; see
    `read_template` for `kept` and `steps`.
    """
    path = (
        Path(name)
        if name.endswith(".toml")
        else (folder or find_shipped("templates")) / f"{name}.toml"
    )
    known = list_names(folder or find_shipped("templates"))
    if not name.endswith(".toml") and name not in known:
        raise TemplateError(
            Message("template.no-template", name=Quoted(name), hint=suggest(name, known))
        )
    return read_template(
        path.stem,
        read_text(path, TEMPLATE),
        partial(_read_mechanism, path.parent / FOLDER),
        read_translations(path, TEMPLATE),
        kept=kept,
        steps=steps,
    )


def load_kept_template(name: str, folder: Path) -> Template:
    """The template of that name which an exam keeps in `folder`; rules that are newer than the exam
    do not refuse it.

    Raises TemplateError when it is missing or cannot be read.
    """
    return load_template(name, folder, kept=True)


def _read_mechanism(folder: Path, name: str) -> MechanismFile:
    """The mechanism of that name in a folder. Raises FieldError when there is none,
    TemplateError when it cannot be read.
    """
    known = list_names(folder)
    if name not in known:
        what = Message("template.no-mechanism", name=Quoted(name), folder=FOLDER)
        raise FieldError(what, do=suggest(name, known))
    path = folder / f"{name}.toml"
    return MechanismFile(name, read_text(path, TEMPLATE), read_translations(path, TEMPLATE))
