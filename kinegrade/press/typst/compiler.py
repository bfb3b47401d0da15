"""The embedded Typst: its layouts and its fonts, Latin from Typst itself, Chinese from an installed
package.

Noto Serif SC and Noto Sans SC (SIL Open Font License 1.1) come with `pylopdf-fonts-zh-cn`; the
serif covers U+4E00 to U+9FFF whole. Libertinus Serif and New Computer Modern Math are inside the
typst wheel. Fonts installed on the system are ignored, so a paper looks the same everywhere.
"""

from __future__ import annotations

from functools import cache
from importlib.resources import files

import pylopdf_fonts_zh_cn
import typst


def make_compiler() -> typst.Compiler:
    """A compiler that reads the layouts and no other folder."""
    layouts = str(files("kinegrade.press.typst") / "layouts")
    return typst.Compiler(root=layouts, font_paths=find_fonts(), ignore_system_fonts=True)


@cache
def find_fonts() -> typst.Fonts:
    """The fonts a press may use, none of them the system's.

    All presses of a process share them, and what Typst remembers of texts set in them.
    """
    folder = pylopdf_fonts_zh_cn.serif_path().parent
    return typst.Fonts(
        include_system_fonts=False, include_embedded_fonts=True, font_paths=[str(folder)]
    )
