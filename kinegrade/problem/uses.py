"""Whether the parts of a template name only what the template has: points, bodies, values, asks."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field

from kinegrade.errors import did_you_mean
from kinegrade.expression import Expression, names
from kinegrade.language import LANGUAGES
from kinegrade.mechanics.geometry import BRANCHES
from kinegrade.mechanics.joints import GROUND
from kinegrade.problem.conditions import mixed
from kinegrade.problem.slots import slot_faults
from kinegrade.problem.template import Condition, Template, Translated


@dataclass(frozen=True)
class Uses:
    """Checks names where they are used; `fault` takes a path in the template's tables and what is
    wrong there.

    `faulty` are names that the file declares by something that cannot be read: that is reported
    once, there, and not again wherever the name is used. `unknown` collects the names that are not
    there, with the places and what is to be said at each; the first one stands for all.
    """

    fault: Callable[[str, str], None]
    faulty: frozenset[str] = frozenset()
    unknown: dict[str, list[tuple[str, str]]] = field(default_factory=dict)

    def check(self, template: Template) -> None:
        """Names in expressions are known where they are used; published results and asks belong
        together.
        """
        parameters = {*template.parameters, "pi"}
        self.check_order("lengths", template.scheme.lengths, parameters)
        self.check_order(
            "points", template.scheme.points, {*parameters, *template.scheme.lengths, *BRANCHES}
        )
        self.check_sentences(
            template, {*parameters, *template.scheme.lengths, *BRANCHES, *template.scheme.points}
        )
        for index, condition in enumerate(template.scheme.conditions):
            self.check_condition(f"conditions[{index}]", condition, template)
        self.check_texts(template, {*template.parameters, *self.faulty})
        for index, result in enumerate(template.published):
            for name, tree in result.gives.items():
                if name not in template.asks and name not in self.faulty:
                    self.fault(
                        f"published[{index}]",
                        f'no ask "{name}": {did_you_mean(name, template.asks)}',
                    )
                self.check_known(f"published[{index}].gives.{name}", tree, parameters)
        self.report_unknown()

    def miss(self, name: str, path: str, problem: str) -> None:
        """Note that a name is used and not there."""
        self.unknown.setdefault(name, []).append((path, problem))

    def report_unknown(self) -> None:
        """A fault for every name that is not there, at the first place where it is used."""
        for (path, problem), *others in self.unknown.values():
            places = len(dict.fromkeys(others))
            more = f" (and at {places} more place{'' if places == 1 else 's'})" if places else ""
            self.fault(path, problem + more)

    def check_condition(self, path: str, condition: Condition, template: Template) -> None:
        """A condition names parameters, and compares angles with angles."""
        for tree in (condition.left, condition.right):
            self.check_known(path, tree, {*template.parameters, "pi"})
        if mixed(condition, template.angles):
            self.fault(
                path,
                f'"{condition.text}": an angle against a number: '
                "write degrees as parts of pi, like phi < pi/2",
            )

    def check_texts(self, template: Template, parameters: Collection[str]) -> None:
        """Statements name parameters and texts, texts name parameters; texts have names of their
        own.

        `parameters` are all that the file describes, also those that could not be read.
        """
        for name, wordings in template.words.texts.items():
            if name in parameters:
                self.fault(f"text.{name}", "one name for two things: rename one of them")
            for index, wording in enumerate(wordings):
                path = f"text.{name}[{index}]"
                if wording.condition is not None:
                    self.check_condition(path, wording.condition, template)
                self.check_slots(path, wording.text, parameters, ())
        self.check_slots("statement", template.words.statement, parameters, template.words.texts)

    def check_slots(
        self,
        path: str,
        text: Translated,
        parameters: Collection[str],
        texts: Collection[str],
    ) -> None:
        """A fault for everything in double braces that is no name known here, once in each
        language.
        """
        for language in LANGUAGES:
            for name, problem in dict.fromkeys(
                slot_faults(text.in_language(language), parameters, texts)
            ):
                if name:
                    self.miss(name, f"{path}.{language}", problem)
                else:
                    self.fault(f"{path}.{language}", problem)

    def check_order(self, key: str, trees: Mapping[str, Expression], known: set[str]) -> None:
        """Lengths and points may name what stands before them."""
        for name, tree in trees.items():
            self.check_known(f"{key}.{name}", tree, known)
            known = {*known, name}

    def check_sentences(self, template: Template, known: set[str]) -> None:
        """Joints, inputs and asks name bodies, points and values that there are."""
        bodies = {GROUND, *(body.name for body in template.scheme.bodies)}
        for joint in template.scheme.joints:
            self.check_listed(
                joint.text, "body", (joint.body, joint.of, joint.carrier, *joint.bodies), bodies
            )
            self.check_listed(joint.text, "point", (joint.point,), set(template.scheme.points))
            for shape in (joint.circle, joint.on):
                self.check_known(joint.text, shape, known)
        for driver in template.scheme.drivers:
            self.check_listed(driver.text, "body", (driver.body, driver.of), bodies)
            self.check_listed(
                driver.text, "point", (driver.point, driver.centre), set(template.scheme.points)
            )
            for tree in (driver.velocity, driver.acceleration, driver.along):
                self.check_known(driver.text, tree, known)
        for name, ask in template.asks.items():
            self.check_known(f"asks.{name}", ask.quantity, known | bodies)

    def check_listed(self, path: str, kind: str, named: tuple[str, ...], there: set[str]) -> None:
        """A fault for every body or point that is named and not there; parts that a sentence lacks
        are empty.
        """
        for name in named:
            if name and name not in there and name not in self.faulty:
                self.miss(name, path, f'no {kind} "{name}": {did_you_mean(name, there)}')

    def check_known(self, path: str, tree: Expression | None, known: set[str]) -> None:
        """A fault for every name that is not known at this place."""
        for name in dict.fromkeys(names(tree)) if tree is not None else ():
            if name not in known and name not in self.faulty:
                self.miss(name, path, f'unknown name "{name}": {did_you_mean(name, known)}')
