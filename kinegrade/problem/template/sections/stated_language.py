"""The key `language`: in which language a file has the texts that it writes once."""

from __future__ import annotations

from msgspec.structs import replace

from kinegrade.language import Language
from kinegrade.problem.template.draft import Draft
from kinegrade.problem.template.template import Ask
from kinegrade.problem.template.translated import Translated


def state_language(draft: Draft, language: Language) -> Draft:
    """The draft with its plain texts as texts in that language alone."""

    def state(text: Translated) -> Translated:
        plain = text.plain
        return text if plain is None else Translated(((language, plain),))

    def state_ask(ask: Ask) -> Ask:
        sign = state(ask.sign) if isinstance(ask.sign, Translated) else ask.sign
        return replace(ask, means=state(ask.means), sign=sign)

    about, statement = draft.about, draft.statement
    parameters = draft.parameters.items()
    return replace(
        draft,
        about=about and replace(about, title=state(about.title)),
        statement=statement and state(statement),
        texts={
            name: {n: replace(each, text=state(each.text)) for n, each in wordings.items()}
            for name, wordings in draft.texts.items()
        },
        parameters={name: replace(each, means=state(each.means)) for name, each in parameters},
        reasons={name: state(reason) for name, reason in draft.reasons.items()},
        asks={name: state_ask(ask) for name, ask in draft.asks.items()},
    )
