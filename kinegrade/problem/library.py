"""Where templates and banks are found: those shipped with the package, and files given by their
path.
"""

from __future__ import annotations

from functools import partial
from pathlib import Path

import kinegrade
from kinegrade.errors import TemplateError, did_you_mean
from kinegrade.problem.reading import read_template
from kinegrade.problem.shared_mechanism import FOLDER
from kinegrade.problem.template import Template
from kinegrade.problem.toml_text import MAX_CHARACTERS


def shipped(folder: str) -> Path:
    """The folder of shipped "templates" or "banks": inside an installed package, beside it in a
    checkout.
    """
    package = Path(kinegrade.__file__).parent
    inside = package / folder
    return inside if inside.is_dir() else package.parent / folder


def template_names() -> tuple[str, ...]:
    """The names of the shipped templates, sorted."""
    return tuple(sorted(path.stem for path in shipped("templates").glob("*.toml")))


def load_template(name: str, folder: Path | None = None, *, kept: bool = False) -> Template:
    """The template of that name in `folder` (default: the shipped ones), or of a path that ends in
    .toml.

    The mechanism that it shares is looked for in the folder `mechanisms` beside it. Raises
    TemplateError when there is no such template, or with all faults of the file; see
    `read_template` for `kept`.
    """
    path = (
        Path(name) if name.endswith(".toml") else (folder or shipped("templates")) / f"{name}.toml"
    )
    known = [other.stem for other in (folder or shipped("templates")).glob("*.toml")]
    if not name.endswith(".toml") and name not in known:
        raise TemplateError(f'no template "{name}": {did_you_mean(name, known)}')
    return read_template(
        path.stem,
        template_text(path),
        partial(mechanism_text, path.parent / FOLDER),
        kept=kept,
    )


def kept_template(name: str, folder: Path) -> Template:
    """The template of that name which an exam keeps in `folder`; rules that came after the exam do
    not refuse it.

    Raises TemplateError when it is not there or cannot be read.
    """
    return load_template(name, folder, kept=True)


def mechanism_text(folder: Path, name: str) -> str:
    """The text of the mechanism of that name in a folder. Raises TemplateError when there is none
    to read.
    """
    known = [other.stem for other in folder.glob("*.toml")]
    if name not in known:
        raise TemplateError(
            f'no mechanism "{name}" in {FOLDER}/ beside the template: {did_you_mean(name, known)}'
        )
    return template_text(folder / f"{name}.toml")


def template_text(path: Path) -> str:
    """The text of a template file. Raises TemplateError when it is missing, too large or no
    UTF-8.
    """
    try:
        with path.open("rb") as file:
            data = file.read(4 * MAX_CHARACTERS + 1)
        if len(data) > 4 * MAX_CHARACTERS:
            raise TemplateError(
                f"{path}: too large: at most {MAX_CHARACTERS} characters are read: shorten it"
            )
        return data.decode("utf-8-sig")
    except OSError as error:
        raise TemplateError(
            f"{path}: cannot be read: {error.strerror}: give the path of a template file"
        ) from error
    except UnicodeDecodeError as error:
        raise TemplateError(
            f"{path}: not UTF-8 at byte {error.start}: save the template as UTF-8"
        ) from error
