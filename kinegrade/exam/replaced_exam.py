"""What stands in an exam folder that `generate --force` replaces, so that nothing in it is lost in
silence.

Its papers may be printed already: they are compared with the new ones, student by student. Worked
solutions, the key lines of a pool, answers typed into the sheet and edited sources are kept, or the
replacement is refused.
"""

from __future__ import annotations

import json
import shutil
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from typing import Any

from kinegrade.answer_file import POOL
from kinegrade.errors import ExamError, OutputError, TableError, one_line
from kinegrade.exam.exam_secret import MARKER, ExamSecret, kept_secret
from kinegrade.files import DESKTOP_DROPPINGS
from kinegrade.tables import header_key, read_table, trimmed

KEY = "key.jsonl"
VARIANTS = POOL
SOLUTIONS = ("solutions", "solutions.pdf")
ANSWERS = "answers.csv"
OWN_COLUMNS = ("student", "name")  # of the answer sheet; in all others answers are typed
EDITED_BY_HAND = (".tex", ".sty", ".docx", ".html", ".toml", ".xlsx")
UNRECORDED = (".tex", ".docx", ".html")  # of those, what earlier versions wrote to be edited
UNKNOWN = "the exam that stood there could not be read, so nothing is known of its papers"
RESTORING = (
    "expected it as kinegrade generate wrote it - restore the exam folder, choose another one, or "
    "add --new-numbers"
)
NAMED = 5  # students or files that a message names


@dataclass(frozen=True)
class PaperChanges:
    """The students by what the replacement does to their papers."""

    unchanged: tuple[str, ...]
    changed: tuple[str, ...]
    gone: tuple[str, ...]
    added: tuple[str, ...]

    @property
    def harmless(self) -> bool:
        """Whether every paper that exists stays as it is."""
        return not self.changed and not self.gone

    def __str__(self) -> str:
        return (
            f"{len(self.unchanged)} papers keep their numbers, {len(self.changed)} changed, "
            f"{len(self.gone)} gone, {len(self.added)} new"
        )


@dataclass(frozen=True)
class ReplacedExam:
    """An exam folder that is about to be replaced; `papers` holds a digest of each student's key.

    `secret` is None where the folder is damaged, so that its papers are not known.
    """

    folder: Path
    secret: ExamSecret | None
    papers: Mapping[str, str]

    def changes(self, new: Path) -> PaperChanges:
        """How the papers differ from those of the folder `new`. Raises ExamError."""
        papers = paper_digests(new / KEY)
        common = [student for student in self.papers if student in papers]
        return PaperChanges(
            tuple(student for student in common if self.papers[student] == papers[student]),
            tuple(student for student in common if self.papers[student] != papers[student]),
            tuple(student for student in self.papers if student not in papers),
            tuple(student for student in papers if student not in self.papers),
        )

    def require_papers_kept(self, changes: PaperChanges) -> None:
        """Raises OutputError where a paper would change, or that of a student who is not in the
        roster be gone.
        """
        if changes.harmless:
            return
        whose = [*changes.changed, *changes.gone]
        names = ", ".join(whose[:NAMED]) + (", ..." if len(whose) > NAMED else "")
        removed = "and every student in the roster, " if changes.gone else ""
        raise OutputError(
            f"{self.folder}: {len(changes.changed)} of {len(self.papers)} papers would change and "
            f"{len(changes.gone)} would be gone ({names}), {len(changes.added)} be new - expected "
            "the papers as they may have been printed - keep bank, templates and --seed as they "
            f"were, {removed}choose another folder, or add --new-numbers to replace the papers"
        )


def replaced_exam(folder: Path, *, new_numbers: bool) -> ReplacedExam | None:
    """The exam that a folder holds, None where there is none.

    Raises ExamError where it is damaged, unless its papers are to be replaced by `new_numbers`;
    OutputError where answers were typed into it, for that is seen before any work is done.
    """
    if not (folder / MARKER).exists():
        return None
    if answered(folder / ANSWERS):
        raise edited_since(folder, [ANSWERS])
    try:
        secret, papers = kept_secret(folder), paper_digests(folder / KEY)
        require_everybody(folder, papers)
        return ReplacedExam(folder, secret, papers)
    except ExamError:
        if not new_numbers:
            raise
        return ReplacedExam(folder, None, {})


def settle(
    old: ReplacedExam | None, folder: Path, *, new_numbers: bool, solutions: bool
) -> tuple[PaperChanges | None, tuple[str, ...]]:
    """Keep in the new exam at `folder` what belongs to papers that stay; give the changes, and
    remarks on the rest; no changes where the old exam cannot be read.

    With `solutions` the new exam has its own. Raises OutputError where something would be lost,
    papers too but for `new_numbers`; ExamError.
    """
    if old is None:
        return None, ()
    require_nothing_edited(old.folder, folder)
    names = (VARIANTS,) if solutions else (*SOLUTIONS, VARIANTS)
    if old.secret is None:
        return None, (UNKNOWN, *dropped(names, old.folder))
    changes = old.changes(folder)
    if not new_numbers:
        old.require_papers_kept(changes)
    remarks = keep(names, old.folder, folder) if changes.harmless else dropped(names, old.folder)
    return changes, tuple(remarks)


def paper_digests(key: Path) -> dict[str, str]:
    """For each student of a key.jsonl a digest of what the paper asks and what is right on it.

    Raises ExamError.
    """
    try:
        with key.open(encoding="utf-8") as lines:
            return dict(paper_digest(json.loads(line)) for line in lines if line.strip())
    except OSError as fault:
        reason = str(fault.strerror)
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as fault:
        reason = type(fault).__name__
    raise ExamError(
        f"{key}: cannot be read ({reason}), so that nobody knows which papers would be replaced - "
        f"{RESTORING}"
    )


