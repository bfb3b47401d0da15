"""Marks folders put together: everything behind `kinegrade merge`."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from kinegrade.errors import TableError
from kinegrade.files.output import output_folder
from kinegrade.files.placing.edits import find_edits
from kinegrade.language.message import Message
from kinegrade.lms.grades import moodle
from kinegrade.marks_folder.folder import MarksFolder, open_marks
from kinegrade.marks_folder.layout import FILES, MARKER
from kinegrade.marks_folder.merging import Merging, Preference
from kinegrade.public.outcome import Outcome
from kinegrade.reports.term.naming import require_different
from kinegrade.reports.term.split_students import find_renamed_students
from kinegrade.reports.unlike_names import find_unlike_names
from kinegrade.reports.unlike_questions import find_unlike_questions


def merge_marks(
    folders: Sequence[MarksFolder],
    output: Path,
    preference: Preference | None,
    *,
    force: bool = False,
) -> Outcome:
    """Writes the folder `output`, whole or not at all, with the marks of all folders.

    Raises TableError for a folder that is given twice, for students who handed in to several,
    unless there is a preference, and for those who would stand twice as their id has changed,
    OutputError.
    """
    require_different([each.path for each in folders])
    merging = Merging(folders, preference)
    totals = {str(each.path): each.totals for each in folders}
    former_ids = {str(each.path): each.former_ids for each in folders}
    renamed = tuple(find_renamed_students(totals, former_ids))
    if renamed:
        raise TableError(*renamed)
    unlike = *find_unlike_questions(folders), *find_unlike_names(totals)
    complaints = (*merging.find_different_maxima(), *unlike)
    contents, edits = (*FILES, moodle.FILE), find_edits(output, marker=MARKER)
    with output_folder(output, marker=MARKER, contents=contents, force=force) as path:
        merging.write(path)
        (path / moodle.FILE).write_text(
            moodle.export(open_marks(path)), encoding="utf-8", newline=""
        )
        edits.settle(path)
    first, *_ = folders
    note = Message(
        "terminal.merged",
        folder=str(output),
        count=len(merging.chosen),
        others=sum(each is not first for each in merging.chosen.values()),
    )
    scaled = moodle.describe_scaled(output, merging.maxima())
    return Outcome(output, (note, *scaled, *edits.describe()), complaints)
