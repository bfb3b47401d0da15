"""What stands at the head of a paper beside course, title, date and student: who sets the exam, and
what holds in the room.
"""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.language.catalogue import Catalogue


@dataclass(frozen=True)
class PaperHead:
    """Texts in the paper's language; "" prints nothing.

    `room`, `seat` and `group` are None where they are not asked for, and "" where a line is left to
    write them on; `extra_time` is the student's; `due` is when homework is to be handed in.
    """

    institution: str = ""  # plain, as are duration, room and seat
    logo: str = ""  # an SVG that refers to nothing
    duration: str = ""
    aids: str = ""  # prose, one line
    instructions: str = ""  # prose
    room: str | None = None
    seat: str | None = None
    signature: bool = False
    group: str | None = None
    extra_time: str = ""
    due: str = ""

    def list_times(self, words: Catalogue) -> list[tuple[str, str]]:
        """How long the exam takes, or until when, by its label, as far as it is stated."""
        stated = (
            (words.text("paper.due"), self.due),
            (words.text("paper.duration"), self.duration),
            (words.text("paper.extra-time"), self.extra_time),
        )
        return [(label, text) for label, text in stated if text]

    def list_blanks(self, words: Catalogue) -> list[tuple[str, str]]:
        """What is written by hand, by its label, with the text that stands there already."""
        blanks = {
            "group": self.group,
            "room": self.room,
            "seat": self.seat,
            "signature": "" if self.signature else None,
        }
        return [
            (words.text(f"paper.blank-{name}"), text)
            for name, text in blanks.items()
            if text is not None
        ]


PLAIN_HEAD = PaperHead()
