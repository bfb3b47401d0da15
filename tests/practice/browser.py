"""Chromium as a test drives it: by its own protocol through two pipes, without another program."""

from __future__ import annotations

import fcntl
import json
import os
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any

import pytest

from tests.tools import complaint, missing_tools

_FLAGS = "--headless --no-sandbox --disable-gpu --remote-debugging-pipe about:blank"
_TOLD = (
    "Runtime.consoleAPICalled",
    "Runtime.exceptionThrown",
    "Log.entryAdded",
    "Network.requestWillBeSent",
)
_FREE = 10  # the first descriptor that a copy may have


class Page:
    """A page of a browser; `told` are the messages and requests that it has made."""

    def __init__(self, asking: IO[bytes], answering: IO[bytes]) -> None:
        self._asking, self._answering = asking, answering
        self._session: dict[str, str] = {}
        self._count = 0
        self.told: list[dict[str, Any]] = []
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        attached = self.ask("Target.attachToTarget", targetId=target, flatten=True)
        self._session = {"sessionId": attached["sessionId"]}
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(f"{domain}.enable")

    def ask(self, method: str, **parameters: Any) -> dict[str, Any]:
        """The browser's answer to a command of its protocol."""
        self._count += 1
        command = {"id": self._count, "method": method, "params": parameters, **self._session}
        self._asking.write(json.dumps(command).encode() + b"\0")
        self._asking.flush()
        while True:
            said = self._hear()
            if said.get("id") == self._count:
                assert "error" not in said, said
                return dict(said["result"])

    def open(self, file: Path) -> None:
        """Goes to a file, and waits for its questions."""
        self.ask("Page.navigate", url=file.as_uri())
        self.run(
            "new Promise((done) => { const look = () =>"
            " document.querySelector('main section') ? done() : setTimeout(look, 20); look(); })"
        )

    def run(self, script: str) -> Any:
        """What an expression is worth in the page, once it is fulfilled."""
        found = self.ask(
            "Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True
        )
        assert "exceptionDetails" not in found, found
        return found["result"].get("value")

    def press(self, key: str, code: int, text: str = "") -> None:
        """Presses a key."""
        for kind in ("keyDown", "keyUp"):
            self.ask(
                "Input.dispatchKeyEvent", type=kind, key=key, code=key, text=text,
                windowsVirtualKeyCode=code,
            )  # fmt: skip

    def type(self, text: str) -> None:
        """Types into what has the focus."""
        self.ask("Input.insertText", text=text)

    def _hear(self) -> dict[str, Any]:
        said = bytearray()
        while (letter := self._answering.read(1)) != b"\0":
            assert letter, "the browser has gone"
            said += letter
        message: dict[str, Any] = json.loads(said)
        if message.get("method") in _TOLD:
            self.told.append(message)
        return message


@contextmanager
def open_page() -> Iterator[Page]:
    """A page of a new Chromium, which ends with the block."""
    if "chromium" in missing_tools():
        pytest.fail(complaint(missing_tools()), pytrace=False)
    theirs_in, ours_out = os.pipe()
    ours_in, theirs_out = os.pipe()
    given = [fcntl.fcntl(each, fcntl.F_DUPFD, _FREE) for each in (theirs_in, theirs_out)]
    shell = f"exec chromium {_FLAGS} 3<&{given[0]} 4>&{given[1]} 2>/dev/null"
    browser = subprocess.Popen(["bash", "-c", shell], pass_fds=given)
    for each in (*given, theirs_in, theirs_out):
        os.close(each)
    with os.fdopen(ours_out, "wb") as asking, os.fdopen(ours_in, "rb") as answering:
        try:
            yield Page(asking, answering)
        finally:
            browser.terminate()
            browser.wait(timeout=20)
