"""How Sphinx builds the site: `make docs`. The reference is written anew before each build."""

from __future__ import annotations

import os
import sys
from pathlib import Path

_DOCS = Path(__file__).parent
os.environ["LC_ALL"] = "C"  # the words of the program are English here, whatever the terminal's are
sys.path.insert(0, str(_DOCS.parent))

from docs.generator.gallery import write_pictures  # noqa: E402
from docs.generator.pages import write_reference  # noqa: E402
from docs.generator.shown_sheet import write_shown_sheet  # noqa: E402
from kinegrade import __version__  # noqa: E402
from kinegrade.problem.template.library.library import find_template_names  # noqa: E402

write_reference(_DOCS / "reference")
_TAKEN_IN = _DOCS.parent / "build" / "taken-in"
write_shown_sheet(_TAKEN_IN)
write_pictures(_TAKEN_IN, find_template_names())

project = "kinegrade"
version = release = __version__
extensions = ["myst_parser"]
html_theme = "furo"
html_title = f"kinegrade {__version__}"
html_show_copyright = False
html_extra_path = [str(_TAKEN_IN)]
myst_heading_anchors = 3  # links may name a heading
nitpicky = True
