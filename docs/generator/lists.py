"""Short pages: known mistakes, languages, systems, exit statuses."""

from __future__ import annotations

import signal
from collections.abc import Iterable

import click
from babel import Locale

from docs.generator.commands import read_help
from docs.generator.described import read_constants, read_words
from docs.generator.markdown import write_code, write_page, write_table, write_words
from kinegrade import __main__ as process
from kinegrade.cli import main, options
from kinegrade.cli.running import program
from kinegrade.cli.running.signals import BY_SIGNAL
from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import known_languages
from kinegrade.lms.responses.detection import DIALECTS
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.students.mistaking.mistake_names import describe_mistakes


def write_mistake_page() -> str:
    """The known mistakes by identifier."""
    return write_page(
        "# Known mistakes",
        "The value that each of these leads to is known for every paper. Values are not dealt "
        "where a mistake would pass for right. Banks and policies give credit by the identifier, "
        "which never changes; students read the sentence.",
        write_table(
            ("identifier", "what the student reads"),
            [(write_code(name), text) for name, text in describe_mistakes(ENGLISH).items()],
        ),
    )


def write_refusal_page() -> str:
    """Why combinations of values are refused."""
    words = open_catalogue(ENGLISH)
    reasons = read_words("kinegrade.draws.examining", "Reason")
    return write_page(
        "# Refused draws",
        "`kinegrade generate` and `kinegrade check` count the combinations of values that are not "
        "dealt, by these reasons.",
        write_words(
            "reason",
            {
                words.text(f"template.refused-{reason}"): meaning
                for reason, meaning in reasons.items()
            },
        ),
    )


def write_language_page() -> str:
    """The languages, and how complete the templates are in them."""
    templates = [load_template(name) for name in find_template_names()]
    rows = [
        (
            write_code(language),
            str(Locale.parse(language).english_name),
            f"{sum(each.about.title.has(language) for each in templates)} of {len(templates)}",
        )
        for language in known_languages()
    ]
    return write_page(
        "# Languages",
        "Everything that kinegrade prints or says is available in these languages. `--lang` "
        "chooses that of files, the environment (`LC_ALL`, `LC_MESSAGES`, `LANG`) that of "
        "messages.",
        write_table(("language", "name", "templates"), rows),
    )


def write_format_page() -> str:
    """The systems that answers come from, and that grades and quizzes go to."""
    words = open_catalogue(ENGLISH)
    sources = [(write_code(name), words.write(each.title)) for name, each in DIALECTS.items()]
    return write_page(
        "# Formats of other systems",
        "## Answers",
        "`kinegrade grade --from` takes these, as CSV or xlsx; without it, the source is detected "
        "from the columns.",
        write_table(("source", "file"), sources),
        "## Grades",
        f"`kinegrade export --to`: {_choices('export', 'system')}. " + read_help("export.system"),
        "## Quizzes",
        f"`kinegrade quiz --to`: {_choices('quiz', 'system')}. {read_help('quiz.system')}",
        "## Papers and sheets",
        f"`kinegrade generate --engine`: {_choices('generate', 'engine')}; PDF, and with `--also` "
        f"{_choices('generate', 'also')} too. `kinegrade feedback --format`: "
        f"{_choices('feedback', 'form')}.",
    )


def write_status_page() -> str:
    """The exit statuses."""
    described = {
        getattr(module, name): meaning
        for module in (options, program, process)
        for name, meaning in read_constants(module.__name__).items()
    }
    ended = {BY_SIGNAL + signal.SIGTERM: "Ended from outside, by SIGTERM."}
    rows = sorted({0: "Done.", **described, **ended}.items())
    return write_page(
        "# Exit statuses",
        "Every command ends with one of these.",
        write_table(("status", "meaning"), [(str(status), meaning) for status, meaning in rows]),
    )


def _choices(command: str, option: str) -> str:
    (found,) = (each for each in main.commands[command].params if each.name == option)
    if not isinstance(found.type, click.Choice):
        raise TypeError(f"{command}.{option} has no choices")
    return _list(found.type.choices)


def _list(words: Iterable[object]) -> str:
    return ", ".join(write_code(str(word)) for word in words)
