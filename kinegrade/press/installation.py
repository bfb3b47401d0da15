"""What is installed of what kinegrade uses: `kinegrade doctor`."""

from __future__ import annotations

import platform
import shutil
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from kinegrade import __version__
from kinegrade.errors import TypesetError
from kinegrade.language.message import Message, Text

_ROOM = 500  # megabytes: an exam of 200 students takes 50, and as much again while it is written


@dataclass(frozen=True)
class Found:
    """One thing that is used: its `state` where it is there, else None; what it is for, and
    how to get it. Without what is `needed` nothing can be printed.
    """

    name: Message
    state: Text | None
    purpose: Message
    remedy: Message
    needed: bool = True


def examine_installation() -> Iterator[Found]:
    """Everything in turn: the program, the typesetters, what papers in other kinds of files take,
    what shows files in the browser, and room on the disk.
    """
    yield _find("kinegrade", __version__)
    yield _find("python", platform.python_version())
    yield _find("typst", _try_typesetting())
    yield _find("fonts", _find_chinese_font())
    yield _find("latex", _find_programs("xelatex", "xdvipdfmx"), needed=False)
    yield _find("pandoc", _try_pandoc(), needed=False)
    yield _find("preview", _find_version("uvicorn", "starlette", "watchfiles"), needed=False)
    yield _find("cluster", _find_version("distributed"), needed=False)
    yield _find("room", _measure_room())


def _find(name: str, state: Text | None, *, needed: bool = True) -> Found:
    return Found(
        Message(f"doctor.name-{name}"),
        state,
        Message(f"doctor.for-{name}"),
        Message(f"doctor.get-{name}"),
        needed,
    )


def _try_typesetting() -> str | None:
    """The version of the embedded typesetter that could typeset a page."""
    try:
        from kinegrade.press.typst.press import TypstPress  # noqa: PLC0415

        TypstPress().require_printable("A", "")
        return _find_version("typst")
    except (ImportError, TypesetError):
        return None


def _find_chinese_font() -> str | None:
    try:
        import pylopdf_fonts_zh_cn  # noqa: PLC0415

        font = Path(pylopdf_fonts_zh_cn.serif_path())
    except ImportError:
        return None
    return font.name if font.is_file() else None


def _find_programs(*names: str) -> str | None:
    """Where the first of some programs is, if all are there."""
    found = [shutil.which(name) for name in names]
    return found[0] if all(found) else None


def _find_version(*packages: str) -> str | None:
    """The version of the first of some packages, if all are there."""
    from importlib.metadata import PackageNotFoundError, version  # noqa: PLC0415

    try:
        first, *_ = [version(package) for package in packages]
    except PackageNotFoundError:
        return None
    return first


def _try_pandoc() -> str | None:
    from kinegrade.press.word.pandoc import require_pandoc  # noqa: PLC0415

    try:
        require_pandoc(("docx",))
    except TypesetError:
        return None
    return "pandoc"


def _measure_room() -> Message | None:
    """The megabytes that are free, where exams are written and where they are prepared."""
    places = (Path.cwd(), Path(tempfile.gettempdir()))
    free = min(shutil.disk_usage(place).free for place in places) // 10**6
    return Message("doctor.megabytes", number=free) if free >= _ROOM else None
