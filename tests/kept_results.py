"""What follows from shipped files and stated numbers alone, found once in each process of tests: the
templates, which mistakes their draws keep apart, which of their draws are good, what equal banks
deal by equal secrets, the paths along which mechanisms move, the pictures of their vectors, and the
worked solutions and typeset pages of exams. `make prove` finds it anew, as users do.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, field, replace
from functools import partial
from hashlib import sha256
from typing import Any, TypeVar

from kinegrade.draws.deal import DeckPart, Look, Verdicts, look_here
from kinegrade.draws.draw_filter import DrawFilter, Verdict
from kinegrade.errors import KinegradeError
from kinegrade.exam.printing import printing, solution_pages
from kinegrade.exam.quiz import paper
from kinegrade.exam.setting import dealing
from kinegrade.exam.setting.alike_deal import AlikeDeal, deal_alike
from kinegrade.exam.setting.kept_deal import Stated
from kinegrade.exam.setting.setting import Exam
from kinegrade.figure.scene import Scene
from kinegrade.figure.vectors.mechanism import draw_with_vectors
from kinegrade.language import Language
from kinegrade.mechanics.plan import Plan
from kinegrade.motion import path
from kinegrade.motion.system import System
from kinegrade.motion.tracing import Trace, trace_path
from kinegrade.practice import questions
from kinegrade.press.sheet import PaperSize
from kinegrade.press.typst.press import TypstPress
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.beside import Translations
from kinegrade.problem.template.library import library
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.sections.opening import FOLDER, Mechanisms
from kinegrade.problem.template.template import Ask, Method, Template
from kinegrade.processes.executor import THIS_PROCESS, Shared
from kinegrade.students import kept_apart
from kinegrade.students.kept_apart import find_separation
from kinegrade.students.mistaking.mistakes import Values
from kinegrade.students.rounding.accuracy import Accuracy
from kinegrade.students.separation import Separation
from kinegrade.worked.document import WorkedSolution
from kinegrade.worked.solution import write_worked_solution
from kinegrade.worked.steps import pictures

Kept = TypeVar("Kept")
look_elsewhere = dealing._look_by
MANY = 300  # pictures or paths, of which some take as much memory as a template
_MECHANISMS = library.find_shipped("templates") / FOLDER


@dataclass(frozen=True)
class KeptResults:
    """Templates by their texts, and the rest by all that it depends on."""

    templates: dict[object, Template] = field(default_factory=dict)
    own: dict[str, Template] = field(default_factory=dict)
    separations: dict[object, Separation] = field(default_factory=dict)
    deals: dict[str, AlikeDeal] = field(default_factory=dict)
    verdicts: dict[str, dict[tuple[str, ...], Verdict]] = field(default_factory=dict)
    traces: dict[str, Trace] = field(default_factory=dict)
    scenes: dict[str, Scene] = field(default_factory=dict)
    solutions: dict[str, WorkedSolution] = field(default_factory=dict)
    pages: dict[str, bytes] = field(default_factory=dict)
    shipped: set[int] = field(default_factory=set)  # the identities of those templates

    def read_template(
        self,
        name: str,
        text: str,
        mechanisms: Mechanisms,
        translations: Translations,
        *,
        kept: bool,
        steps: bool,
    ) -> Template:
        """As `read_template` of the library; a shipped one is read once, and so is one that an exam
        keeps of it, or that stands beside a bank.
        """
        given = text, mechanisms, translations
        if not isinstance(mechanisms, partial) or mechanisms.args != (_MECHANISMS,):
            read = partial(read_template, name, *given, kept=kept, steps=steps)
            if (shared := _find_shared(text, mechanisms)) is None:
                return read()
            said = name, text, shared, sorted(translations.items()), kept, steps
            return _keep(self.own, sha256(repr(said).encode()).hexdigest(), read)
        key = name, text, tuple(sorted(translations.items())), kept
        if key not in self.templates:
            self.templates[key] = read_template(name, *given, kept=kept)
            self.shipped.add(id(self.templates[key]))
        return self.templates[key]

    def find_separation(
        self,
        template: Template,
        asks: Mapping[str, Ask],
        accuracy: Accuracy,
        plan: Plan,
        sample: Values,
    ) -> Separation:
        """As `find_separation` of students; that of a shipped template is found once."""
        given = template, asks, accuracy, plan, sample
        if id(template) not in self.shipped:
            return find_separation(*given)
        tolerances = tuple(sorted(accuracy.tolerances.items()))
        drawn = tuple((name, tuple(values)) for name, values in sample.items())
        judged = tuple(asks), tolerances, accuracy.carry, accuracy.honest
        key = id(template), plan, drawn, judged
        if key not in self.separations:
            self.separations[key] = find_separation(*given)
        return self.separations[key]

    def deal_alike(
        self, exam: Exam, places: Mapping[str, int], stated: Stated, look: Look
    ) -> AlikeDeal:
        """As `deal_alike` of exams; where no other process looks or is to have the figures, an
        equal exam is dealt once, and a combination of an equal question is judged once.
        """
        if exam.sketchbook is not None or not _looks_here(look):
            return deal_alike(exam, places, stated, look)
        key = sha256(repr((exam.bank, exam.secret, places, stated)).encode()).hexdigest()
        looking = partial(self.look, exam, look)
        return _keep(self.deals, key, lambda: deal_alike(exam, places, stated, looking))

    def look(self, exam: Exam, look: Look, parts: Sequence[DeckPart]) -> Iterator[Verdicts]:
        """As `look`, which is asked about what no exam of this process has looked at."""
        for part in parts:
            each = exam.filters[part.question]
            judged = self.verdicts.setdefault(_identify(each), {})
            drawn = {tuple(each.deck.combination(at).values()): at for at in part.positions}
            new = {values: at for values, at in drawn.items() if values not in judged}
            asked = [DeckPart(part.question, range(at, at + 1)) for at in new.values()]
            judged |= {values: verdict for values, (verdict,) in zip(new, look(asked), strict=True)}
            yield tuple(judged[values] for values in drawn)

    def trace_path(self, system: System) -> Trace:
        """As `trace_path` of motion; that of equal conditions is found once."""
        key = repr((system.frames, system.input, system.rates))
        return _keep(self.traces, key, lambda: trace_path(system))

    def draw_with_vectors(self, *given: Any) -> Scene:
        """As `draw_with_vectors` of figures; equal pictures are drawn once."""
        return _keep(self.scenes, repr(given), lambda: draw_with_vectors(*given))

    def write_worked_solution(
        self,
        solution: Solution,
        asks: tuple[str, ...],
        language: Language,
        method: Method | None = None,
    ) -> WorkedSolution:
        """As `write_worked_solution` of worked; that of an equal instance is written once."""
        instance = solution.template, dict(solution.parameters), dict(solution.answers)
        key = sha256(repr((instance, asks, language, method)).encode()).hexdigest()
        given = solution, asks, language, method
        return _keep(self.solutions, key, lambda: write_worked_solution(*given))

    def make_press(self, paper_size: PaperSize = "a4") -> TypstPress:
        """As `TypstPress`, for exams; pages of an equal source are typeset once."""
        press = TypstPress(paper_size)
        typeset = press._pdf

        def keep(source: str, standard: Any) -> bytes:
            key = sha256(f"{standard} {source}".encode()).hexdigest()
            return _keep(self.pages, key, lambda: typeset(source, standard))

        press._pdf = keep  # type: ignore[method-assign]
        return press


def _find_shared(text: str, mechanisms: Mechanisms) -> object:
    """The mechanism that a template shares, or that there is none; None where it cannot be told."""
    if not re.search(r"""mechanism["']?\s*=""", text):
        return ""
    name = re.search(r'(?m)^mechanism *= *"([a-z0-9-]+)"', text)
    try:
        return mechanisms(name[1]) if name else None
    except KinegradeError:
        return None


