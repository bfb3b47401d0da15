"""The scripts of pages say what types they have, and keep to them."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

import kinegrade
from tests.tools import complaint, find_modules, missing_tools

PACKAGE = Path(kinegrade.__file__).parent
SCRIPTS = sorted((PACKAGE / "practice" / "scripts").glob("*.js"))
LAYOUTS = PACKAGE / "press" / "html" / "layouts"
STRICT = "--noEmit --allowJs --checkJs --strict --target es2022 --lib es2022,dom,dom.iterable"


def list_faults(files: list[Path]) -> str:
    """What the compiler has to say against scripts that stand in one page."""
    if "typescript" in missing_tools():
        pytest.fail(complaint(missing_tools()), pytrace=False)
    compiler = find_modules() / ".bin" / "tsc"
    command = [str(compiler), *STRICT.split(" "), "--types", "", *map(str, files)]
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout


@pytest.mark.parametrize("other", ["alone", "scorm"])
def test_the_script_of_a_practice_sheet_keeps_to_its_types(other: str) -> None:
    shared = LAYOUTS / "player.js"
    assert list_faults([shared, *(file for file in SCRIPTS if file.stem != other)]) == ""


def test_the_script_of_a_moving_figure_keeps_to_its_types(tmp_path: Path) -> None:
    baked = tmp_path / "baked.d.ts"
    texts = "play: string; stop: string; drawings: string[]; moved: string[]"
    data = f"{{ {texts}; first: number; closed: boolean }}"
    baked.write_text(f"declare const ID: string;\ndeclare const DATA: {data};\n", encoding="utf-8")
    scripts = [LAYOUTS / "player.js", LAYOUTS / "moving-figure.js"]
    assert list_faults([baked, *scripts]) == ""


def test_the_script_of_the_preview_keeps_to_its_types() -> None:
    assert list_faults([LAYOUTS / "preview.js"]) == ""


def test_a_wrong_type_is_found(tmp_path: Path) -> None:
    (tmp_path / "a.js").write_text('/** @type {number} */ const a = "1";\n', encoding="utf-8")
    assert "TS2322" in list_faults([tmp_path / "a.js"])
