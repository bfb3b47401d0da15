"""What solving a template takes, worked out from its plan at its default values: which methods,
which joints, how hard it is, and how long.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, TypeAlias, get_args

from kinegrade.expressions.tree import Call, Expression, walk
from kinegrade.language import ENGLISH
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.vector_equation import Level, Part
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.tags import Tag, find_kind
from kinegrade.problem.template.template import METHODS, Ask, Template
from kinegrade.sign_conventions import UNSIGNED
from kinegrade.worked.case import Case
from kinegrade.worked.solution import find_course
from kinegrade.worked.steps.couplers import find_coupler
from kinegrade.worked.vectors.needed_rates import find_references
from kinegrade.worked.vectors.stage import Stage

_Course: TypeAlias = Sequence[tuple[Step, Stage]]
Approach: TypeAlias = Literal["base-point", "projection", "pole", "relative-motion"]
APPROACHES: tuple[Approach, ...] = get_args(Approach)
LEVELS = 5  # of difficulty, from 1

# What a student does, in steps of one velocity equation with two unknowns
_STEPS: Mapping[Level, float] = {
    "velocity": 1,
    "acceleration": 1.5,  # its normal parts have to be found first
}
_FURTHER_UNKNOWN = 0.5  # beyond the two that one drawing or two projections give
_COMPOSITION = 0.5  # absolute, transport and relative motion have to be told apart
_INTERSECTION = 0.5  # a point that is found by sines and cosines
_BODY = 0.25
_ANSWER = 0.25
_SENSE = 0.25  # an answer of which a sense or a quadrant is right

# The kinds of joints that say what a problem is about
_OF_JOINTS: Mapping[str, Tag] = {
    "belt": "belt",
    "contact": "slipping-contact",
    "mesh": "gears",
    "roll": "rolling",
    "sleeve": "sleeve",
}
_BOUNDS = (4.0, 5.5, 7.0, 9.0)  # of the effort, between one level of difficulty and the next
_READING = 3.0  # minutes
_STEP = 2.5  # minutes


@dataclass(frozen=True)
class Demands:
    """What the asks with points take.

    `asked` are the kinds and functions of everything that can be asked, with points or without;
    `joints` the names of the joints; `coriolis` says whether a Coriolis acceleration is asked for,
    or found on the way;
    `effort` counts steps of one velocity equation.
    """

    asked: frozenset[str]
    joints: frozenset[str]
    methods: frozenset[Approach]
    coriolis: bool
    effort: float

    @property
    def difficulty(self) -> int:
        """From 1 to LEVELS."""
        return 1 + sum(self.effort >= bound for bound in _BOUNDS)

    @property
    def minutes(self) -> int:
        """About how long a prepared student takes, with reading."""
        return round(_READING + _STEP * self.effort)


def find_demands(template: Template) -> Demands:
    """What solving a template takes.

    Raises MechanismError where it cannot be solved at its default values.
    """
    asked = tuple(template.asks[name] for name in template.asked())
    case = Case(solve_template(template, {}, template.asked()), ENGLISH)
    course = find_course(case, asked)
    words = frozenset(_list_asked(template))
    return Demands(
        words,
        frozenset(joint.stated.__name__.lower() for joint in template.scheme.joints),
        frozenset(_find_methods(case, asked, course)),
        "coriolis" in words or any(_is_coriolis(part, case) for part in _list_parts(course)),
        sum(_measure_step(step, stage) for step, stage in course)
        + sum(map(_measure_answer, asked))
        + sum(map(_measure_point, template.scheme.points.values()))
        + len(template.scheme.bodies) * _BODY,
    )


def suggest_tags(template: Template, demands: Demands) -> tuple[str, ...]:
    """The tags that a template should have by what solving it takes, and lacks: its methods, its
    joints, a Coriolis acceleration, several independent motions.
    """
    due: set[Tag] = {
        method for method in ("base-point", "relative-motion") if method in demands.methods
    }
    due |= {tag for joint, tag in _OF_JOINTS.items() if joint in demands.joints}
    if demands.coriolis:
        due.add("coriolis")
    if len(template.scheme.drivers) > 1:
        due.add("two-inputs")
    return tuple(sorted(due - set(template.about.tags)))


def _list_asked(template: Template) -> Iterator[str]:
    """What asks are about: position, velocity or acceleration, and the functions of the motion."""
    for ask in template.asks.values():
        yield find_kind(ask)
        yield from (call.function for call in find_motion_calls(ask.quantity))


def _find_methods(case: Case, asked: Iterable[Ask], course: _Course) -> Iterator[Approach]:
    if any(find_coupler(stage) for _, stage in course):
        yield from METHODS
    calls = [call for ask in asked for call in find_motion_calls(ask.quantity)]
    if any(_is_carried(call, case) for call in calls):
        yield "base-point"
    if any(MOTION_FUNCTIONS[call.function].derivation in ("pole", "centrode") for call in calls):
        yield "pole"
    if any(map(_is_relative, _list_parts(course))):
        yield "relative-motion"


def _is_carried(call: Call, case: Case) -> bool:
    """Whether a call refers to a point that turns about a moving point of its body."""
    chains = (case.motion.frames.chain(*each) for each in find_references(call, case.reader).points)
    return any(len(chain) > 1 and chain[-1].kind == "rotation" for chain in chains)


def _list_parts(course: _Course) -> Iterator[Part]:
    """The vectors of all equations."""
    return (part for _, stage in course for each in stage.equations for part in each.parts)


def _is_relative(part: Part) -> bool:
    """Whether a vector belongs to the motion relative to a moving body."""
    return part.role == "relative" and part.frame != GROUND


def _is_coriolis(part: Part, case: Case) -> bool:
    """Whether a vector is a Coriolis acceleration; in a body that does not turn there is none."""
    nothing = all(map(case.arithmetic.is_zero, (part.value.x, part.value.y)))
    return part.role == "coriolis" and not nothing


def _measure_step(step: Step, stage: Stage) -> float:
    further = max(0, len(step.unknowns) - 2)
    composed = any(map(_is_relative, _list_parts([(step, stage)])))
    effort = 1 + further * _FURTHER_UNKNOWN + composed * _COMPOSITION
    return effort * _STEPS[stage.level]


def _measure_answer(ask: Ask) -> float:
    return _ANSWER + (ask.sign not in UNSIGNED) * _SENSE


def _measure_point(point: Expression) -> float:
    calls = {part.function for part in walk(point) if isinstance(part, Call)}
    return _INTERSECTION if "meet" in calls else 0
