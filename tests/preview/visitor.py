"""A visitor of the preview: asks its pages as a browser does, over the loopback."""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from http.client import HTTPConnection, HTTPResponse
from pathlib import Path

import uvicorn

from kinegrade.language import ENGLISH
from kinegrade.preview.application import Desk, make_application
from kinegrade.processes.executor import THIS_PROCESS


@dataclass(frozen=True)
class Answer:
    """What a page is: its status, its headers, its text."""

    status: int
    headers: dict[str, str]
    text: str


@dataclass(frozen=True)
class Visitor:
    """Asks the pages at a port of this machine."""

    port: int

    def ask(self, address: str, host: str = "127.0.0.1") -> Answer:
        """The answer to an address, asked for by the name of a host."""
        response = self.open(address, host)
        return Answer(response.status, dict(response.headers), response.read().decode())

    def read(self, address: str) -> str:
        """The text of a page that there is."""
        answer = self.ask(address)
        assert answer.status == 200, answer.text
        return answer.text

    def list_labels(self) -> list[str]:
        """What the problems of the file are called."""
        labels: list[str] = json.loads(self.read("/labels"))
        return labels

    def open(self, address: str, host: str = "127.0.0.1") -> HTTPResponse:
        """An answer that may still be written."""
        connection = HTTPConnection("127.0.0.1", self.port, timeout=60)
        connection.request("GET", address, headers={"Host": host})
        return connection.getresponse()


@contextmanager
def visiting(path: Path) -> Iterator[Visitor]:
    """A visitor of the preview of a file, which is served meanwhile."""
    with ThreadPoolExecutor(1) as first:
        desk = Desk(path, ENGLISH, first, THIS_PROCESS, threading.Event())
        config = uvicorn.Config(make_application(desk), port=0, log_level="error", lifespan="off")
        server = uvicorn.Server(config)
        thread = threading.Thread(target=server.run)
        thread.start()
        while not server.started:
            time.sleep(0.01)
        try:
            yield Visitor(server.servers[0].sockets[0].getsockname()[1])
        finally:
            server.should_exit = True
            thread.join()
