"""The case whose solution is written: the one context that every chapter is given."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from typing import Any, assert_never

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.math.latex import SOURCE, write_latex_row
from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.language.sentence import write_sentence
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.rates import Rate, Rates, make_turning
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.quantities.reader import MotionReader
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.sentences import JointSentence
from kinegrade.problem.template.template import Method, Template
from kinegrade.worked.construction_steps import Step, list_steps
from kinegrade.worked.document import Display, Prose, say
from kinegrade.worked.drawings import Drawings
from kinegrade.worked.findings import Findings
from kinegrade.worked.formulas.atoms import Symbol
from kinegrade.worked.formulas.equation import Equation
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.notation import Notation
from kinegrade.worked.formulas.symbols import collect_symbols
from kinegrade.worked.nearby import find_nearby_motion, find_nearby_points
from kinegrade.worked.words.naming import Naming


@dataclass(frozen=True)
class Case:
    """A solved instance, the language and method of its solution, the unit in which it counts
    lengths, the digits that rounded numbers have beyond the usual ones, its drawings, and what it
    has found so far.

    Chapters are written in order; `findings` is their notebook.
    """

    solution: Solution
    language: Language
    method: Method | None = None
    length: str = "m"
    more_digits: int = 0
    drawings: Drawings = field(default_factory=Drawings, compare=False, repr=False)
    findings: Findings = field(default_factory=Findings)

    @property
    def template(self) -> Template:
        """The template of the instance."""
        return self.solution.template

    @property
    def motion(self) -> Motion:
        """The motion of the instance."""
        return self.solution.motion

    @property
    def arithmetic(self) -> Any:
        """The arithmetic in which the instance is solved."""
        return self.solution.arithmetic

    def rates(self, level: Level) -> Rates:
        """The rates of the motion, or their changes."""
        match level:
            case "velocity":
                return self.motion.rates
            case "acceleration":
                return self.motion.changes
            case _:
                assert_never(level)

    @cached_property
    def naming(self) -> Naming:
        """The names of bodies, points and rates."""
        return Naming(self.template, self.language)

    @cached_property
    def symbols(self) -> Mapping[str, Symbol]:
        """The symbols of everything that the template's expressions may name."""
        return collect_symbols(self.template)

    @cached_property
    def named_rows(self) -> frozenset[Row]:
        """How the symbols of givens and of lengths that the template names are printed."""
        named = (*self.template.parameters, *self.template.scheme.lengths)
        return frozenset(self.symbols[name].row for name in named)

    @cached_property
    def construction(self) -> tuple[Step, ...]:
        """The points of the template with their constructions, step by step."""
        return list_steps(self.template)

    @cached_property
    def nearby(self) -> Mapping[str, Vector] | None:
        """The points of the mechanism with slightly other numbers, None where it has no such."""
        return find_nearby_points(self.solution)

    @cached_property
    def translating(self) -> frozenset[str]:
        """The bodies that never turn: kept parallel by a joint, or by all joints together, which
        shows in that they do not turn with slightly other numbers either.
        """
        held = self.motion.frames.mechanism.find_translating()
        still = frozenset(_find_unturned(self.motion)) - held
        if still:
            nearby = find_nearby_motion(self.solution)
            still &= frozenset(_find_unturned(nearby) if nearby else ())
        return still | held

    @property
    def held_rates(self) -> frozenset[Rate]:
        """The rotations of these bodies, which are known to be zero."""
        return frozenset(map(make_turning, self.translating))

    @cached_property
    def reader(self) -> MotionReader:
        """What the asks measure of the motion."""
        return MotionReader(self.motion, self.arithmetic)

    @cached_property
    def notation(self) -> Notation:
        """How the formulas of the solution print."""
        return Notation(open_catalogue(self.language).decimal_mark, self.length, self.more_digits)

    def write(self, message: Message) -> str:
        """What a message says in the language of the solution."""
        return write_sentence(message, self.language)

    def say(self, message: Message) -> Prose:
        """A paragraph that says a message, with the formulas that stand in it."""
        said, written = say(message, self.language), self.findings.written
        told = said.text.split("$")[1::2]
        return replace(said, formulas=tuple(written[one] for one in told if one in written))

    def show(self, *equations: Equation) -> Display:
        """Equations one below the other."""
        return Display(tuple(map(self.print_line, equations)))

    def print_line(self, equation: Equation) -> Row:
        """An equation on one line, of which the notebook is told."""
        self.findings.printed.append(equation)
        return equation.print_line(self.notation)

    def break_lines(self, equation: Equation) -> tuple[Row, ...]:
        """An equation on as many lines as it needs, of which the notebook is told."""
        self.findings.printed.append(equation)
        return equation.break_lines(self.notation)

    def text(self, formula: Formula) -> str:
        """A formula as a part of a sentence, in LaTeX math without dollar signs."""
        return self._tell(formula.print(self.notation))

    def tell(self, equation: Equation) -> str:
        """An equation within a sentence, with its dollar signs."""
        self.findings.printed.append(equation)
        return self.mention(equation)

    def mention(self, equation: Equation) -> str:
        """The same for an equation that is content with the digits that the others need."""
        return f"${self._tell(equation.print_inline(self.notation))}$"

    def _tell(self, row: Row) -> str:
        """A formula of a sentence, which the notebook keeps as such."""
        text = write_row(row)
        self.findings.told.append(row)
        self.findings.written[text] = row
        return text

    def joint(self, term: Term) -> JointSentence | None:
        """The sentence of the joint that guides a sliding or circling point, None for a free
        point.
        """
        number = self.motion.frames.guiding.get(term.rate)
        return None if number is None else self.template.scheme.joints[number]


def _find_unturned(motion: Motion) -> Iterator[str]:
    """The bodies that neither turn at the instant nor begin to."""
    for body in motion.frames.bases:
        rate = make_turning(body)
        if rate in motion.rates and all(
            _is_nothing(rates[rate]) for rates in (motion.rates, motion.changes)
        ):
            yield body


def _is_nothing(number: Any) -> bool:
    """Whether a rate is zero, but for rounding; one beyond all doubles is not."""
    try:
        return double(number) == 0
    except OverflowError:
        return False


@lru_cache(maxsize=2048)
def write_row(row: Row) -> str:
    """A math tree as LaTeX math for sentences and pictures."""
    return write_latex_row(row, SOURCE)
