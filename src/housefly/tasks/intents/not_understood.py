"""The answer to a sentence that means nothing here."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.tasks.api.values import ReasonCode
from housefly.tasks.intents.intent import Intent, Language


@dataclass(frozen=True, slots=True)
class NotUnderstood:
    """Why a sentence means nothing here, in its language, and what may have been meant."""

    sentence: str
    language: Language
    words: str
    suggestions: tuple[str, ...] = ()
    code: ReasonCode = ReasonCode.NOT_UNDERSTOOD


Recognition = Intent | NotUnderstood
