"""The files of an exam folder that come from a press: papers, worked solutions, keys, and LaTeX
sources.

`kinegrade.exam.generating.exam_files` writes them one student at a time, as printed papers come
from processes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from pathlib import Path

from kinegrade.exam.folder.contents import PAPERS, SOLUTIONS, SOURCES
from kinegrade.exam.printing.printing import Extras, Printed
from kinegrade.press.join import open_volume
from kinegrade.press.protocol import Printout


@contextmanager
def printed_files(folder: Path, extras: Extras) -> Iterator[Callable[[str, Printed], None]]:
    """A function that writes each paper and its worked solutions, as far as they are wanted, under
    its file name; at the end, all of them are in one file too, behind those that it holds already.
    """
    with ExitStack() as books:
        volumes = {
            name: books.enter_context(open_volume(folder / f"{name}.pdf", duplex=True))
            for name in extras.folders
        }
        for name, append in volumes.items():
            (folder / name).mkdir(exist_ok=True)
            book = folder / f"{name}.pdf"
            if book.exists():
                append(book.read_bytes())

        def write(file_name: str, printed: Printed) -> None:
            for name, content in collect_files(file_name, printed).items():
                _write_content(folder / name, content)
            for name, printout in _collect_printouts(printed).items():
                volumes[name](printout.pdf)

        yield write


def collect_files(file_name: str, printed: Printed) -> dict[str, bytes]:
    """The files of a paper by their path below the exam folder."""
    files = {f"{PAPERS}/{file_name}.{kind}": content for kind, content in printed.also.items()}
    for place, printout in _collect_printouts(printed).items():
        files[f"{place}/{file_name}.pdf"] = printout.pdf
        for name, content in printout.sources.items():
            files[f"{SOURCES}/{place}/{name}"] = content
    return files


def read_printouts(
    file_name: str, files: Mapping[str, bytes]
) -> tuple[Printout | None, Printout | None, dict[str, bytes]]:
    """The paper, its worked solutions and the other kinds of files that `collect_files` has put
    together.
    """
    printouts = {
        place: Printout(files[f"{place}/{file_name}.pdf"], _read_sources(place, files))
        for place in (PAPERS, SOLUTIONS)
        if f"{place}/{file_name}.pdf" in files
    }
    also = {
        name.removeprefix(f"{PAPERS}/{file_name}."): content
        for name, content in files.items()
        if name.startswith(f"{PAPERS}/") and not name.endswith(".pdf")
    }
    return printouts.get(PAPERS), printouts.get(SOLUTIONS), also


def _read_sources(place: str, files: Mapping[str, bytes]) -> dict[str, bytes]:
    """The sources of the printout in a folder, by their names."""
    beginning = f"{SOURCES}/{place}/"
    return {
        name.removeprefix(beginning): content
        for name, content in files.items()
        if name.startswith(beginning)
    }


def replace_papers(
    folder: Path, printed: Iterable[tuple[str, Printed]], file_names: Iterable[str]
) -> None:
    """Write papers over those of the same file names, and all in one file anew, in that order."""
    papers = folder / PAPERS
    for name, each in printed:
        for printout in filter(None, [each.paper]):
            _write(papers / f"{name}.pdf", printout, folder / SOURCES / PAPERS)
    with open_volume(folder / f"{PAPERS}.pdf", duplex=True) as append:
        for name in file_names:
            append((papers / f"{name}.pdf").read_bytes())


def write_solutions(
    folder: Path, printed: Iterable[tuple[str, Printout]], file_names: Iterable[str]
) -> None:
    """Write worked solutions under their file names; all that the folder has then stand in one file
    too, in the order of `file_names`.
    """
    solutions = folder / SOLUTIONS
    solutions.mkdir(exist_ok=True)
    for name, each in printed:
        _write(solutions / f"{name}.pdf", each, folder / SOURCES / SOLUTIONS)
    files = (solutions / f"{name}.pdf" for name in file_names)
    with open_volume(folder / f"{SOLUTIONS}.pdf", duplex=True) as append:
        for file in filter(Path.is_file, files):
            append(file.read_bytes())


def write_key(file: Path, key: Printout) -> None:
    """A book of the instructor's key."""
    _write(file, key, file.parent / SOURCES)


def _collect_printouts(printed: Printed) -> Mapping[str, Printout]:
    """The printouts by the folder where they lie."""
    printouts = {PAPERS: printed.paper, SOLUTIONS: printed.solution}
    return {name: each for name, each in printouts.items() if each is not None}


def _write(target: Path, printout: Printout, sources: Path) -> None:
    _write_content(target, printout.pdf)
    for name, content in printout.sources.items():
        _write_content(sources / name, content)


def _write_content(target: Path, content: bytes) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_bytes(content)
