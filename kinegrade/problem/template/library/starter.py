"""The starter template: a complete mechanism with every table of a template, for an author to write
over.
"""

from __future__ import annotations

from pathlib import Path

from kinegrade.errors import TemplateError
from kinegrade.files.output import write_file
from kinegrade.files.starter import read_starter_text
from kinegrade.language.message import Fault, Message
from kinegrade.problem.template.library.reading import read_template


def write_starter_text() -> str:
    """The starter as TOML."""
    return read_starter_text("kinegrade.problem.template.library")


def write_starter(name: str, path: Path | None = None, *, force: bool = False) -> Path:
    """Writes the starter as the template `name`, by default to NAME.toml in the current folder;
    gives its path.

    Raises TemplateError for what cannot be a template's name, and for a path that does not end in
    it; OutputError where the file exists, unless `force`.
    """
    text = write_starter_text()
    read_template(name, text)
    target = path if path is not None else Path(f"{name}.toml")
    if target.name != f"{name}.toml":
        raise TemplateError(Fault(str(target), Message("template.starter-name", name=name)))
    write_file(target, text.encode("utf-8"), "toml", force=force)
    return target
