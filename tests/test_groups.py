"""Tests of a group share a worker, so that what they share is made once."""

from __future__ import annotations

import os

import pytest


@pytest.mark.xdist_group("a group")
def test_the_suite_sees_the_groups_of_tests(request: pytest.FixtureRequest) -> None:
    if "PYTEST_XDIST_WORKER" in os.environ:  # this name is how its scheduler knows a group
        assert request.node.nodeid.endswith("@a group")
