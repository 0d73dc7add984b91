"""A room whose names are spoken in three languages, and sentences sampled from hassil's files."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from typing import Any

from hassil.expression import Sentence
from hassil.intents import Intents, TextSlotList
from hassil.sample import sample_sentence

from housefly.hub.api.answers import ThingAnswer
from housefly.tasks.intents.intent import Language
from housefly.tasks.intents.names import Names, names_of
from housefly.tasks.intents.recognizer import recognizer

THINGS = (
    ("kitchen", "kitchen", "furniture", ()),
    ("place-kitchen", "Kitchen", "place", ("kitchen",)),
    ("place-entrance", "Entrance", "place", ("entrance",)),
    ("place-home", "Home", "place", ("home",)),
    ("sofa", "sofa", "furniture", ()),
    ("place-sofa", "Sofa", "place", ("sofa",)),
    ("refrigerator", "refrigerator", "furniture", ()),
    ("cabinet", "the cabinet", "furniture", ()),
    ("stove", "the stove", "structure", ()),
    ("wall", "wall", "structure", ()),
    ("bed", "bed", "furniture", ()),
    ("cup", "the red cup", "object", ("mug", "cup")),
    ("book", "the book", "object", ()),
    ("ardrone", "the drone", "robot", ("drone",)),
    ("person-1", "grandma", "person", ()),
    ("visitor", "the visitor", "person", ()),
)


def answered(id: str, name: str, kind: str = "object", *aliases: str) -> ThingAnswer:
    """Return a thing as the catalogue lists it."""
    return ThingAnswer(id, name, kind, aliases, None, "", ())


def names_with(*more: ThingAnswer) -> Names:
    """Return the names of the room, and more."""
    room = (answered(id, name, kind, *aliases) for id, name, kind, aliases in THINGS)
    return names_of((*room, *more))


NAMES = names_with()
SUBJECTS: dict[Language, dict[str, tuple[str, str]]] = {
    "en": {"red cup": ("cup", "thing"), "stove": ("stove", "thing")},
    "de": {"Tasse": ("cup", "thing"), "Herd": ("stove", "thing")},
    "ja": {"カップ": ("cup", "thing"), "コンロ": ("stove", "thing")},
}
"""Names of things, and whom they mean."""
PEOPLE: dict[Language, str] = {"en": "grandma", "de": "Oma", "ja": "おばあちゃん"}
PLACES: dict[Language, str] = {"en": "kitchen", "de": "Küche", "ja": "台所"}
_NUMBERS: dict[Language, dict[str, list[str]]] = {
    "en": {"hour": ["3", "three"], "minute": ["30"], "count": ["2", "two"]},
    "de": {"hour": ["3", "drei"], "minute": ["30"], "count": ["2", "zwei"], "halb_hour": ["vier"]},
    "ja": {"hour": ["3", "三"], "minute": ["30"], "count": ["2", "二"]},
}
_FEW_OF = ("day", "half", "state", "person_state", "mode", "period", "unit")
_MOST_OF_A_TEMPLATE = 3000
_SLOT = re.compile(r"\{([a-z_]+)(?::([a-z_]+))?\}")


@dataclass(frozen=True)
class SampledSentence:
    """A sentence of the sampler, and what it must mean."""

    text: str
    intent: str
    slots: dict[str, Any]


def sampled(language: Language, count: int, seed: int) -> tuple[SampledSentence, ...]:
    """Return sentences of a language, spread over all templates."""
    tree = recognizer(language).book.tree
    raw = Intents.from_dict({k: v for k, v in tree.items() if k in _HASSIL})
    lists = raw.slot_lists | {
        name: TextSlotList.from_strings(values) for name, values in _NUMBERS[language].items()
    }
    for name in _FEW_OF:
        if isinstance(known := lists.get(name), TextSlotList):
            lists[name] = TextSlotList(name, [known.values[0], known.values[-1]])
    lists["subject"] = TextSlotList.from_strings(list(SUBJECTS[language]))
    lists["person"] = TextSlotList.from_strings([PEOPLE[language]])
    lists["place"] = TextSlotList.from_strings([PLACES[language]])
    rng = random.Random(seed)
    made: list[SampledSentence] = []
    templates = [
        (name, block.slots, template)
        for name, intent in raw.intents.items()
        for block in intent.data
        for template in block.sentences
    ]
    each = -(-count // len(templates)) + 1
    for name, fixed, template in templates:
        texts = list(
            islice(
                sample_sentence(template, lists, raw.expansion_rules, language), _MOST_OF_A_TEMPLATE
            )
        )
        for text in rng.sample(texts, min(each, len(texts))):
            slots = {key: value for key, value in fixed.items() if key != "ahead"}  # of a time
            made.append(SampledSentence(text, name, slots | _named(text, template, language)))
    return tuple(rng.sample(made, max(count, min(count, len(made)))))


_HASSIL = ("language", "intents", "expansion_rules", "lists", "skip_words", "settings")


def _named(text: str, template: Sentence, language: Language) -> dict[str, str]:
    """Return the subject that the sampler put in; what the template writes itself is none."""
    lists = {name for name, slot in _slots_of(template, language)}
    found: tuple[str, str] | None = None
    if "person" in lists and PEOPLE[language] in text:
        found = ("person-1", "person")
    if "place" in lists and PLACES[language] in text:
        found = ("kitchen", "place")
    if "subject" in lists:
        found = next((who for name, who in SUBJECTS[language].items() if name in text), found)
    return {} if found is None else {"subject": found[0], "subject_kind": found[1]}


def _slots_of(template: Sentence, language: Language) -> Iterator[tuple[str, str]]:
    """Yield the room's lists of a template, and the slots that they fill."""
    rules = recognizer(language).book.tree["expansion_rules"]
    text = template.text or ""
    for rule in rules:
        text = text.replace(f"<{rule}>", f"({rules[rule]})")
    for name, slot in _SLOT.findall(text):
        if (slot or name) == "subject":
            yield name, slot or name
