"""What follows from students' answers, worked out from an exam folder: its templates and the
numbers drawn.

`FollowThrough` is what `kinegrade.grading.judging.follow` asks for. Only the key lines of the
papers asked about are read. Nothing follows from a template that this version can no longer read,
or from a key without the numbers drawn; if template and key contradict each other, nothing is
marked.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import remainder

from kinegrade.exam.folder.contradictions import (
    describe_difference,
    explain_contradiction,
    name_place,
)
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.key.exact_keys import find_exact_value
from kinegrade.exam.folder.key.lines import KeyQuestion, StatedAnswer
from kinegrade.language.message import Message
from kinegrade.mechanics.plan import Plan
from kinegrade.problem.template.template import Template
from kinegrade.students.following.connections import find_generic_plan, find_stages
from kinegrade.students.following.followers import AnyFollower, make_follower
from kinegrade.students.mistaking.mistakes import convert_parameter

KEPT = 256  # instances kept in memory, so that the student's next answers find theirs
_AGREEMENT = (
    1e-6  # relative, between doubles and the key: rounding stays below, an edited template above
)


@dataclass(frozen=True)
class FollowThrough:
    """Works out what follows from the students' answers on the papers of an exam."""

    exam: ExamFolder
    plans: dict[str, Plan | None] = field(default_factory=dict, repr=False)
    instances: dict[tuple[str, str], AnyFollower | None] = field(default_factory=dict, repr=False)

    def __call__(
        self, student: str, question: str, own: Mapping[str, Fraction], later: str
    ) -> tuple[Fraction, ...]:
        """What may follow for the ask `later` from `own`, the student's answers to other asks of
        the question, each in its unit.

        Empty if it does not depend on them or nothing follows. Raises ExamError if the key cannot
        be read.
        """
        follower = self.instance(student, question) if own else None
        if follower is None or later not in follower.template.asks:
            return ()
        answers = {ask: float(value) for ask, value in own.items() if ask in follower.template.asks}
        return tuple(map(Fraction, follower.consequences(answers, later)))

    def is_possible(self, question: str) -> bool:
        """Whether anything follows in a question, on whatever paper."""
        template = self.templates.get(question)
        return template is not None and _can_follow(template)

    def stages(self, question: str, asks: Sequence[str]) -> Sequence[Sequence[str]]:
        """The asks of a question in the order in which the plan comes to them: velocities before
        accelerations.
        """
        template = self.templates.get(question)
        return [asks] if template is None else find_stages(template, asks)

    def instance(self, student: str, question: str) -> AnyFollower | None:
        """A question as it stands on a student's paper; None if it can no longer be worked out."""
        place = student, question
        if place not in self.instances:
            while len(self.instances) >= KEPT:
                del self.instances[next(iter(self.instances))]
            self.instances[place] = self.follower(student, question)
        return self.instances[place]

    def follower(self, student: str, question: str) -> AnyFollower | None:
        """The instance, with the plan of its template. Raises ExamError if its answers differ from
        the key's.
        """
        template = self.templates.get(question)
        if template is None or not self.is_possible(question):
            return None
        kept = self.kept(student, question)
        if kept is None:
            return None
        texts = kept.values
        if not template.parameters.keys() <= texts.keys():
            return None
        values = {
            name: convert_parameter(parameter, texts[name])
            for name, parameter in template.parameters.items()
        }
        follower = make_follower(template, values, self.plan(question, template))
        self._require_same(follower, kept, name_place(self.exam.keys.file, student, question))
        return follower

    def _require_same(self, follower: AnyFollower, kept: KeyQuestion, where: Message) -> None:
        """Raises ExamError if an answer of the instance differs from the key's: anything that
        followed would belong to another mechanism.
        """
        for name, answer in kept.asks.items():
            derived = follower.right(name) if name in follower.template.asks else None
            if derived is not None and not _is_same(derived, answer):
                stated = str(answer.decimal or answer.value)
                difference = describe_difference(name, stated, f"{derived:.12g}")
                raise explain_contradiction(where, [difference])

    def plan(self, question: str, template: Template) -> Plan | None:
        """The plan of a question's template, found once; it is the same for all students."""
        if question not in self.plans:
            self.plans[question] = find_generic_plan(template)
        return self.plans[question]

    def kept(self, student: str, question: str) -> KeyQuestion | None:
        """A question as the key of a student's paper states it; None if it is not there."""
        line = self.exam.keys.line_of(student)
        return next((each for each in line.questions if each.question == question), None)

    @property
    def templates(self) -> Mapping[str, Template]:
        """The templates by question, those that can be read."""
        return self.exam.templates.readable


def _can_follow(template: Template) -> bool:
    """Whether anything follows from anything: a mechanism moves, or there are steps."""
    return bool(template.scheme.drivers) or not template.scheme.has_mechanism


def _is_same(derived: float, answer: StatedAnswer) -> bool:
    """Whether an answer worked out in doubles is that of the key, except for rounding."""
    right = float(find_exact_value(answer))
    room = _AGREEMENT * max(abs(right), float(answer.tolerance.absolute), 1)
    difference = derived - right
    if answer.period:
        difference = remainder(difference, float(answer.period))
    return abs(difference) <= room
