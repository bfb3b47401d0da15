"""Whether there is a LaTeX to be tested."""

from __future__ import annotations

from shutil import which

import pytest

TEX_MISSING = which("pdflatex") is None or which("xelatex") is None
TEX_REASON = "LaTeX is not installed (make tex installs it)"

needs_tex = pytest.mark.skipif(TEX_MISSING, reason=TEX_REASON)
