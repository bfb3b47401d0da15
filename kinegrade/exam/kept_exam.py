"""The papers of an exam derived again from what its folder keeps, each held against the key."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from kinegrade.exam.bank import read_kept_bank
from kinegrade.exam.blueprint import Bank, BankQuestion
from kinegrade.exam.derivation import derive_question
from kinegrade.exam.folder.contents import BANK, TEMPLATES
from kinegrade.exam.folder.contradictions import contradicted
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.records import KeyLine, KeyQuestion
from kinegrade.exam.setting import SetQuestion
from kinegrade.mechanics.plan import Plan
from kinegrade.problem.follow_through import generic_plan


@dataclass(frozen=True)
class KeptExam:
    """An exam as its folder keeps it: the bank and the templates by copies, and for each student
    the values drawn.
    """

    exam: ExamFolder

    @cached_property
    def bank(self) -> Bank:
        """The bank from its copy. Raises BankError."""
        chosen = {each.question: each.template for each in self.exam.head.questions}
        return read_kept_bank(self.exam.path / BANK, self.exam.path / TEMPLATES, chosen)

    def derive(self, line: KeyLine, kept: KeyQuestion, plan: Plan | None = None) -> SetQuestion:
        """A question of a paper solved again, faster by a plan that may serve.

        Raises ExamError where something else follows than the key says, BankError.
        """
        where = f'{self.exam.key}: student "{line.student}", {kept.question}'
        question = self._questions.get(kept.question)
        if question is None:
            raise contradicted(where, ["is no question of the bank"])
        return derive_question(question, kept, where, plan)

    def require_no_contradiction(self) -> None:
        """Raises ExamError where something else follows for a paper than the key says."""
        plans = {name: generic_plan(each.template) for name, each in self._questions.items()}
        for line in self.exam.lines():
            for kept in line.questions:
                self.derive(line, kept, plans.get(kept.question))

    @cached_property
    def _questions(self) -> Mapping[str, BankQuestion]:
        return {each.identifier: each for each in self.bank.questions}
