"""A logo as one SVG that holds all it needs, whichever of the kinds of files it came from.

Files that people bring are looked at by a process of its own, for a limited time: whatever one of
them does to it, there is one line. It reads no other file.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Literal

import typst

from kinegrade.files.temporary import temporary_folder
from kinegrade.language.typst_text import write_literal
from kinegrade.press.program_run import run_program
from kinegrade.press.typst.compiler import find_fonts, make_compiler

_SECONDS = 30.0
_SIZES = slice(16, 20), slice(20, 24)  # where a PNG says how wide and high it is
_FILE = "logo"
_PAGE = "#set page(width: auto, height: auto, margin: 0pt, fill: none)\n"


def convert_logo(content: bytes, kind: str, megapixels: int) -> str | None:
    """The SVG of a logo (a png, svg or pdf); None where the file is not of that kind, is damaged or
    refers to others, or has more pixels.
    """
    if kind == "png" and _count_pixels(content) > megapixels * 1_000_000:
        return None
    with temporary_folder() as folder:
        (folder / f"{_FILE}.{kind}").write_bytes(content)
        command = [sys.executable, "-m", __name__, str(folder), kind]
        # The same modules as here, wherever the child is started
        environment = os.environ | {"PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
        try:
            done = run_program(command, _SECONDS, environment=environment)
        except (OSError, TimeoutError):
            return None
    return None if done.status else done.output.decode()


def print_logo(svg: str, kind: Literal["png", "pdf"]) -> bytes:
    """A converted logo for what cannot print SVG; 300 pixels to the inch at a height of 30 mm."""
    source = f'{_PAGE}#image(bytes({write_literal(svg)}), format: "svg", height: 30mm)'
    printed = make_compiler().compile(source.encode(), format=kind, ppi=300, timestamp=0)
    return printed if isinstance(printed, bytes) else b""


def _count_pixels(content: bytes) -> int:
    width, height = (int.from_bytes(content[size], "big") for size in _SIZES)
    return width * height


def _convert(folder: Path, kind: str) -> bytes:
    """The picture by way of PDF, in which letters are outlines that need no font any more."""
    compiler = typst.Compiler(root=str(folder), font_paths=find_fonts(), ignore_system_fonts=True)
    outlined = compiler.compile(_show(kind), format="pdf", timestamp=0)
    (folder / f"{_FILE}.pdf").write_bytes(outlined if isinstance(outlined, bytes) else b"")
    svg = compiler.compile(_show("pdf"), format="svg")
    return svg if isinstance(svg, bytes) else b""


def _show(kind: str) -> bytes:
    return f'{_PAGE}#image("/{_FILE}.{kind}", height: 30mm)'.encode()


if __name__ == "__main__":
    sys.stdout.buffer.write(_convert(Path(sys.argv[1]), sys.argv[2]))
