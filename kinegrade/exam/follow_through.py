"""What follows from students' own answers, worked out from an exam folder: its templates and the
numbers drawn.

`FollowThrough` is what `kinegrade.grading.follow` asks for. Of key.jsonl it keeps where each
paper's line begins, and reads the lines of those papers only that are asked about. From a template
that this version cannot read any more, and from a key without the numbers drawn, nothing follows.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from pathlib import Path
from typing import Any

from kinegrade.answer_file import POOL
from kinegrade.errors import ExamError, KinegradeError
from kinegrade.mechanics.plan import Plan
from kinegrade.problem.follow_through import Follower, connections, generic_plan, in_plan_order
from kinegrade.problem.library import kept_template
from kinegrade.problem.mistakes import in_float
from kinegrade.problem.template import Template

KEPT = 256  # instances kept in memory, so that a student's next answers find theirs
BEGINNING = '{"student": '


@dataclass(frozen=True)
class FollowThrough:
    """Tells what follows from own answers on the papers of an exam folder."""

    exam: Path
    plans: dict[str, Plan | None] = field(default_factory=dict, repr=False)
    connected: dict[str, frozenset[tuple[str, str]]] = field(default_factory=dict, repr=False)
    instances: dict[tuple[str, str], Follower | None] = field(default_factory=dict, repr=False)

    def __call__(
        self, student: str, question: str, own: Mapping[str, Fraction], later: str
    ) -> Fraction | None:
        """What follows for the ask `later` from own answers to other asks of the question, each in
        its unit.

        None where it does not depend on them or nothing follows. Raises ExamError where the key
        cannot be read.
        """
        leading = {
            ask: float(value)
            for ask, value in own.items()
            if (ask, later) in self.connections(question)
        }
        follower = self.instance(student, question) if leading else None
        value = None if follower is None else follower.value(leading, later)
        return None if value is None else Fraction(value)

    def connections(self, question: str) -> frozenset[tuple[str, str]]:
        """Which ask of a question (first) another one (second) depends on."""
        if question not in self.connected:
            template = self.templates.get(question)
            self.connected[question] = frozenset() if template is None else connections(template)
        return self.connected[question]

    def in_plan_order(self, question: str, asks: Iterable[str]) -> tuple[str, ...]:
        """The asks of a question in the order in which the plan comes to them: velocities before
        accelerations.
        """
        template = self.templates.get(question)
        return tuple(asks) if template is None else in_plan_order(template, asks)

    def instance(self, student: str, question: str) -> Follower | None:
        """A question as it stands on a student's paper; None where it cannot be worked out any
        more.
        """
        place = student, question
        if place not in self.instances:
            while len(self.instances) >= KEPT:
                del self.instances[next(iter(self.instances))]
            self.instances[place] = self.follower(student, question)
        return self.instances[place]

    def follower(self, student: str, question: str) -> Follower | None:
        """The instance, with the plan of its template."""
        template = self.templates.get(question)
        texts = self.drawn(student, question)
        if (
            template is None
            or not template.drivers
            or texts is None
            or texts.keys() < template.parameters.keys()
        ):
            return None
        values = {
            name: in_float(parameter, texts[name])
            for name, parameter in template.parameters.items()
        }
        return Follower(template, values, self.plan(question, template))

    def plan(self, question: str, template: Template) -> Plan | None:
        """The plan of a question's template, found once, and the same whoever is asked about."""
        if question not in self.plans:
            self.plans[question] = generic_plan(template)
        return self.plans[question]

    def drawn(self, student: str, question: str) -> Mapping[str, str] | None:
        """The parameters of a question on a student's paper as texts in their units; None where
        they are not there.
        """
        line = self.line(student)
        try:
            (found,) = (each for each in line["questions"] if each["question"] == question)
            return {
                name: str(each["exact"] or each["value"])
                for name, each in found["parameters"].items()
            }
        except (KeyError, TypeError, ValueError, AttributeError):
            return None

    def line(self, student: str) -> Any:
        """A student's line of key.jsonl, or else of variants.jsonl; None where there is none.

        Raises ExamError where it cannot be read.
        """
        if student not in self.beginnings:
            return self.pooled.get(student)
        with self.key.open("rb") as file:
            file.seek(self.beginnings[student])
            return _json(file.readline(), self.key)

    @property
    def key(self) -> Path:
        """The file of the key."""
        return self.exam / "key.jsonl"

    @cached_property
    def beginnings(self) -> Mapping[str, int]:
        """Where each student's line begins in key.jsonl, in bytes. Raises ExamError where it cannot
        be read.
        """
        try:
            with self.key.open("rb") as file:
                return dict(_beginnings(file, self.key))
        except OSError as fault:
            raise _unreadable(self.key, fault) from fault

    @cached_property
    def pooled(self) -> Mapping[str, Any]:
        """The lines of a pool's variants by student, of students who may have left the roster
        since. Raises ExamError.
        """
        file = self.exam / POOL
        try:
            lines = file.read_bytes().splitlines()
        except FileNotFoundError:
            return {}
        except OSError as fault:
            raise _unreadable(file, fault) from fault
        papers = [_json(line, file) for line in lines if line.strip()]
        return {str(each.get("student")): each for each in papers if isinstance(each, dict)}

    @cached_property
    def templates(self) -> Mapping[str, Template]:
        """The templates by question, those that can be read. Raises ExamError where exam.json
        cannot be read.
        """
        file, found = self.exam / "exam.json", {}
        try:
            head = _json(file.read_bytes(), file)
            questions = {str(each["question"]): str(each["template"]) for each in head["questions"]}
        except (OSError, KeyError, TypeError) as fault:
            raise _unreadable(file, fault) from fault
        for question, name in questions.items():
            try:
                found[question] = kept_template(name, self.exam / "templates")
            except KinegradeError:
                continue
        return found


def _beginnings(lines: Iterable[bytes], file: Path) -> Iterator[tuple[str, int]]:
    """The students with the bytes before their lines; of a line only as much is decoded as it
    takes.
    """
    decoder, place = json.JSONDecoder(), 0
    for line in lines:
        text = line[:1000].decode("utf-8", errors="ignore")
        if text.startswith(BEGINNING + '"'):
            yield str(decoder.raw_decode(text, len(BEGINNING))[0]), place
        elif text.strip():
            whole = _json(line, file)
            yield str(whole.get("student") if isinstance(whole, dict) else None), place
        place += len(line)


def _json(text: bytes, file: Path) -> Any:
    try:
        return json.loads(text)
    except (ValueError, RecursionError) as fault:
        raise _unreadable(file, fault) from fault


def _unreadable(file: Path, fault: Exception) -> ExamError:
    return ExamError(
        f"{file}: cannot be read ({type(fault).__name__}) - expected an exam folder made by "
        "kinegrade generate - restore it as it was generated"
    )
