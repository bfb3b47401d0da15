"""Templates for an author to write over: the starter, a complete mechanism with every table, or a
copy of a shipped template.
"""

from __future__ import annotations

from pathlib import Path

from kinegrade.errors import TemplateError
from kinegrade.files.output import write_file
from kinegrade.files.starter import read_starter_text
from kinegrade.language import ENGLISH, Language
from kinegrade.language.message import Fault, Message
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.sections.opening import FOLDER, require_file_name
from kinegrade.problem.template.template import MechanismFile


def write_starter_text(language: Language = ENGLISH) -> str:
    """The starter as TOML, explained in a language; one that is not in English says everything in
    that language alone.
    """
    return read_starter_text("kinegrade.problem.template.library", language)


def write_starter(
    name: str,
    path: Path | None = None,
    *,
    like: str = "",
    language: Language = ENGLISH,
    force: bool = False,
) -> Path:
    """Writes the starter, or the shipped template `like` which it is to be, as the template `name`,
    by default to NAME.toml in the current folder; gives its path. A mechanism that the shipped one
    shares with others is written into `mechanisms/` beside it, unless one of its name is there.

    Raises TemplateError for what cannot be a template's name, for a path that does not end in it
    and where there is no template `like`; OutputError where the file exists, unless `force`.
    """
    file = load_template(like).file if like else None
    text = file.text if file is not None else write_starter_text(language)
    require_file_name(name)
    target = path if path is not None else Path(f"{name}.toml")
    if target.name != f"{name}.toml":
        raise TemplateError(Fault(str(target), Message("template.starter-name", name=name)))
    write_file(target, text.encode("utf-8"), "toml", force=force)
    if file is not None and file.mechanism is not None:
        _write_mechanism(file.mechanism, target.parent / FOLDER)
    return target


def _write_mechanism(mechanism: MechanismFile, folder: Path) -> None:
    """A shared mechanism, where the folder does not have it."""
    file = folder / f"{mechanism.name}.toml"
    if not file.exists():
        folder.mkdir(exist_ok=True)
        write_file(file, mechanism.text.encode("utf-8"), "toml")
