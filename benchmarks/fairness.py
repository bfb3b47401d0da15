"""Whether marks are fair: students are simulated by the thousand, and marked by the real marking.

    python -m benchmarks.fairness [--draws N] [template ...]

For every template N papers are drawn as for an exam (1,000 unless said otherwise). Promised is

1. full marks in every ask for an honest student who carries four significant figures, every
   operation rounded or off by anything that rounding can leave, whether four figures are typed in,
   five, or the calculator's whole display;
2. full marks in no ask for a student who makes a known mistake, except where the template reports
   it as inseparable;
3. that the marks name the mistake which was made in at least 99 % of these answers, alone or among
   those that lead there too. A mistake that leads to the same number within what is typed in (four
   figures) is as good a name: answers for which only such a one is named are counted apart.

`students` simulates, `fairness` counts. Measured without a promise: mistaken students who carry
three figures.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass, field

from benchmarks.simulated_class import Answer, SimulatedClass, answered, classes
from benchmarks.students import honest_students, mistaken_students
from kinegrade.grading.marks import Mark
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.stated_marking import find_identifier

DRAWS = 1000
DIAGNOSED = 0.99
SHOWN = 5  # broken promises told of each template


@dataclass
class Fairness:
    """What was counted for one template.

    `honest` has for each way of working how many answers were given and how many got
    full marks, `mistakes` counts answers with a known mistake by what the marks made of them,
    `inseparable` those that nothing is promised of. `broken` are examples of promises not kept,
    `confused` of mistakes named instead of others.
    """

    template: str
    instances: int = 0
    honest: dict[str, Counter[str]] = field(default_factory=dict)
    mistakes: Counter[str] = field(default_factory=Counter)
    inseparable: Counter[str] = field(default_factory=Counter)
    rounded: Counter[str] = field(default_factory=Counter)
    confused: Counter[tuple[str, str]] = field(default_factory=Counter)
    broken: list[str] = field(default_factory=list)

    def full(self) -> bool:
        """Whether honest work got full marks everywhere."""
        return all(count["full"] == count["given"] for count in self.honest.values())

    def none(self) -> bool:
        """Whether no separable mistake got full marks."""
        return not self.mistakes["full"]

    def diagnosed(self) -> float:
        """The share of answers with a separable mistake that the marks name rightly."""
        given = self.mistakes["given"]
        return (self.mistakes["named"] + self.mistakes["alike"]) / given if given else 1.0

    def kept(self) -> bool:
        """Whether all three promises are kept."""
        return self.full() and self.none() and self.diagnosed() >= DIAGNOSED

    def add(self, other: Fairness) -> None:
        """Count the students of another class or template too."""
        self.instances += other.instances
        for way, count in other.honest.items():
            self.honest.setdefault(way, Counter()).update(count)
        for name in ("mistakes", "inseparable", "rounded", "confused"):
            getattr(self, name).update(getattr(other, name))
        self.broken += other.broken[: SHOWN - len(self.broken)]


def fairness(name: str, draws: int, *, measured: bool = True) -> Fairness:
    """Everything counted for one template; what is only measured, and promised of nobody, where
    `measured` is true.
    """
    found = Fairness(name)
    for simulated in classes(load_template(name), draws):
        found.add(count_class(simulated, measured=measured))
    return found


def count_class(simulated: SimulatedClass, *, measured: bool) -> Fairness:
    """Everything counted for one class."""
    found = Fairness(simulated.template.name, len(simulated.papers))
    for way, answers in honest_students(simulated):
        count_honest(
            found,
            found.honest.setdefault(way, Counter()),
            way,
            simulated,
            answers,
        )
    for answers in mistaken_students(simulated, rounded=False):
        count_mistaken(found, simulated, answers)
    if measured:
        measure(found, simulated)
    return found


def measure(found: Fairness, simulated: SimulatedClass) -> None:
    """Students of whom nothing is promised."""
    for answers in mistaken_students(simulated, rounded=True):
        count_rounded(found, simulated, answers)


def count_honest(
    found: Fairness,
    count: Counter[str],
    way: str,
    simulated: SimulatedClass,
    answers: Sequence[Mapping[str, Answer]],
) -> None:
    """Mark a class that works rightly; what is not answered gets no full marks."""
    for place, mark in simulated.marked(answers):
        full = mark.points == mark.ask.points
        count["given"] += 1
        count["full"] += full
        if not full and len(found.broken) < SHOWN:
            found.broken.append(f"honest, {way}: {told(simulated, place, mark)}")


def count_mistaken(
    found: Fairness, simulated: SimulatedClass, answers: Sequence[Mapping[str, Answer]]
) -> None:
    """Mark a class that makes a known mistake."""
    for place, mark, answer in answered(simulated, answers):
        count = (
            found.inseparable
            if answer.mistake in simulated.inseparable.get(mark.ask.ask, ())
            else found.mistakes
        )
        outcome = made_of(simulated, place, mark, answer)
        count["given"] += 1
        count[outcome] += 1
        if count is found.mistakes and outcome == "confused":
            found.confused[answer.mistake, simulated.named(mark)[0]] += 1
        if (
            count is found.mistakes
            and outcome not in ("named", "alike")
            and len(found.broken) < SHOWN
        ):
            found.broken.append(f"{answer.mistake}, {outcome}: {told(simulated, place, mark)}")


def count_rounded(
    found: Fairness, simulated: SimulatedClass, answers: Sequence[Mapping[str, Answer]]
) -> None:
    """Mark a class that makes a known mistake and carries three figures."""
    for place, mark, answer in answered(simulated, answers):
        if answer.mistake not in simulated.inseparable.get(mark.ask.ask, ()):
            found.rounded["given"] += 1
            found.rounded[made_of(simulated, place, mark, answer)] += 1


def made_of(simulated: SimulatedClass, place: int, mark: Mark, answer: Answer) -> str:
    """What the marks make of an answer with a known mistake."""
    if mark.points == mark.ask.points:
        return "full"
    names = simulated.named(mark)
    if not names:
        return "unnamed"
    if find_identifier(answer.mistake) in names:
        return "named"
    return "alike" if simulated.alike(place, mark.ask.ask, names[0], answer) else "confused"


def told(simulated: SimulatedClass, place: int, mark: Mark) -> str:
    """An answer with its instance and verdict, for whoever looks for the cause."""
    values = ", ".join(
        f"{name} = {text}"
        for name, text in simulated.papers[place].questions[0].drawn.values.items()
    )
    return (
        f'{simulated.template.name} at {values}: {mark.ask.ask} "{mark.reading.typed}" '
        f"{mark.verdict.kind}: {mark.verdict.reason}"
    )


HEADER = (
    f"{'template':<42}{'papers':>7}{'honest':>9}{'full':>9}{'mistaken':>10}{'full':>6}{'named':>9}{'alike':>7}"
    f"{'other':>6}{'none':>6}{'insep.':>8}"
)


def row(name: str, found: Fairness) -> str:
    """One line of the table."""
    given, full = (
        sum(count[kind] for count in found.honest.values()) for kind in ("given", "full")
    )
    made = found.mistakes
    return (
        f"{name:<42}{found.instances:>7}{given:>9}{full:>9}{made['given']:>10}{made['full']:>6}{made['named']:>9}"
        f"{made['alike']:>7}{made['confused']:>6}{made['unnamed']:>6}{found.inseparable['given']:>8}"
    )


def summary(total: Fairness) -> Iterator[str]:
    """What the totals say of each promise, and what is measured beside them."""
    for way, count in sorted(total.honest.items()):
        yield (
            f"{'promised':<10}{way:<60}{count['full']:>9} of {count['given']:>9} answers got full "
            f"marks, {share(count, 'full'):.4%}"
        )
    made, rounded = total.mistakes, total.rounded
    yield f"{'promised':<10}known mistakes that got full marks: {made['full']} of {made['given']}"
    yield (
        f"{'promised':<10}known mistakes named rightly: {total.diagnosed():.4%} "
        f"({share(made, 'named'):.2%} by name, {share(made, 'alike'):.2%} by one that leads to the "
        "same number)"
    )
    yield (
        f"{'measured':<10}answers with inseparable mistakes: {total.inseparable['given']}, "
        f"of which {total.inseparable['full']} got full marks"
    )
    yield (
        f"{'measured':<10}mistaken and carrying three figures: {rounded['full']} of "
        f"{rounded['given']} got full "
        f"marks, {share(rounded, 'named') + share(rounded, 'alike'):.2%} are named rightly, "
        f"{share(rounded, 'unnamed'):.2%} not at all"
    )
    for (mistake, name), times in total.confused.most_common(SHOWN):
        yield f"{'':<10}{mistake} was named {name} {times} times"


def share(count: Counter[str], kind: str) -> float:
    """The share of the answers given."""
    return count[kind] / count["given"] if count["given"] else 0.0


def main() -> int:
    """Print the table and the totals; 1 when a promise is broken for a template."""
    parser = argparse.ArgumentParser(
        description="Simulate students who work rightly, and who make known mistakes."
    )
    parser.add_argument("--draws", type=int, default=DRAWS, help="papers drawn of each template")
    parser.add_argument("templates", nargs="*", help="only these templates")
    options = parser.parse_args()
    total, kept = Fairness("all"), True
    print(HEADER, flush=True)
    with ProcessPoolExecutor() as pool:
        tasks = [
            pool.submit(fairness, name, options.draws)
            for name in options.templates or find_template_names()
        ]
        for task in as_completed(tasks):
            found = task.result()
            total.add(found)
            kept &= found.kept()
            print(
                row(found.template, found),
                *(f"  BROKEN {line}" for line in found.broken if not found.kept()),
                sep="\n",
                flush=True,
            )
    print(row("all", total), "", *summary(total), "", "kept" if kept else "BROKEN", sep="\n")
    return 0 if kept else 1


if __name__ == "__main__":
    sys.exit(main())
