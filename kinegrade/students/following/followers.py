"""Who follows students' answers through a template: a mechanism's motion, or named steps."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias

from kinegrade.mechanics.plan import Plan
from kinegrade.problem.template.template import Template
from kinegrade.students.following.follow_through import Follower
from kinegrade.students.following.followed_steps import StepFollower

AnyFollower: TypeAlias = Follower | StepFollower


def make_follower(
    template: Template, values: Mapping[str, float], plan: Plan | None = None
) -> AnyFollower:
    """The follower of an instance with these parameters in SI; a plan serves a mechanism alone."""
    if template.scheme.has_mechanism:
        return Follower(template, values, plan)
    return StepFollower(template, values)
