"""From an exam folder and an answer sheet to a marks folder: everything behind `kinegrade
grade`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import assert_never

from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.ownership import list_moved
from kinegrade.files.answer_file import AnswerFile
from kinegrade.files.output import output_folder
from kinegrade.files.placing.edits import find_edits
from kinegrade.files.placing.standing import Standing
from kinegrade.files.tables import Table, read_table
from kinegrade.grade_scale.kinds import make_scale
from kinegrade.grade_scale.scale import Scale
from kinegrade.grading.accepted_counts import AcceptedCounts
from kinegrade.grading.answer_lines import write_marks
from kinegrade.grading.by_hand.gathering import Gathered, HandSources, gather_hand_marks
from kinegrade.grading.by_hand.markable import find_markable
from kinegrade.grading.by_hand.settling import HandMarking, Settled
from kinegrade.grading.by_hand.staying import StayingMarks
from kinegrade.grading.fast.another_paper import PapersAnswered
from kinegrade.grading.judging.follow import Follows
from kinegrade.grading.kept_totals import EarlierTotals
from kinegrade.grading.lateness.submissions import check_times
from kinegrade.grading.marking import MarkingTerms, mark_blocks
from kinegrade.grading.marks import ClassGrades, collect_grades
from kinegrade.grading.misplaced.class_answers import AnswersSeen
from kinegrade.grading.misplaced.other_papers import refuse_other_papers
from kinegrade.grading.misplaced.typing_slips import find_typing_slips, put_after
from kinegrade.grading.policy.accepted import alternatives
from kinegrade.grading.policy.policy import Policy
from kinegrade.grading.policy.reading import read_policy, stated_policy
from kinegrade.grading.same_key import identify_exam, require_same_exam, require_unmerged
from kinegrade.grading.sheets.class_sheet import class_sheet
from kinegrade.grading.sheets.pool import read_pool
from kinegrade.grading.totals import TotalTerms, work_out_totals
from kinegrade.grading.typed.decimal_style import Mark as DecimalMark
from kinegrade.grading.unfollowed import find_unfollowed
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message
from kinegrade.marks_folder.folder import MarksFolder, open_marks
from kinegrade.marks_folder.hand_marks import list_hand_marks
from kinegrade.marks_folder.layout import FILES, FILLED_IN, MARKER
from kinegrade.marks_folder.writing import MarksWriter
from kinegrade.processes.garbage_collection import bulk_work

Export = Callable[[MarksFolder], str]  # a marks folder -> the text of another file in it


@dataclass(frozen=True, slots=True)
class MarkingWishes:
    """How a class is marked.

    `exports` names the files for other systems that also go into the folder, such as
    `{"moodle.csv": kinegrade.lms.grades.moodle.export}`. `decimal` declares the decimal mark of the
    sheet. `policy` is a file, copied into the folder; `manual` are files of marks by hand, which
    stand beside those that are carried over from the marking that is replaced or that goes `before`
    this one; `never_lower` is an earlier marking whose totals are kept where they are higher;
    `follows` works out what follows from wrong answers. A
    marking in which most answers fit other papers is refused, unless `own_papers` confirms that
    they belong to the students' own. A `pseudonymous` marking leaves names out of the folder. What
    is replaced is still what `stood` there when it was read.
    """

    exports: Mapping[str, Export] = field(default_factory=dict)
    decimal: DecimalMark | None = None
    policy: Path | None = None
    never_lower: MarksFolder | None = None
    follows: Follows | None = None
    own_papers: bool = False
    manual: tuple[Path, ...] = ()
    pseudonymous: bool = False
    before: MarksFolder | None = None
    stood: Standing | None = None

    def find_hand_sources(self, output: Path) -> HandSources:
        """Where marks by hand come from, when they are written into a folder."""
        earlier = None if self.before is None else self.before.path
        return HandSources(self.manual, output, earlier)


_PLAIN = MarkingWishes()


def grade(
    exam: ExamFolder,
    answers: Path | Table | Sequence[AnswerFile],
    output: Path,
    wishes: MarkingWishes = _PLAIN,
    *,
    force: bool = False,
) -> ClassGrades:
    """Writes the folder `output`, whole or not at all, and gives all grades and complaints.

    `answers` is an answer sheet, as a file or a table, or the files of one class as
    `kinegrade.lms.responses` reads them. Raises ExamError, PolicyError, TableError, OutputError.
    """
    contents = *FILES, *wishes.exports
    edits = find_edits(output, marker=MARKER, guarded=FILLED_IN)
    written = output_folder(output, marker=MARKER, contents=contents, force=force)
    with bulk_work(), written as path:
        marks = _mark(exam, answers, MarksWriter(path, exam.language), output, wishes)
        # The cells of the sheet are let go before the marks are read again
        if wishes.exports:
            _write_exports(path, wishes.exports)
        edits.settle(path)
    return replace(marks, notes=(*marks.notes, *edits.describe()))


def _mark(
    exam: ExamFolder,
    answers: Path | Table | Sequence[AnswerFile],
    folder: MarksWriter,
    output: Path,
    wishes: MarkingWishes,
) -> ClassGrades:
    """Writes all files of the folder but the exports."""
    sources = wishes.find_hand_sources(output)
    _require_same_exam(exam, wishes, sources)
    files = _read_files(answers)
    sheet, rules = class_sheet(files, exam), _choose_policy(exam, wishes.policy)
    told = *find_unfollowed(exam), *check_times(sheet, rules.penalties.late)
    pool, papers, seen = read_pool(exam, sheet), PapersAnswered(exam), AnswersSeen(len(exam.asks))
    accepted = alternatives(exam, rules, exam, pool.put_together(exam, sheet), pool.papers)
    orders = exam.printed_orders()
    staying = StayingMarks.of(exam, files)
    hands = gather_hand_marks(sources, find_markable(exam, rules, orders), staying)
    by_hand = HandMarking.under(rules, exam, hands.by_hand)
    marked = hands.students, by_hand.settle_grade
    terms = MarkingTerms(
        rules, accepted, wishes.decimal, wishes.follows, pool, *marked, wishes.own_papers
    )
    counts = AcceptedCounts(rules, exam.asks)
    blocks = by_hand.watched(counts.watched(seen.watched(mark_blocks(papers, sheet, terms))))
    grades = collect_grades(exam, sheet, write_marks(folder, blocks))
    if not wishes.own_papers:
        answered = seen.put_together()
        refuse_other_papers(answered, papers, ", ".join(each.table.file for each in files))
        slips = find_typing_slips(exam, papers, sheet.columns, answered)
        grades = replace(grades, complaints=put_after(files, slips, grades.complaints))
    settled = by_hand.settle(_leave_out_names(grades) if wishes.pseudonymous else grades)
    scale = None if settled.still_open else _make_scale(rules, exam.language)
    grades = replace(settled.grades, complaints=(*told, *settled.grades.complaints))
    earlier = _find_earlier(exam, wishes.never_lower)
    grades = _write_totals(folder, grades, TotalTerms(rules.penalties, earlier, scale))
    folder.policy(rules.text)
    folder.printed(orders)
    _write_by_hand(folder, settled, hands, exam)
    return replace(grades, notes=(*hands.notes, *by_hand.describe_silent(), *counts.describe()))


def _require_same_exam(exam: ExamFolder, wishes: MarkingWishes, sources: HandSources) -> None:
    """Raises TableError for a marking before, that is replaced, or whose marks by hand are given,
    of another exam or of several; OutputError where what is replaced has changed.
    """
    if wishes.stood is not None:
        wishes.stood.require(sources.replaced, sources.replaced)
    for earlier in (wishes.before, wishes.never_lower):
        if earlier is not None:
            require_same_exam(exam, earlier)
            require_unmerged(earlier)
    for path in sources.own_lists:
        require_same_exam(exam, MarksFolder(path.parent))
        require_unmerged(MarksFolder(path.parent))
    replaced = MarksFolder(sources.replaced)
    require_unmerged(replaced)
    require_same_exam(exam, replaced, Message("marks.choose-folder"))


def _leave_out_names(grades: ClassGrades) -> ClassGrades:
    return replace(grades, grades=grades.grades.without_names())


def _write_by_hand(
    folder: MarksWriter, settled: Settled, hands: Gathered, exam: ExamFolder
) -> None:
    """Writes the marks by hand, and who still lacks one; and by which key of which exam."""
    identity = identify_exam(exam.head)
    folder.exam(identity)
    folder.corrections(exam.head.corrections)
    folder.former_ids(exam.former_ids)
    folder.by_hand(settled.list_marks())
    folder.left_out(list_hand_marks(hands.left_out))
    grades = settled.grades.grades
    names = dict(zip(grades.students, grades.names, strict=True)) if settled.still_open else {}
    folder.open(settled.still_open, names, hands.comments, identity, codes=hands.codes)
    folder.bonus({**exam.head.bonus, **settled.bonus})


def _find_earlier(exam: ExamFolder, marks: MarksFolder | None) -> EarlierTotals | None:
    """The earlier totals, by the ids that the students have now."""
    if marks is None:
        return None
    now, moved = exam.former_ids, frozenset(list_moved(exam.head, marks.corrections))
    had = marks.totals.by_student.items()
    return EarlierTotals({now.get(student, student): each for student, each in had}, moved)


def _make_scale(rules: Policy, language: Language) -> Scale | None:
    """The scale of the policy or the bank, in the words of the papers."""
    return None if rules.scale is None else make_scale(rules.scale, open_catalogue(language))


def _write_totals(folder: MarksWriter, grades: ClassGrades, terms: TotalTerms) -> ClassGrades:
    """Writes the totals and complaints, and gives them with the earlier totals that stand."""
    totals = work_out_totals(grades, terms)
    if terms.earlier is not None:
        folder.kept(totals.kept)
    if terms.penalties.are_any:
        folder.subtracted(totals.subtracted)
    subtracting = terms.penalties.are_any
    folder.grades(grades.questions, totals.marks.grades, terms.scale, subtracting=subtracting)
    folder.complaints(totals.marks.complaints)
    return totals.marks


def _write_exports(path: Path, exports: Mapping[str, Export]) -> None:
    """Files for other systems, made from the contents of the folder, which are read again, and held
    against each other, before anybody receives them.
    """
    folder = open_marks(path)
    for name, export in exports.items():
        (path / name).write_text(export(folder), encoding="utf-8", newline="")


def _read_files(answers: Path | Table | Sequence[AnswerFile]) -> Sequence[AnswerFile]:
    match answers:
        case Path():
            return [AnswerFile(read_table(answers))]
        case Table():
            return [AnswerFile(answers)]
        case Sequence():
            return answers
        case _:
            assert_never(answers)


def _choose_policy(exam: ExamFolder, policy: Path | None) -> Policy:
    """The policy in that file, or the one stated in the bank where there is none. Raises
    PolicyError.
    """
    return stated_policy(exam) if policy is None else read_policy(policy, exam)
