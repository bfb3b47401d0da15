"""The secrets of exams that tests generate: the same in every run, whichever tests ran before, so
that what fails once fails again. `make prove` draws new ones, as users do.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from random import Random

import pytest

from kinegrade.exam.folder import exam_secret


@dataclass(eq=False)
class RepeatedSecrets:
    """Stands for `secrets.token_hex`: each fixture and each test has a sequence of its own."""

    sequences: list[Random] = field(default_factory=lambda: [Random("session")])

    def token_hex(self, count: int) -> str:
        """So many bytes in hexadecimal, the next of what is under way."""
        return self.sequences[-1].randbytes(count).hex()

    @contextmanager
    def of(self, name: str) -> Iterator[None]:
        """The sequence of that name from its beginning, during the block."""
        self.sequences.append(Random(name))
        try:
            yield
        finally:
            self.sequences.pop()

    @pytest.hookimpl(wrapper=True)
    def pytest_fixture_setup(
        self, fixturedef: pytest.FixtureDef[object], request: pytest.FixtureRequest
    ) -> Iterator[object]:
        parameter = getattr(request, "param_index", 0)
        with self.of(f"{fixturedef.baseid}::{fixturedef.argname}[{parameter}]"):
            return (yield)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_call(self, item: pytest.Item) -> Iterator[None]:
        with self.of(f"{item.location[0]}::{item.name}"):
            return (yield)


def repeat_secrets(config: pytest.Config) -> None:
    """Let every test of this run draw the same secrets as in any other."""
    secrets = RepeatedSecrets()
    exam_secret.token_hex = secrets.token_hex  # type: ignore[assignment]
    config.pluginmanager.register(secrets)
