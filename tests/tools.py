"""What tests and benchmarks need besides Python, and how it gets onto this machine.

    python -m tests.tools     # installs what is missing; it needs no package, so any Python will do

`make tools` runs it. The files of TeX are what papers by LaTeX load, and what the ordinary LaTeX
paper of `benchmarks.ordinary_latex` loads. The packages of npm, pinned in tests/browsers, stand in
this user's cache, where every clone finds them.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from hashlib import sha256
from pathlib import Path
from shutil import which

PROGRAMS = {
    "pdflatex": "texlive-latex-recommended",
    "xelatex": "texlive-xetex",
    "pdftoppm": "poppler-utils",
    "node": "nodejs",
    "npm": "npm",
    "chromium": "chromium",
    "firefox": "firefox-esr",
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
_PINNED = Path(__file__).parent / "browsers"
_OF_NPM = "package.json", "package-lock.json"
_BESIDE_TEX = "siunitx, TikZ and xeCJK, poppler, node with npm, chromium and firefox"


def missing_tools() -> dict[str, str]:
    """The programs and files of TeX that are not on this machine, each with the package of Debian
    and Ubuntu that holds it; and the packages of npm, each with "".
    """
    programs = {name: package for name, package in PROGRAMS.items() if which(name) is None}
    files = {name: TEX_FILES[name] for name in _missing_tex_files()}
    return programs | files | dict.fromkeys(_missing_modules(), "")


def find_modules() -> Path:
    """Where the packages of npm are, or will be: a folder for each state of those that are pinned."""
    state = sha256(b"".join((_PINNED / name).read_bytes() for name in _OF_NPM)).hexdigest()[:12]
    cache = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(cache, "kinegrade-tests", state, "node_modules")


def complaint(missing: dict[str, str]) -> str:
    """One line about what is missing and how to install it."""
    return (
        f"tools: {', '.join(missing)} not found; expected TeX Live with {_BESIDE_TEX}, and what "
        "tests/browsers/package.json names; run make tools"
    )


def _missing_tex_files() -> Iterator[str]:
    """The files that TeX does not find; all of them where there is no TeX."""
    if which("kpsewhich") is None:
        return iter(TEX_FILES)
    asked = ["kpsewhich", "--progname=xelatex", *TEX_FILES]
    found = subprocess.run(asked, capture_output=True, text=True, check=False).stdout
    names = {os.path.basename(path) for path in found.splitlines()}
    return (name for name in TEX_FILES if name not in names)


def _missing_modules() -> Iterator[str]:
    """The packages of npm that are not in their folder."""
    pinned = json.loads((_PINNED / "package.json").read_text("utf-8"))["devDependencies"]
    folder = find_modules()
    return (name for name in pinned if not (folder / name).exists())


def _install_modules() -> None:
    """Install the packages of npm, all or none."""
    folder = find_modules().parent
    begun = folder.with_name(f"{folder.name}-{os.getpid()}")
    begun.mkdir(parents=True)
    for name in _OF_NPM:
        shutil.copy(_PINNED / name, begun)
    install = ["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund", "--loglevel=error"]
    if subprocess.run(install, cwd=begun, check=False).returncode == 0 and not folder.exists():
        begun.rename(folder)
    shutil.rmtree(begun, ignore_errors=True)


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
    packages = sorted({package for package in missing.values() if package})
    if packages and which("apt-get") is not None:
        print(f"tools: installing {', '.join(packages)}", flush=True)
        _install(packages)
    if any(_missing_modules()) and which("npm") is not None:
        print("tools: installing the packages of tests/browsers", flush=True)
        _install_modules()
    missing = missing_tools()
    if not missing:
        print("tools: all there")
        return 0
    print(
        f"tools: {', '.join(missing)} not found, and not installed by apt-get or npm; install TeX "
        f"Live (tug.org/texlive) or MacTeX with {_BESIDE_TEX}",
        file=sys.stderr,
    )
    return 1


if __name__ == "__main__":
    sys.exit(main())
