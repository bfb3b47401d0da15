"""An explanation of marks for a person at a terminal."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import groupby
from shlex import quote

from kinegrade.exam.folder.contents import PAPERS
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.printing.rules import make_percent
from kinegrade.files.csv_writing import restore
from kinegrade.grading.judging.carried_on import CarriedOn
from kinegrade.grading.verdict_names import name_verdict
from kinegrade.grading.wording import Wording
from kinegrade.language.catalogue import Catalogue
from kinegrade.language.lines import show_in_one_line
from kinegrade.language.message import Message, Part, Quoted, list_all, list_choices
from kinegrade.language.prose.plain import write_line, write_prose
from kinegrade.language.terminal_lines import align, wrap
from kinegrade.marks_folder.layout import MISTAKE
from kinegrade.marks_folder.open_questions import describe_open
from kinegrade.marks_folder.rows import MarkedAnswer
from kinegrade.numbers.amounts import write_amount
from kinegrade.question_numbers import find_other_number
from kinegrade.reports.explanation.explanation import ExplainedAnswer, Explanation
from kinegrade.reports.explanation.hand_lines import write_hand_marks
from kinegrade.reports.feedback.remarks import make_remark
from kinegrade.reports.feedback.right_answers import write_decimal, write_with_unit

_INDENT = " " * 4
_COLUMNS = 76


@dataclass(frozen=True)
class ExplanationWriter:
    """Writes an explanation in the language of `wording` and `words`."""

    explanation: Explanation
    wording: Wording
    words: Catalogue

    def write(self, exam: ExamFolder) -> str:
        """Whose paper, one answer after the other, what hands gave, and where the paper and its
        worked solution are.
        """
        by_hand = write_hand_marks(self.explanation.by_hand, self.words)
        parts = *self._head(), *self._questions(), *by_hand, "", *self._places(exam)
        return "\n".join(parts)

    def _head(self) -> Iterator[str]:
        who, total = self.explanation.candidate, self.explanation.total
        name, shown = show_in_one_line(total.name), show_in_one_line(who.student)
        yield self.words.text(
            "explain.head",
            student=f"{shown} {name}".strip(),
            code=who.paper,
            points=write_amount(total.total),
            out_of=write_amount(total.out_of),
        )
        if total.kept:
            yield self.words.write(total.kept.reason)
        if self.explanation.still_open:
            yield self.words.write(describe_open(self.explanation.still_open))

        for day, _, _, what, before, after, *out_of, reason in self.explanation.log:
            if before == after and len({*out_of}) < 2:  # only the verdict or the reason is another
                continue
            said = Message(
                "explain.changed",
                day=day,
                what=what,
                before=before,
                after=after,
                reason=show_in_one_line(restore(reason)),
            )
            yield self.words.write(said)

    def _questions(self) -> Iterator[str]:
        answers = self.explanation.answers
        for question, group in groupby(answers, lambda each: each.marked.question):
            number = self.explanation.numbers[question]
            title = write_line(self.wording.titles.get(question, question), question)
            other = find_other_number(question, number)
            place = (
                Message("feedback.question", number=number)
                if other is None
                else Message("feedback.question-known", number=number, other=other)
            )
            yield ""
            yield self.words.text("explain.question", question=place, title=title)
            for each in group:
                yield from self._write_answer(each)

    def _write_answer(self, each: ExplainedAnswer) -> Iterator[str]:
        """What is asked, and below it the facts, each beside its label."""
        column = each.marked.column
        means = write_line(self.wording.meanings.get(column, ""), column)
        sign = write_line(self.wording.conventions.get(column, ""), column)
        yield f"  {column}  {means} ({sign})" if sign else f"  {column}  {means}"
        rows = []
        for label, fact in self._list_facts(each):
            first, *others = wrap(self.words.write(fact), _COLUMNS)
            rows.append((_INDENT, self.words.text(f"explain.label-{label}"), first))
            rows += [(_INDENT, "", line) for line in others]
        yield from align(rows[0], rows[1:]).splitlines()

    def _list_facts(self, each: ExplainedAnswer) -> Iterator[tuple[str, Part]]:
        """What there is to say of an answer, each with its label."""
        answer = each.marked
        typed = show_in_one_line(answer.typed)
        yield "typed", Quoted(typed) if typed else Message("explain.nothing")
        if answer.read_as and answer.read_as != answer.typed.strip():
            yield "read-as", write_with_unit(answer.read_as, answer.unit)
        yield "right", self._describe_right(answer)
        yield "rule", _describe_rule(each)
        yield "verdict", name_verdict(answer.verdict)
        if each.carried is not None:
            yield "carried-on", _describe_carried(answer, each.carried)
        yield from self._find_mistake(answer)
        if answer.reason:
            yield "recorded", show_in_one_line(answer.reason)
        points, out_of = write_amount(answer.points), write_amount(answer.out_of)
        yield "points", Message("explain.of", points=points, out_of=out_of)

    def _find_mistake(self, answer: MarkedAnswer) -> Iterator[tuple[str, Part]]:
        """The known mistake, or what the number suggests."""
        if answer.verdict not in (MISTAKE, "wrong"):
            return
        remark = make_remark(answer, self.explanation.paper, self.wording)
        prose = write_prose(self.words.write(remark.prose), answer.column)
        label = "mistake" if answer.verdict == MISTAKE else "guess" if remark.guess else "remark"
        if prose:
            yield label, prose

    def _describe_right(self, answer: MarkedAnswer) -> str:
        """The right answer: as a decimal, and exactly where that is another expression."""
        right = self.explanation.paper.answers[answer.column]
        decimal = write_decimal(right)
        return f"{right.exact} {decimal}" if right.exact and decimal.startswith("≈") else decimal

    def _places(self, exam: ExamFolder) -> Iterator[str]:
        """Where the paper and its worked solution are, or the command that makes them; of questions
        from a pool how to print what was asked there.
        """
        who = self.explanation.candidate
        pooled = {
            each.marked.question: each.source
            for each in self.explanation.answers
            if each.source != who.student
        }
        if pooled:
            for question, source in pooled.items():
                file = quote(f"{exam.head.file_stems.get(source, source)}-solution.pdf")
                arguments = " ".join((quote(str(exam.path)), quote(source), "-o", file))
                yield self.words.text("explain.pooled", question=question, arguments=arguments)
            return
        stem = exam.head.file_stems[who.student]
        again = quote(str(exam.path)), quote(who.student), "-o"
        paper = exam.path / (who.file or f"{PAPERS}/{stem}.pdf")
        solution = exam.solution_file(who.student)
        place = Message("explain.paper", place=str(paper))
        making = Message("explain.print-paper", arguments=" ".join((*again, quote(paper.name))))
        yield self.words.write(place if paper.is_file() else making)
        place = Message("explain.solution", place=str(solution))
        file = quote(f"{stem}-solution.pdf")
        making = Message("explain.print-solution", arguments=" ".join((*again, file)))
        yield self.words.write(place if solution.is_file() else making)


def _describe_rule(each: ExplainedAnswer) -> Message:
    """The rule in short, whose it is, and from where to where an answer is right."""
    rule, unit = each.key.rule, each.marked.unit
    amounts: list[Part] = []
    if rule.relative:
        amounts.append(make_percent(Fraction(f"{float(rule.relative):.4g}")))
    if rule.figures:
        amounts.append(Message("paper.tolerance-figures", figures=rule.figures))
    if rule.absolute:
        amounts.append(write_with_unit(f"{float(rule.absolute):.4g}", unit))
    whose = "policy" if each.by_policy else "paper"
    return Message(f"explain.by-{whose}", amounts=list_choices(amounts), **_write_bounds(each))


def _write_bounds(each: ExplainedAnswer) -> dict[str, Part]:
    low, high = each.key.interval
    return {"low": _write(low), "high": write_with_unit(_write(high), each.marked.unit)}


def _describe_carried(answer: MarkedAnswer, carried: CarriedOn) -> Message:
    """From which own values, and what would have been right with them."""
    own = [f"{answer.question}.{ask} = {_write(value)}" for ask, value in carried.own.items()]
    low, high = carried.key.interval
    return Message(
        "explain.with-own",
        own=list_all(own),
        value=write_with_unit(_write(carried.key.value), answer.unit),
        low=_write(low),
        high=write_with_unit(_write(high), answer.unit),
    )


def _write(number: Fraction) -> str:
    return f"{float(number):.6g}"
