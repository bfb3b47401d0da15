"""What tests and benchmarks need besides Python, and how it gets onto this machine.

    python -m tests.tools     # installs what is missing; it needs no package, so any Python will do

`make tools` runs it. The files of TeX are what papers by LaTeX load, and what the ordinary LaTeX
paper of `benchmarks.ordinary_latex` loads.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from shutil import which

PROGRAMS = {
    "pdflatex": "texlive-latex-recommended",
    "xelatex": "texlive-xetex",
    "pdftoppm": "poppler-utils",
    "node": "nodejs",
    "chromium": "chromium",
}
TEX_FILES = {
    "ctexhook.sty": "texlive-lang-chinese",
    "enumitem.sty": "texlive-latex-extra",
    "fancyhdr.sty": "texlive-latex-base",
    "lmodern.sty": "lmodern",
    "siunitx.sty": "texlive-science",
    "tikz.sty": "texlive-pictures",
    "xeCJK.sty": "texlive-lang-chinese",
}


def missing_tools() -> dict[str, str]:
    """The programs and files of TeX that are not on this machine, each with the package of Debian
    and Ubuntu that holds it.
    """
    programs = {name: package for name, package in PROGRAMS.items() if which(name) is None}
    return programs | {name: TEX_FILES[name] for name in _missing_tex_files()}


def complaint(missing: dict[str, str]) -> str:
    """One line about what is missing and how to install it."""
    return (
        f"tools: {', '.join(missing)} not found; expected TeX Live with siunitx, TikZ and xeCJK, "
        "poppler, node and chromium; run make tools"
    )


def _missing_tex_files() -> Iterator[str]:
    """The files that TeX does not find; all of them where there is no TeX."""
    if which("kpsewhich") is None:
        return iter(TEX_FILES)
    asked = ["kpsewhich", "--progname=xelatex", *TEX_FILES]
    found = subprocess.run(asked, capture_output=True, text=True, check=False).stdout
    names = {os.path.basename(path) for path in found.splitlines()}
    return (name for name in TEX_FILES if name not in names)


def _install(packages: list[str]) -> bool:
    """Whether apt-get installed the packages."""
    rights = [] if os.geteuid() == 0 else ["sudo"]
    apt_get = [*rights, "env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "-qq"]
    install = [*apt_get, "install", "-y", "--no-install-recommends", *packages]
    commands = ([*apt_get, "update"], install)
    return all(subprocess.run(command, check=False).returncode == 0 for command in commands)


def main() -> int:
    """Install what is missing; 1 where it cannot be installed, with one line that says what is."""
    missing = missing_tools()
    if missing and which("apt-get") is not None:
        print(f"tools: installing {', '.join(missing)}", flush=True)
        _install(sorted(set(missing.values())))
        missing = missing_tools()
    if not missing:
        print("tools: all there")
        return 0
    print(
        f"tools: {', '.join(missing)} not found, and not installed by apt-get; install TeX Live "
        "(tug.org/texlive) or MacTeX with siunitx, TikZ and xeCJK, poppler, node and chromium",
        file=sys.stderr,
    )
    return 1


if __name__ == "__main__":
    sys.exit(main())