def _look_by(workers: Executor, shared: Shared[Exam]) -> Look:
    """As `_look_by` of dealing, recognisable where this process looks itself."""
    if workers is THIS_PROCESS:
        return partial(look_here, shared.value.filters)
    return look_elsewhere(workers, shared)


def _looks_here(look: Look) -> bool:
    return isinstance(look, partial) and look.func is look_here


def _identify(question: DrawFilter) -> str:
    """What verdicts on values depend on: all that a filter has, but not the order of its deck."""
    order_apart = replace(question, deck=replace(question.deck, secret="", question=""))
    return sha256(repr(order_apart).encode()).hexdigest()


def _keep(kept: dict[str, Kept], key: str, find: Callable[[], Kept]) -> Kept:
    """What is kept under a key, found first where nothing is; the oldest goes where many are."""
    if key not in kept:
        kept[key] = find()
    found = kept[key]
    if len(kept) > MANY:
        kept.pop(next(iter(kept)))
    return found


def keep_results() -> None:
    """Let all tests of this process share what follows from shipped files."""
    results = KeptResults()
    library.read_template = results.read_template  # type: ignore[assignment]
    kept_apart.find_separation = results.find_separation
    dealing.deal_alike = results.deal_alike
    dealing._look_by = _look_by
    printing.TypstPress = results.make_press  # type: ignore[assignment, misc]
    path.trace_path = results.trace_path
    for module in (paper, questions, solution_pages):
        module.write_worked_solution = results.write_worked_solution
    pictures.draw_with_vectors = results.draw_with_vectors