def require_everybody(folder: Path, papers: Collection[str]) -> None:
    """Raises ExamError where the key lacks a student who has a paper by exam.json: that paper would
    be replaced unnoticed.
    """
    try:
        head = json.loads((folder / MARKER).read_text(encoding="utf-8"))
        students = [str(entry["student"]) for entry in head["students"]]
    except (OSError, ValueError, KeyError, TypeError, RecursionError) as fault:
        raise ExamError(
            f"{folder / MARKER}: does not say who has a paper ({type(fault).__name__}), so that "
            f"nobody knows which would be replaced - {RESTORING}"
        ) from fault
    lacking = [student for student in students if student not in papers]
    if lacking:
        raise ExamError(
            f'{folder / KEY}: no line for student "{one_line(lacking[0])}" ({len(lacking)} of '
            f"{len(students)} are not there), so that nobody knows whether these papers would be "
            f"replaced - {RESTORING}"
        )


def paper_digest(line: Mapping[str, Any]) -> tuple[str, str]:
    """The student of a line, and a digest of it without the known mistakes, which are not on the
    paper.
    """
    questions = [
        {**question, "asks": {name: shown(ask) for name, ask in question["asks"].items()}}
        for question in line["questions"]
    ]
    text = json.dumps({**line, "questions": questions}, sort_keys=True)
    return str(line["student"]), sha256(text.encode()).hexdigest()


def shown(ask: Mapping[str, Any]) -> dict[str, Any]:
    """What a paper and its marks depend on, of an ask in the key."""
    return {name: value for name, value in ask.items() if name != "mistakes"}


def keep(names: Iterable[str], old: Path, new: Path) -> Iterator[str]:
    """Copy into the folder `new` what belongs to papers that stay, and say so."""
    for name in names:
        source = old / name
        if source.is_dir():
            shutil.copytree(source, new / name)
        elif source.is_file():
            shutil.copy2(source, new / name)
        else:
            continue
        lacking = "" if name == VARIANTS else ", without papers that are new"
        yield f"{name} stays as it was{lacking}"


def dropped(names: Iterable[str], old: Path) -> Iterator[str]:
    """What belonged to papers that are replaced and goes with them, said."""
    for name in names:
        if (old / name).exists():
            yield f"{name} belonged to the papers that were replaced, and is gone"


def editable(folder: Path) -> dict[str, str]:
    """A digest of each file that people edit where it stands, by its path in the folder."""
    return {
        file.relative_to(folder).as_posix(): sha256(file.read_bytes()).hexdigest()
        for file in sorted(folder.rglob("*"))
        if file.suffix in EDITED_BY_HAND and file.is_file()
    }


def require_nothing_edited(old: Path, new: Path) -> None:
    """Raises OutputError where the folder `old` holds work of people's hands that the folder `new`
    does not hold.
    """
    lost = [*edited(old, new), *added(old, new), *([ANSWERS] if answered(old / ANSWERS) else [])]
    if lost:
        raise edited_since(old, lost)


def edited_since(folder: Path, names: Sequence[str]) -> OutputError:
    """The refusal to replace a folder that holds these files."""
    return OutputError(
        f"{folder}: holds {', '.join(names[:NAMED])}, edited or added since it was generated, "
        "which would be lost - expected only what is written again - move it elsewhere or choose "
        "another folder"
    )


def edited(old: Path, new: Path) -> Iterator[str]:
    """The files of a folder that differ from what was generated, and from what stands in the folder
    `new`.

    Of folders that do not say what was generated, those that are made to be edited and differ from
    the new ones.
    """
    stated = editable_as_stated(old)
    fresh = editable(new)
    for name, found in editable(old).items():
        unknown = stated is None and not name.endswith(UNRECORDED)
        if unknown or found == fresh.get(name):
            continue
        if stated is None or found != stated.get(name):
            yield name


def added(old: Path, new: Path) -> Iterator[str]:
    """The files below the folders of an exam that `generate` did not write there, such as notes
    beside the papers; of those that people edit, `edited` knows.
    """
    stems = paper_stems(old)
    for file in sorted(old.glob("*/**/*")) if stems else ():
        own = file.stem in stems and file.suffix == ".pdf"
        known = own or file.suffix in EDITED_BY_HAND or file.name in DESKTOP_DROPPINGS
        name = file.relative_to(old)
        if file.is_file() and not known and not (new / name).exists():
            yield name.as_posix()


def paper_stems(folder: Path) -> frozenset[str]:
    """How the files of each student are called by exam.json, without their kinds; empty where it
    does not say.
    """
    try:
        head = json.loads((folder / MARKER).read_text(encoding="utf-8"))
        return frozenset(Path(entry["file"]).stem for entry in head["students"])
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return frozenset()


def editable_as_stated(folder: Path) -> Mapping[str, str] | None:
    """What exam.json says of the files as they were generated; None where it says nothing."""
    try:
        head = json.loads((folder / MARKER).read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return None
    stated = head.get("editable") if isinstance(head, dict) else None
    return stated if isinstance(stated, dict) else None


def answered(sheet: Path) -> bool:
    """Whether answers were typed into an answer sheet, or it cannot be read any more."""
    if not sheet.exists():
        return False
    try:
        table = read_table(sheet)
    except TableError:
        return True
    own = {place for place, name in enumerate(table.header) if header_key(name) in OWN_COLUMNS}
    return any(
        trimmed(cell)
        for row in table.rows
        for place, cell in enumerate(row.cells)
        if place not in own
    )
