"""A page in a real browser, as tests drive it: `driver.js` beside this file does what it is told,
by puppeteer-core, with the browser of this machine.
"""

from __future__ import annotations

import atexit
import json
import os
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from shutil import which
from typing import IO, Any, Literal

import pytest

from tests.tools import complaint, find_modules, missing_tools

BrowserName = Literal["chromium", "firefox"]

_DRIVER = Path(__file__).with_name("driver.js")
_PUPPETEERS: Mapping[BrowserName, str] = {"chromium": "chrome", "firefox": "firefox"}


@dataclass
class Page:
    """A page of a browser."""

    asking: IO[str]
    answering: IO[str]
    before: list[str] = field(default_factory=list)  # scripts that run before those of the page

    def open(self, address: str) -> None:
        """Goes to an address, and waits until it is loaded."""
        self._do("open", address=address, before=self.before)

    def run(self, script: str) -> Any:
        """What an expression is worth in the page, once it is fulfilled."""
        return self._do("run", script=script)

    def wait(self, condition: str) -> None:
        """Waits until an expression is true, a minute at most."""
        self.run(
            "new Promise((done, fail) => { const since = Date.now(); const look = () => {"
            f" if ({condition}) done(); else if (Date.now() > since + 6e4) fail({condition!r});"
            " else setTimeout(look, 10); }; look(); })"
        )

    def press(self, key: str) -> None:
        """Presses a key."""
        self._do("press", key=key)

    def type(self, text: str) -> None:
        """Types into what has the focus."""
        self._do("type", text=text)

    def drag(self, start: Sequence[float], end: Sequence[float]) -> None:
        """Presses the mouse at one place of the window and lets it go at another."""
        self._do("drag", **{"from": start, "to": end})

    def size(self, width: int, height: int) -> None:
        """Gives the window a size."""
        self._do("size", width=width, height=height)

    def prefer(self, medium: str = "screen", **features: str) -> None:
        """Shows the page on a medium, to somebody with preferences: `color_scheme="dark"`."""
        named = {f"prefers-{name.replace('_', '-')}": value for name, value in features.items()}
        listed = [{"name": name, "value": value} for name, value in named.items()]
        self._do("prefer", medium=medium, features=listed)

    def picture(self, file: Path) -> None:
        """A picture of the whole page, as a PNG."""
        self._do("picture", file=str(file))

    def faults(self) -> list[str]:
        """What axe-core has to say against the page."""
        return list(self._do("faults"))

    def tree(self) -> dict[str, Any]:
        """The accessibility tree."""
        return dict(self._do("tree"))

    def messages(self) -> list[str]:
        """What was said on the console and asked of anybody since the page was opened."""
        return list(self._do("messages"))

    def _do(self, command: str, **given: Any) -> Any:
        print(json.dumps([command, given]), file=self.asking, flush=True)
        said = self.answering.readline()
        assert said, "the browser has gone"
        answer = json.loads(said)
        assert "error" not in answer, f"{command} {given}: {answer['error']}"
        return answer["found"]


@contextmanager
def open_page(browser: BrowserName = "chromium") -> Iterator[Page]:
    """An empty page that keeps nothing from others; the browser goes on for the next."""
    driver = _drive(browser)
    assert driver.stdin is not None
    assert driver.stdout is not None
    page = Page(driver.stdin, driver.stdout)
    page._do("fresh")
    yield page


@cache
def _drive(browser: BrowserName) -> subprocess.Popen[str]:
    """The browser's driver, until this process ends."""
    missing = missing_tools()
    if missing:
        pytest.fail(complaint(missing), pytrace=False)
    driver = subprocess.Popen(
        ["node", _DRIVER, _PUPPETEERS[browser], str(which(browser))],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "NODE_PATH": str(find_modules())},
    )
    atexit.register(driver.communicate)
    return driver
