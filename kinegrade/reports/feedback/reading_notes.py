"""The note that was made on reading an answer, in the language of its sheet: marks hold it in that
of the exam.
"""

from __future__ import annotations

from kinegrade.grading.typed.answers import read
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import known_languages
from kinegrade.language.message import Message, Text
from kinegrade.marks_folder.rows import MarkedAnswer


def find_note(answer: MarkedAnswer) -> Text:
    """The note, which is known again by reading the answer anew; as it stands in the marks where it
    says anything else, such as what only the whole file shows.
    """
    reason = read(answer.typed, answer.unit).reason
    for note in (reason, Message("marking.bare-number", reason=reason)):
        written = (open_catalogue(language).write(note) for language in known_languages())
        if answer.reason in written:
            return note
    return answer.reason
