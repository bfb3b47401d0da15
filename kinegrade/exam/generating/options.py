"""How an exam is generated, as an instructor asks for it: the options of `kinegrade generate`."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from kinegrade.errors import OptionError
from kinegrade.exam.bank.blueprint import Bank
from kinegrade.exam.folder.contents import FOR_STUDENTS
from kinegrade.exam.folder.exam_secret import SecretWish
from kinegrade.exam.printing.printing import Extras, PressOrder, Printed
from kinegrade.files.output import Access
from kinegrade.language.message import Fault, Message, list_plainly
from kinegrade.press.protocol import Engine
from kinegrade.press.sheet import PaperSize
from kinegrade.problem.template.template import Method

PRIVATE = Access(0o700, 0o600, FOR_STUDENTS)
SHARED_WITH_GROUP = Access(0o750, 0o640, FOR_STUDENTS)
Progress = Callable[[Iterator[Printed], int], Iterator[Printed]]


def _as_they_come(papers: Iterator[Printed], count: int) -> Iterator[Printed]:
    return papers


@dataclass(frozen=True)
class GenerateOptions:
    """How an exam is generated.

    Its numbers are drawn from a random secret into which `seed`, a label, is mixed, or from the
    words of `reproducible` alone; with `new_numbers`, a folder that is replaced does not keep its
    numbers, and with `accept_changes` its papers keep these and may be set otherwise in all else.
    Nobody gets numbers that anybody had in the exams whose folders are to `avoid`, nor those of
    the other `sheets` of a series, nor what these avoid.
    `share_with_group` lets the user's group read the folder. `engine` is the bank's unless one is
    given. With `no_papers` none is printed before it is asked for. `solutions` writes worked
    solutions, by `method` where several serve and with graphs over the `cycle`; `spare` papers have
    no student; `also` names the other kinds of files in which papers are wanted. What would be a
    complaint is refused where `strict`. With `resume` a run goes on with what an interrupted one
    left, and leaves what it has done where it is interrupted itself. Papers are printed by up to
    `jobs` processes, or by the workers of the `cluster` whose scheduler has that address;
    `progress` is given them one after another, and their number.
    """

    seed: str | None = None
    reproducible: str | None = None
    new_numbers: bool = False
    accept_changes: bool = False
    avoid: tuple[Path, ...] = ()
    sheets: tuple[Path, ...] = ()
    share_with_group: bool = False
    paper_size: PaperSize = "a4"
    engine: Engine | None = None
    no_papers: bool = False
    solutions: bool = False
    method: Method | None = None
    cycle: bool = False
    spare: int = 0
    also: tuple[str, ...] = ()
    strict: bool = False
    resume: bool = False
    jobs: int = 1
    cluster: str | None = None
    progress: Progress = _as_they_come

    @property
    def processes(self) -> int:
        """How many processes of this machine work."""
        return 1 if self.cluster else self.jobs

    @property
    def wish(self) -> SecretWish:
        """What the numbers are drawn from."""
        return SecretWish(self.seed, self.reproducible, self.new_numbers)

    @property
    def access(self) -> Access:
        """Who may read the exam folder."""
        return SHARED_WITH_GROUP if self.share_with_group else PRIVATE

    @property
    def extras(self) -> Extras:
        """What is printed. Raises OptionError where papers are wanted and are not."""
        also = tuple(dict.fromkeys(self.also))
        if self.no_papers and also:
            raise OptionError(
                Fault(
                    "--no-papers",
                    Message("exam.no-kinds-of-none", kinds=list_plainly(also)),
                    Message("exam.papers-on-demand"),
                    Message("exam.without-also"),
                )
            )
        return Extras(self.solutions, self.method, self.cycle, also, papers=not self.no_papers)

    def press_order(self, bank: Bank) -> PressOrder:
        """The press for an exam."""
        return PressOrder(self.engine or bank.engine, self.paper_size)
