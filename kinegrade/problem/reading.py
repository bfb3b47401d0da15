"""From the TOML text of a template to a Template; every fault of the file is reported at once.

TOML is pure data and is read by the standard library; expressions are read by our own grammar. So a
template from a stranger is safe to open.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from itertools import combinations
from typing import Any, TypeVar

from kinegrade.errors import (
    ExpressionError,
    KinegradeError,
    TemplateError,
    did_you_mean,
    misspelt,
    short_line,
)
from kinegrade.expression import Expression, read
from kinegrade.language import LANGUAGES
from kinegrade.mechanics.geometry import BRANCHES
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.mechanism import Body
from kinegrade.problem.conditions import read_condition
from kinegrade.problem.consistency import inconsistencies
from kinegrade.problem.domain import read_choices
from kinegrade.problem.hints import FigureHints, read_hints
from kinegrade.problem.notation import symbol
from kinegrade.problem.sentences import DriverSentence, JointSentence, read_driver, read_joint
from kinegrade.problem.shared_mechanism import (
    FILE_NAME,
    FOLDER,
    KINDS,
    Layers,
    mechanism_faults,
    mechanism_name,
    sharable,
)
from kinegrade.problem.signs import read_sign
from kinegrade.problem.template import (
    About,
    Ask,
    Condition,
    MechanismFile,
    Parameter,
    Published,
    Scheme,
    Template,
    TemplateFile,
    Translated,
    Words,
)
from kinegrade.problem.template_choices import read_method, read_tags
from kinegrade.problem.toml_text import KNOWN, NEEDED, toml_tables
from kinegrade.problem.uses import Uses
from kinegrade.problem.wordings import read_texts
from kinegrade.units import read_unit

KIND_NAMES: Mapping[type, str] = {dict: "table", list: "list", str: "text"}
RESERVED = frozenset({"pi", GROUND, *BRANCHES})
TAKEN = ", ".join(sorted(RESERVED))
NAMING = f"not usable as a name: a letter, then letters, digits and _ ; not {TAKEN}"
IDENTIFIER = re.compile(r"[A-Za-z]\w{0,30}", re.ASCII)
Part = TypeVar("Part")
# The text of the mechanism of that name; raises TemplateError when there is none.
Mechanisms = Callable[[str], str]


def no_mechanisms(name: str) -> str:
    """Refuses every mechanism: a text alone has no folder beside it."""
    raise TemplateError(f'no folder to look for "{name}" in: load the template from its file')


def read_template(
    name: str, text: str, mechanisms: Mechanisms = no_mechanisms, *, kept: bool = False
) -> Template:
    """The template of that name. Raises TemplateError with all faults, each with its place.

    `name` is the file's name without `.toml`: letters, digits and hyphens. `mechanisms` gives the
    text of the mechanism that the template shares with others. A template that is `kept` with an
    exam is read without a look at dimensions, so that no later rule closes an exam's folder.
    """
    reader = Reader(name, text, mechanisms)
    template = reader.template()
    faults = [] if kept else inconsistencies(template)
    for path, problem in faults:
        reader.fault(path, problem)
    if reader.faults:
        raise TemplateError(*reader.faults)
    return template


class Reader:
    """Reads one file, collecting faults; each method reads one table."""

    def __init__(self, name: str, text: str, mechanisms: Mechanisms) -> None:
        self.name, self.text, self.where = name, text, f"{name}.toml"
        self.faults: list[str] = []
        self.mechanism: MechanismFile | None = None
        self.layers = Layers(self.where, self.load())
        if "mechanism" in self.layers.own:
            self.share(mechanisms)
        self.table = self.layers.tables()

    def load(self) -> dict[str, Any]:
        """The file's own TOML tables; a file that is no TOML ends here."""
        if not FILE_NAME.fullmatch(self.name):
            raise TemplateError(
                f"{self.where}: a template's name is made of small letters, digits and hyphens"
            )
        table = toml_tables(self.where, self.text)
        self.faults += [
            f"{self.where}: unknown table or key {key!r}: {did_you_mean(key, KNOWN)}"
            for key in table
            if key not in KNOWN
        ]
        self.need(table, [key for key in NEEDED if "mechanism" not in table or key not in KINDS])
        return table

    def need(self, table: Mapping[str, Any], keys: Iterable[str]) -> None:
        """A fault for every missing key; without the tables of names reading ends."""
        missing = [key for key in keys if key not in table]
        self.faults += [
            f"{self.where}: {key} is missing: every template needs it"
            for key in missing
            if key not in misspelt(set(table) - set(KNOWN), missing)
        ]
        if not {"parameters", "points", "bodies"}.isdisjoint(missing):
            raise TemplateError(*self.faults)

    def share(self, mechanisms: Mechanisms) -> None:
        """Lay the tables over those of the mechanism; one that cannot be read ends here."""
        name = self.layers.own["mechanism"]
        text = self.part("mechanism", lambda: mechanisms(mechanism_name(name)))
        if text is None:
            raise TemplateError(*self.faults)
        file = f"{FOLDER}/{name}.toml"
        try:
            tables = toml_tables(file, text)
        except TemplateError as error:
            raise TemplateError(*self.faults, *error.problems) from error
        self.faults += mechanism_faults(file, tables)
        self.mechanism = MechanismFile(name, text)
        self.layers = Layers(self.where, self.layers.own, file, sharable(tables))
        self.need(self.layers.tables(), [key for key in NEEDED if key in KINDS])

    def fault(self, path: str, problem: str) -> None:
        """Note a fault at a path of the tables."""
        file, place = self.layers.standing(path)
        self.faults.append(f"{file}: {short_line(place)}: {short_line(problem)}")

    def part(self, path: str, make: Callable[..., Part], *arguments: Any) -> Part | None:
        """What `make` gives of its arguments; its refusal becomes a fault at `path`."""
        try:
            return make(*arguments)
        except KinegradeError as error:
            for problem in error.problems:
                self.fault(path, problem)
        return None

    def section(self, key: str, kind: type[Part]) -> Part:
        """The table or list under `key`, empty if it is missing or of another kind."""
        value = self.table.get(key, kind())
        if not isinstance(value, kind):
            self.fault(key, f"expected a {KIND_NAMES[kind]}")
            return kind()
        return value

    def template(self) -> Template:
        """All parts put together; raises TemplateError when any has a fault."""
        parameters = self.parameters()
        lengths = self.expressions("lengths")
        points = self.expressions("points")
        bodies = self.bodies(points)
        self.check_names(parameters, lengths, points, bodies)
        result = Template(
            name=self.name,
            file=TemplateFile(self.text, self.mechanism),
            about=About(
                self.translated(self.table, "title"),
                self.section("family", str),
                self.section("source", str),
                read_tags(self.section("tags", list), self.fault),
                read_method(self.table.get("method"), self.fault),
            ),
            words=Words(
                self.translated(self.table, "statement"),
                read_texts(self.section("text", dict), self.fault),
            ),
            scheme=Scheme(
                parameters,
                lengths,
                points,
                bodies,
                self.joints(),
                self.drivers(),
                self.conditions(),
            ),
            asks=self.asks(),
            published=self.published(parameters),
            figure=self.hints(points, bodies),
        )
        Uses(self.fault, self.declared - self.understood(result)).check(result)
        return result

    @property
    def declared(self) -> frozenset[str]:
        """The names that the tables declare, by something that can be read or not."""
        tables = (self.table.get(key) for key in ("parameters", "lengths", "points", "asks"))
        return frozenset(name for table in tables if isinstance(table, dict) for name in table)

    def understood(self, template: Template) -> frozenset[str]:
        """The names of the parts that could be read."""
        return frozenset(
            (
                *template.parameters,
                *template.scheme.lengths,
                *template.scheme.points,
                *template.asks,
            )
        )

    def translated(self, table: Mapping[str, Any], key: str, path: str = "") -> Translated:
        """A text in en and zh."""
        value = table.get(key)
        if (
            not isinstance(value, dict)
            or set(value) != set(LANGUAGES)
            or not all(isinstance(text, str) and text.strip() for text in value.values())
        ):
            if key in table or path:
                self.fault(
                    path or key,
                    f'{key}: expected texts in both languages: {{ en = "...", zh = "..." }}',
                )
            return Translated("", "")
        return Translated(value["en"].strip(), value["zh"].strip())

    def parameters(self) -> dict[str, Parameter]:
        """The givens."""
        found, keys = {}, {"unit", "draw", "published", "means", "symbol"}
        for name, entry in self.section("parameters", dict).items():
            path = f"parameters.{name}"
            if not self.is_table(path, entry, keys, {"unit", "draw"}):
                continue
            unit = self.part(path, read_unit, str(entry["unit"]))
            choices = self.part(path, read_choices, entry["draw"])
            published = str(entry["published"]) if "published" in entry else None
            if published is not None:
                self.part(path, read, published)
            if unit is not None and choices is not None:
                means = self.translated(entry, "means", path)
                found[name] = Parameter(
                    name, str(entry.get("symbol", symbol(name))), unit, choices, published, means
                )
        return found

    def is_table(self, path: str, entry: Any, known: set[str], needed: set[str]) -> bool:
        """Whether an entry is a table with the keys it needs and no others."""
        if not isinstance(entry, dict):
            self.fault(path, f"expected a table with {', '.join(sorted(needed))}")
            return False
        unknown, missing = sorted(set(entry) - known), sorted(needed - set(entry))
        for key in unknown:
            self.fault(path, f'unknown key "{key}": {did_you_mean(key, known)}')
        for key in missing:
            if key not in misspelt(unknown, missing):
                self.fault(path, f"{key} is missing")
        return not missing

    def expressions(self, key: str) -> dict[str, Expression]:
        """Named expressions, in order."""
        found = {}
        for name, text in self.section(key, dict).items():
            tree = self.part(f"{key}.{name}", read, str(text))
            if tree is not None:
                found[name] = tree
        return found

    def bodies(self, points: Mapping[str, Any]) -> tuple[Body, ...]:
        """Bodies with their marked points: "O A", or "particle M"."""
        found = []
        for name, value in self.section("bodies", dict).items():
            path, words = f"bodies.{name}", str(value).split()
            particle = words[:1] == ["particle"]
            marked = tuple(words[1:] if particle else words)
            for point in marked:
                if point not in points and point not in self.declared:
                    self.fault(path, f'no point "{point}": {did_you_mean(point, points)}')
            if not marked or (particle and len(marked) != 1):
                self.fault(f"bodies.{name}", 'expected its points, like "O A", or "particle M"')
            found.append(Body(name, marked, particle))
        return tuple(found)

    def check_names(self, *groups: Any) -> None:
        """Names are plain and mean one thing; only a body may be named after its point."""
        parameters, lengths, points, bodies = groups
        for name in [*parameters, *lengths, *points, *(body.name for body in bodies)]:
            if not IDENTIFIER.fullmatch(name) or name in RESERVED:
                self.fault(name, NAMING)
        groups_of_names = (
            (parameters, lengths, points),
            (parameters, lengths, {body.name for body in bodies}),
        )
        twice = {
            name
            for group in groups_of_names
            for first, second in combinations(group, 2)
            for name in set(first) & set(second)
        }
        for name in sorted(twice):
            self.fault(name, "one name for two things: rename one of them")

    def joints(self) -> tuple[JointSentence, ...]:
        """The joint sentences."""
        return self.sentences("joints", read_joint)

    def sentences(self, key: str, make: Callable[[str], Part]) -> tuple[Part, ...]:
        """What `make` gives of each sentence of a list."""
        parts = [
            self.part(f"{key}[{index}]", make, str(text))
            for index, text in enumerate(self.section(key, list))
        ]
        return tuple(part for part in parts if part is not None)

    def drivers(self) -> tuple[DriverSentence, ...]:
        """The inputs."""
        found, keys = [], {"motion", "velocity", "acceleration"}
        for index, entry in enumerate(self.section("inputs", list)):
            path = f"inputs[{index}]"
            if self.is_table(path, entry, keys, {"motion", "velocity"}):
                sentence = self.part(
                    path,
                    read_driver,
                    str(entry["motion"]),
                    str(entry["velocity"]),
                    str(entry.get("acceleration", "0")),
                )
                found += [sentence] if sentence is not None else []
        return tuple(found)

    def conditions(self) -> tuple[Condition, ...]:
        """Relations such as "left < right"."""
        return self.sentences("conditions", read_condition)

    def asks(self) -> dict[str, Ask]:
        """The quantities that may be asked for."""
        found = {}
        keys = {"quantity", "unit", "means", "sign", "points", "vanishes", "cyclic", "symbol"}
        for name, entry in self.section("asks", dict).items():
            path = f"asks.{name}"
            if not IDENTIFIER.fullmatch(name):
                self.fault(path, NAMING)
            elif self.is_table(path, entry, keys, {"quantity", "unit"}):
                ask = self.part(path, self.ask, name, entry)
                found.update({name: ask} if ask is not None else {})
        return found

    def ask(self, name: str, entry: Mapping[str, Any]) -> Ask:
        """One ask."""
        points = entry.get("points", 0)
        if not isinstance(points, int) or isinstance(points, bool) or not 0 <= points <= 100:
            raise ExpressionError("points: expected a whole number from 0 to 100")
        for flag in ("vanishes", "cyclic"):
            if not isinstance(entry.get(flag, False), bool):
                raise ExpressionError(f"{flag}: expected true or false")
        english, chinese = read_sign(entry.get("sign", "magnitude"))
        return Ask(
            name,
            str(entry.get("symbol", symbol(name))),
            read(str(entry["quantity"])),
            read_unit(str(entry["unit"])),
            self.translated(entry, "means", f"asks.{name}"),
            Translated(english, chinese),
            points,
            entry.get("vanishes") is True,
            entry.get("cyclic") is True,
        )

    def published(self, parameters: Mapping[str, Parameter]) -> tuple[Published, ...]:
        """Published results with the values they hold for."""
        found = []
        for index, entry in enumerate(self.section("published", list)):
            path = f"published[{index}]"
            if not self.is_table(path, entry, {"source", "given", "gives"}, {"source", "gives"}):
                continue
            if not isinstance(entry.get("given", {}), dict) or not isinstance(entry["gives"], dict):
                self.fault(path, 'given and gives: expected tables, like { v_B = "2*omega*r" }')
                continue
            given = {key: str(value) for key, value in entry.get("given", {}).items()}
            for key in given:
                if key not in parameters and key not in self.declared:
                    self.fault(
                        path, f'given: no parameter "{key}": {did_you_mean(key, parameters)}'
                    )
            texts = {key: str(value) for key, value in entry["gives"].items()}
            trees = {
                key: self.part(f"{path}.gives.{key}", read, value) for key, value in texts.items()
            }
            known = {key: tree for key, tree in trees.items() if tree is not None}
            found.append(Published(str(entry["source"]), given, known, texts))
        return tuple(found)

    def hints(self, points: Mapping[str, Any], bodies: tuple[Body, ...]) -> FigureHints:
        """The figure's marks."""
        try:
            return read_hints(
                self.section("figure", dict), self.name, set(points), {body.name for body in bodies}
            )
        except TemplateError as error:
            for problem in error.problems:
                self.figure_fault(problem)
            return FigureHints()

    def figure_fault(self, problem: str) -> None:
        """A fault of the figure, by its first words: template, table and key."""
        key = re.match(r"[\w-]+: (figure\.\w+)", problem)
        file, _ = self.layers.standing(key[1] if key else "figure")
        self.faults.append(f"{file}: figure: {short_line(problem)}")
