"""The starters of an instructor's files: complete files with a comment on each key, to be written
over.
"""

from __future__ import annotations

import re
from importlib.resources import files
from pathlib import Path

from kinegrade.errors import OutputError
from kinegrade.files.output import write_file
from kinegrade.language import ENGLISH, Language
from kinegrade.language.message import Fault, Message

_NAME = re.compile(r"\w[\w -]{0,99}")


def read_starter_text(package: str, language: Language = ENGLISH) -> str:
    """The starter that stands in a package, as TOML: in a language where there is one in it, else
    in English.
    """
    own = files(package) / f"starter.{language}.toml"
    starter = own if own.is_file() else files(package) / "starter.toml"
    return starter.read_text(encoding="utf-8")


def write_starter_file(
    name: str, package: str, path: Path | None = None, *, force: bool = False
) -> Path:
    """Writes the starter of a package, by default to NAME.toml in the current folder; gives its
    path.

    Raises OutputError for what cannot be a file's name, and where the file exists, unless `force`.
    """
    if not _NAME.fullmatch(name):
        what, do = Message("files.starter-name"), Message("files.leave-out-ending")
        raise OutputError(Fault(name, what, do=do))
    target = path if path is not None else Path(f"{name}.toml")
    write_file(target, read_starter_text(package).encode("utf-8"), "toml", force=force)
    return target
