"""Drawing an instance for a student: addressed by HMAC, so that it can be drawn again on any
machine in ten years.

The value of a parameter is an index into its finite domain that depends on (secret, student,
question, parameter, attempt) alone: adding a parameter, a question or a student changes nobody
else's paper. An instance that will not do is drawn again with the next attempt, and the reason is
counted.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from fractions import Fraction
from functools import lru_cache
from hmac import digest
from typing import assert_never

from kinegrade.errors import DrawError, MechanismError
from kinegrade.mechanics.plan import Plan
from kinegrade.problem.draw_screening import DrawScreening, draw_screening
from kinegrade.problem.holding import holds, wording
from kinegrade.problem.honest_rounding import stray
from kinegrade.problem.honest_rounding_arrays import FEW, surely_honest
from kinegrade.problem.kept_decimals import RightRange, fitting_factor
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.solving import Solution, solve_template
from kinegrade.problem.template import Ask, Template
from kinegrade.problem.tolerance import ONE_PER_CENT, Tolerance, effective, own_scale

MAX_ATTEMPTS = 400
SMALLEST, LARGEST = (
    1e-3,
    1e5,
)  # sizes of answers, in the ask's own unit, that a student can be asked to write
REASONS = (
    "condition",
    "mechanism",
    "degenerate",
    "absurd",
    "rounding",
    "mistake",
    "duplicate",
    "decimals",
)
SAMPLE = 400  # instances by which it is judged what mistakes can be kept apart from the truth


class Refused(Exception):
    """A drawn instance will not do; `reason` is one of REASONS, `ask` the answer that is to blame,
    the message tells more.
    """

    def __init__(self, reason: str, detail: str, ask: str = "") -> None:
        self.reason, self.ask = reason, ask
        super().__init__(detail)


@dataclass(frozen=True)
class Drawn:
    """An accepted instance: the values as texts, the attempt that gave them, and its solution."""

    values: Mapping[str, str]
    attempt: int
    solution: Solution


@dataclass
class Deck:
    """One question's template for one exam: draws for student after student, no two alike.

    `fixed` replaces the domains of some parameters. `refused` counts why draws were refused.
    `tolerances` holds for the asks it names, 1 % for the others. With `four_decimals` every right
    answer is still right with no more of them.
    """

    template: Template
    asks: tuple[str, ...]
    secret: str
    question: str
    fixed: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    refused: Counter[str] = field(default_factory=Counter)
    taken: set[tuple[str, ...]] = field(default_factory=set)
    plan: Plan | None = None
    tolerances: Mapping[str, Tolerance] = field(default_factory=dict)
    four_decimals: bool = False
    screening: DrawScreening | None = None
    drawn: dict[tuple[str, int], Mapping[str, str]] = field(default_factory=dict)
    examined: dict[tuple[str, ...], Solution | Refused] = field(default_factory=dict)

    def draw(self, student: str) -> Drawn:
        """The instance of a student. Raises DrawError when none of MAX_ATTEMPTS will do."""
        for attempt in range(MAX_ATTEMPTS):
            values = self.values(student, attempt)
            try:
                self.require_apart(student, attempt, values)
                solution = self.accept(values)
            except Refused as refusal:
                self.refused[refusal.reason] += 1
                continue
            self.taken.add(tuple(values.values()))
            return Drawn(values, attempt, solution)
        reasons = ", ".join(f"{reason} {count}" for reason, count in sorted(self.refused.items()))
        raise DrawError(
            f"{self.question} ({self.template.name}): no acceptable instance for student "
            f"{student} in {MAX_ATTEMPTS} draws (refused so far: {reasons}): widen the domains; "
            f"{self.combinations()} combinations are drawable"
        )

    def foresee(self, students: Iterable[str]) -> None:
        """Look at the first draws of many students at once; drawing for them one after the other is
        faster then.
        """
        students = tuple(students)
        self.drawn.clear()
        self.examined.clear()
        self.sight.seen.clear()
        self.sight.look(
            self.values(student, attempt)
            for student in students
            for attempt in range(self.sight.attempts)
        )
        if len(students) >= FEW:
            self.plan = self.plan or self.plan_for(students[0])
            self.examine_ahead(students)

    def plan_for(self, student: str) -> Plan | None:
        """The plan of the instance that a student would be given first of all."""
        for attempt in range(MAX_ATTEMPTS):
            values = self.values(student, attempt)
            with suppress(Refused):
                self.require_apart(student, attempt, values)
                return examine(self.template, values, self.asks, None, self.tolerances).motion.plan
        return None

    def examine_ahead(self, students: Iterable[str]) -> None:
        """Examine what each student would be given, many instances at once; then the next ones of
        those refused.
        """
        waiting = [self.unconfused(student) for student in students]
        while len(waiting) >= FEW:
            offers = [
                (attempts, values) for attempts in waiting if (values := next(attempts, None))
            ]
            found = examine_together(
                self.template,
                [values for _, values in offers],
                self.asks,
                self.plan,
                self.tolerances,
            )
            self.examined.update(
                zip((tuple(values.values()) for _, values in offers), found, strict=True)
            )
            waiting = [
                attempts
                for (attempts, _), one in zip(offers, found, strict=True)
                if isinstance(one, Refused)
            ]

    def unconfused(self, student: str) -> Iterator[Mapping[str, str]]:
        """The first draws of a student that no mistake confuses."""
        drawn = (self.values(student, attempt) for attempt in range(self.sight.attempts))
        return (values for values in drawn if not self.sight.seen[tuple(values.values())])

    @property
    def sight(self) -> DrawScreening:
        """The screening, prepared when it is first needed."""
        if self.screening is None:
            sample = [self.sampled(number) for number in range(SAMPLE)]
            self.screening = draw_screening(self.template, self.asks, self.tolerances, sample)
        return self.screening

    def require_apart(self, student: str, attempt: int, values: Mapping[str, str]) -> None:
        """Raises Refused when a known mistake would lead to an answer within tolerance of the right
        one.
        """
        key = tuple(values.values())
        if key not in self.sight.seen:
            self.sight.look(
                self.values(student, attempt + more) for more in range(self.sight.attempts)
            )
        if self.sight.seen[key]:
            raise Refused("mistake", "a known mistake leads to an answer within tolerance")

    def values(self, student: str, attempt: int) -> Mapping[str, str]:
        """The values that an attempt gives to a student."""
        if (student, attempt) not in self.drawn:
            self.drawn[student, attempt] = {
                name: choices[
                    address(self.secret, student, self.question, name, attempt) % len(choices)
                ]
                for name, choices in self.domains().items()
            }
        return self.drawn[student, attempt]

    def sampled(self, number: int) -> dict[str, str]:
        """The values of one instance of a sample, which does not depend on the secret."""
        index, values = address("mistakes", self.template.name, number), {}
        for name, choices in self.domains().items():
            index, place = divmod(index, len(choices))
            values[name] = choices[place]
        return values

    def domains(self) -> Mapping[str, tuple[str, ...]]:
        """What may be drawn for each parameter."""
        return {
            name: self.fixed.get(name, parameter.choices)
            for name, parameter in self.template.parameters.items()
        }

    def combinations(self) -> int:
        """How many combinations of values there are, acceptable or not."""
        count = 1
        for choices in self.domains().values():
            count *= len(choices)
        return count

    def accept(self, values: Mapping[str, str]) -> Solution:
        """The solution of an instance that will do. Raises Refused with the reason."""
        key = tuple(values.values())
        if key in self.taken:
            raise Refused("duplicate", "another student has these values")
        found = self.examined.get(key) or examine(
            self.template, values, self.asks, self.plan, self.tolerances
        )
        match found:
            case Refused():
                raise found
            case Solution():
                if self.four_decimals and (ask := too_fine(found, self.tolerances)):
                    raise Refused("decimals", f"{ask} is not right with four decimals", ask)
                self.plan = self.plan or found.motion.plan
                return found
            case _:
                assert_never(found)


def address(secret: str, *parts: str | int) -> int:
    """The number at an address: HMAC-SHA256 of the parts under the secret, as an integer of 256
    bits.
    """
    message = b"".join(map(framed, parts))
    return int.from_bytes(digest(secret.encode(), message, "sha256"), "big")


@lru_cache(maxsize=4096)
def framed(part: str | int) -> bytes:
    """A part of an address with its length in front."""
    text = str(part).encode()
    return len(text).to_bytes(4, "big") + text


def examine(
    template: Template,
    values: Mapping[str, str],
    asks: Iterable[str],
    plan: Plan | None = None,
    tolerances: Mapping[str, Tolerance] | None = None,
) -> Solution:
    """The solution of an instance fit for students; without a tolerance 1 % holds. Raises Refused
    with the reason.
    """
    solution = sensible(template, values, asks, plan)
    if strayed := stray(solution, tolerances or {}):
        raise Refused("rounding", str(strayed), strayed.ask)
    return solution


def examine_together(
    template: Template,
    draws: Iterable[Mapping[str, str]],
    asks: Iterable[str],
    plan: Plan | None,
    tolerances: Mapping[str, Tolerance],
) -> list[Solution | Refused]:
    """For each of many instances what `examine` gives or raises."""
    wanted = tuple(asks)
    found: list[Solution | Refused] = []
    for values in draws:
        try:
            found.append(sensible(template, values, wanted, plan))
        except Refused as refusal:
            found.append(refusal)
    sure = iter(surely_honest([one for one in found if isinstance(one, Solution)], tolerances))
    for place, one in enumerate(found):
        if isinstance(one, Solution) and not next(sure) and (strayed := stray(one, tolerances)):
            found[place] = Refused("rounding", str(strayed), strayed.ask)
    return found


def sensible(
    template: Template, values: Mapping[str, str], asks: Iterable[str], plan: Plan | None
) -> Solution:
    """The solution of an instance that meets the conditions and has answers to be asked for. Raises
    Refused.
    """
    try:
        for condition in template.scheme.conditions:
            if not holds(template, condition, values):
                raise Refused("condition", condition.text)
        for name in template.words.texts:
            if wording(template, name, values) is None:
                raise Refused("condition", f"no text of {name} applies")
        solution = solve_template(template, values, asks, plan)
    except MechanismError as error:
        raise Refused("mechanism", error.problems[0]) from error
    for name, answer in solution.answers.items():
        if refusal := unfit(template.asks[name], answer):
            raise refusal
    require_doubles(solution)
    return solution


def require_doubles(solution: Solution) -> None:
    """Raises Refused for an instance with sizes beyond the doubles in which it is worked out again
    by hand.
    """
    try:
        for answer in solution.answers.values():
            own_scale(solution.doubles, answer.measure)
    except OverflowError as error:
        raise Refused("absurd", "a size beyond 1e308") from error


def too_fine(solution: Solution, tolerances: Mapping[str, Tolerance]) -> str:
    """The first ask whose right answer is no longer right with four decimals, in any unit; "" where
    there is none.
    """
    for name, answer in solution.answers.items():
        stated = tolerances.get(name, ONE_PER_CENT)
        tolerance = effective(stated, answer.value, answer.measure, solution.doubles)
        value = Fraction(answer.certified)
        right = RightRange(value, *tolerance.interval(value))
        if fitting_factor(answer.unit, right) is None:
            return name
    return ""


def unfit(ask: Ask, answer: Quantity) -> Refused | None:
    """Why an answer cannot be asked for: at infinity, zero where zero is no proper answer, of an
    absurd size.
    """
    if answer.at_infinity:
        return Refused("degenerate", f"{ask.name} is at infinity")
    if answer.is_zero:
        return None if ask.vanishes else Refused("degenerate", f"{ask.name} is zero")
    if not SMALLEST <= abs(answer.value) <= LARGEST:
        return Refused("absurd", f"{ask.name} is {sized(answer)}")
    return None


def sized(answer: Quantity) -> str:
    """An answer with its unit, for a message."""
    return f"{answer.decimal(3)} {answer.unit}"
