"""An exam folder that grows: what stands in it is copied, what is new is added to the copy, and the
copy takes the folder's place whole.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path, PurePosixPath

from kinegrade.exam.folder.contents import CONTENTS, HEAD
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.head import read_head
from kinegrade.exam.generating.hand_work import digest_editable
from kinegrade.exam.generating.options import PRIVATE, SHARED_WITH_GROUP
from kinegrade.files.output import Access, output_folder
from kinegrade.files.placing.copying import copy_tree
from kinegrade.files.placing.standing import refuse_changed

_GROUP_READS = 0o040


@contextmanager
def open_grown_folder(exam: ExamFolder) -> Iterator[Path]:
    """A hidden folder that takes the place of the exam at the end; the same people may read it.

    Raises OutputError, also where the exam is no longer the one that was opened.
    """
    shared = exam.path.stat().st_mode & _GROUP_READS
    access: Access = SHARED_WITH_GROUP if shared else PRIVATE
    place = exam.path
    with output_folder(place, marker=HEAD, contents=CONTENTS, force=True, access=access) as folder:
        if read_head(place) != exam.head:  # of whoever came between
            raise refuse_changed(place)
        yield folder


def copy_exam(exam: ExamFolder, folder: Path) -> None:
    """All that stands in the exam folder."""
    copy_tree(exam.path, folder)


def digest_grown(exam: ExamFolder, folder: Path) -> Mapping[str, str] | None:
    """The digests of files as they were generated: of those that stay the old ones, so that it is
    still known which were edited; None where the exam folder does not know it.
    """
    stated = exam.head.editable
    if stated is None:
        return None
    before = digest_editable(exam.path)
    fresh = digest_editable(folder)
    written = {name: digest for name, digest in fresh.items() if before.get(name) != digest}
    renamed = before.keys() - fresh.keys()  # with their paper, or gone with what they translated
    names = sorted({*stated, *written} - renamed, key=PurePosixPath)
    return {name: written.get(name) or stated[name] for name in names}
