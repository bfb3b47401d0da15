"""What a browser may ask for: the page, its parts, verdicts on answers, and news of changes.

The part that is seen first is made in a thread, one after the other; the others, which take
seconds, in other processes, so that no picture waits for them.
"""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from threading import Event
from typing import ParamSpec, TypeVar, assert_never, get_args

from starlette.applications import Starlette
from starlette.middleware import Middleware
from starlette.middleware.trustedhost import TrustedHostMiddleware
from starlette.requests import Request
from starlette.responses import (
    HTMLResponse,
    JSONResponse,
    PlainTextResponse,
    Response,
    StreamingResponse,
)
from starlette.routing import Route

from kinegrade.errors import FieldError
from kinegrade.language import Language
from kinegrade.language.known import read_language
from kinegrade.preview.changes import watch_file
from kinegrade.preview.parts import PartName, Shown, list_labels, write_part, write_verdict
from kinegrade.preview.shell import ASSETS, read_asset, write_shell

_Given = ParamSpec("_Given")
_Result = TypeVar("_Result")

_NAMES = ["127.0.0.1", "localhost"]  # a page from elsewhere cannot read this one by another name
_SHOWN = "{place:int}/{language}"  # which problem of the file, in which language
_OF_FILES = "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'"
_OF_FILES += "; connect-src 'self'; frame-src 'self'; img-src data:"
_INSIDE = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'"


@dataclass(frozen=True)
class Desk:
    """The file that is previewed, the language that the page begins in, and who makes its parts:
    `first` makes one after the other, `others` are processes. It is `ended` when no more news are
    told.
    """

    path: Path
    language: Language
    first: Executor
    others: Executor
    ended: Event

    async def shell(self, _: Request) -> Response:
        """The page, which loads everything else."""
        return _answer(write_shell(self.path, self.language), _OF_FILES)

    async def labels(self, _: Request) -> Response:
        """What the problems of the file are called."""
        return JSONResponse(await _do(self.first, list_labels, self.path))

    async def part(self, name: PartName, request: Request) -> Response:
        """A part of the page."""
        workers = self._choose_workers(name)
        return _answer(await _do(workers, write_part, name, self._read(request)), _INSIDE)

    async def verdict(self, request: Request) -> Response:
        """What marking says of an answer as it was typed."""
        asked, typed = (request.query_params.get(each, "") for each in ("ask", "typed"))
        written = await _do(self.first, write_verdict, self._read(request), asked, typed)
        return _answer(written, _INSIDE)

    async def news(self, _: Request) -> Response:
        """An event after each change."""
        return StreamingResponse(self._tell(), media_type="text/event-stream")

    async def _tell(self) -> AsyncIterator[str]:
        async for changed in watch_file(self.path, self.ended):
            yield "data: changed\n\n" if changed else ": watching\n\n"

    def _choose_workers(self, name: PartName) -> Executor:
        """Who makes a part: nothing long stands before the problem."""
        match name:
            case "problem":
                return self.first
            case "solution" | "draws" | "check" | "motion":
                return self.others
            case _:
                assert_never(name)

    def _read(self, request: Request) -> Shown:
        """What the page shows. Raises FieldError for a language that there is not."""
        asked = request.path_params
        return Shown(self.path, asked["place"], read_language(asked["language"]))


def make_application(desk: Desk) -> Starlette:
    """The routes to a desk, for browsers of this machine alone."""
    parts = [Route(f"/{name}/{_SHOWN}", partial(desk.part, name)) for name in get_args(PartName)]
    assets = [Route(f"/{name}", partial(_send_asset, name)) for name in ASSETS]
    return Starlette(
        routes=[
            Route("/", desk.shell),
            Route("/labels", desk.labels),
            Route("/news", desk.news),
            Route(f"/verdict/{_SHOWN}", desk.verdict),
            *parts,
            *assets,
        ],
        middleware=[Middleware(TrustedHostMiddleware, allowed_hosts=_NAMES)],
        exception_handlers={FieldError: _refuse},
    )


async def _do(
    workers: Executor, task: Callable[_Given, _Result], *given: _Given.args, **named: _Given.kwargs
) -> _Result:
    """What a task gives that is done elsewhere; meanwhile other questions are answered."""
    whole = partial(task, *given, **named)
    return await asyncio.get_running_loop().run_in_executor(workers, whole)


def _answer(page: str, policy: str) -> Response:
    """A page that loads nothing but what the policy allows, and that no browser keeps."""
    headers = {"Content-Security-Policy": policy, "Cache-Control": "no-store"}
    return HTMLResponse(page, headers=headers)


async def _send_asset(name: str, _: Request) -> Response:
    return Response(read_asset(name), media_type=ASSETS[name])


async def _refuse(_: Request, fault: Exception) -> Response:
    """A question that this page does not ask."""
    return PlainTextResponse(str(fault), status_code=400)
