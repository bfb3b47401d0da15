"""Serving the preview of a file to browsers of this machine, until it is interrupted."""

from __future__ import annotations

import socket
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from threading import Event
from types import FrameType

import uvicorn

from kinegrade.errors import OptionError
from kinegrade.language import Language
from kinegrade.language.message import Fault, Message
from kinegrade.preview.application import Desk, make_application
from kinegrade.preview.parts import Shown, write_part
from kinegrade.processes.executor import open_executor

_HERE = "127.0.0.1"  # no other machine reaches it
_OTHERS = 2  # processes: the check of a template and its solution side by side


class _Server(uvicorn.Server):
    """A server that says when it is asked to end, before it waits for those who wait for news."""

    def __init__(self, config: uvicorn.Config, ended: Event) -> None:
        super().__init__(config)
        self._ended = ended

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:
        """Ctrl-C, or another request to end."""
        self._ended.set()
        super().handle_exit(sig, frame)


def serve(path: Path, language: Language, port: int, tell: Callable[[str], object]) -> None:
    """Serve until interrupted; `tell` is given the address of the page, and 0 stands for any free
    port. Raises OptionError where the port is taken.
    """
    with (
        open_executor(_OTHERS, "preview") as others,
        ThreadPoolExecutor(1) as first,
        _listen(port) as listening,
    ):
        # Before there is a thread, processes are copies of this one, which start at once
        others.submit(write_part, "solution", Shown(path, 0, language))
        ended = Event()
        application = make_application(Desk(path, language, first, others, ended))
        server = _Server(uvicorn.Config(application, log_level="warning", lifespan="off"), ended)
        tell(f"http://{_HERE}:{listening.getsockname()[1]}/")
        server.run(sockets=[listening])


def _listen(port: int) -> socket.socket:
    """The socket of a port of this machine."""
    try:
        return socket.create_server((_HERE, port))
    except OSError as error:
        where = Message("preview.port", port=port)
        taken, do = Message("preview.port-taken"), Message("preview.another-port")
        raise OptionError(Fault(where, taken, do)) from error
