"""The sentences of one language: shipped with the package, and a person's own."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

from housefly.errors import ConfigError
from housefly.tasks.intents.intent import LANGUAGES, Language
from housefly.tasks.intents.sentence_file import (
    ROOM_LISTS,
    own_sentence_files,
    read_sentence_file,
)
from housefly.tasks.intents.spoken_text import folded

if TYPE_CHECKING:
    from hassil.intents import Intents

_NAME = re.compile(r"\{(\w+)[^{}]*\}")
_ROOM_NAME = re.compile(rf"\{{(?:{'|'.join(ROOM_LISTS)})(?::\w+)?\}}")
_MOST_SHORTEST = 300
_REFERENCE = re.compile(r"\{[^{}]*\}|<[^<>]*>")
_WORD = re.compile(r"[^\W\d_]+(?:'[a-z]+)?")


@dataclass(frozen=True, slots=True)
class SentenceBook:
    """Everything that is known of one language.

    Attributes:
        language: which.
        intents: hassil's templates, folded as sentences are.
        skip_words: may stand anywhere and mean nothing, folded.
        stop_words: each of them stops the drone, folded.
        native_names: names in this language for names in English, folded to as written.
        negations: words that turn a sentence into its opposite, folded.
        words: all that stand in the templates, folded to as written.
        examples: a short sentence for each template, folded; {subject} and {person} stand for
            names.
        tree: the merged files, as written.
    """

    language: Language
    intents: Intents
    skip_words: tuple[str, ...]
    stop_words: frozenset[str]
    native_names: Mapping[str, tuple[str, ...]]
    negations: tuple[str, ...]
    words: Mapping[str, str]
    examples: tuple[str, ...]
    tree: Mapping[str, Any]


def sentence_book(language: Language, own: Path | None = None) -> SentenceBook:
    """Return the sentences of a language.

    Args:
        language: which.
        own: folder with a person's own ``*.yaml`` files; those of this language count.

    Raises:
        ConfigError: a file is not one, with its name and what is wrong.
    """
    from hassil.errors import HassilError
    from hassil.intents import Intents
    from hassil.parser import ParseError
    from hassil.util import merge_dict

    tree = _shipped(language)
    for more in own_sentence_files(own, language):
        merge_dict(tree, more)
    try:
        intents = Intents.from_dict(_folded_tree(tree, language))
        examples = tuple(dict.fromkeys(_examples(intents)))
    except (HassilError, ParseError) as error:
        why = f"cannot be read ({error})"
        raise ConfigError("sentences", why, str(own or _shipped_file(language))) from error
    return SentenceBook(
        language,
        intents,
        tuple(folded(word, language) for word in tree["skip_words"]),
        all_stop_words(),
        {folded(name, "en"): tuple(_listed(said)) for name, said in tree["names"].items()},
        tuple(folded(word, language) for word in tree["negations"]),
        _words(tree, language),
        examples,
        tree,
    )


@cache
def all_stop_words() -> frozenset[str]:
    """Return the STOP words of all languages, folded: each counts in every language."""
    return frozenset(
        folded(word, form)
        for language in LANGUAGES
        for word in _shipped(language)["stop_words"]
        for form in LANGUAGES
    )


def _shipped_file(language: str) -> Path:
    """Return the file of a language that comes with the package."""
    return Path(__file__).with_name(f"sentences_{language}.yaml")


def _shipped(language: str) -> dict[str, Any]:
    return read_sentence_file(_shipped_file(language))


def _folded_tree(tree: Mapping[str, Any], language: Language) -> dict[str, Any]:
    """Return the tree with the text of its templates folded; keys and values stay."""

    def text(template: str) -> str:
        # casefold and NFKC would join "{a} {b}" no differently; lists and rules are named in
        # small ASCII letters, so folding a template leaves its syntax alone.
        lead = " " if template.startswith(" ") else ""
        tail = " " if template.endswith(" ") else ""
        return f"{lead}{folded(template, language)}{tail}"

    def values(entries: Iterable[Any]) -> list[Any]:
        return [
            {**one, "in": text(str(one["in"]))}
            if isinstance(one, dict)
            else {"in": text(str(one)), "out": one}
            for one in entries
        ]

    return {
        "language": language,
        "settings": tree.get("settings") or {},
        "intents": {
            name: {
                "data": [
                    {**block, "sentences": [text(one) for one in block["sentences"]]}
                    for block in entry["data"]
                ]
            }
            for name, entry in tree["intents"].items()
        },
        "expansion_rules": {
            name: text(rule) for name, rule in (tree.get("expansion_rules") or {}).items()
        },
        "lists": {
            name: {**entry, "values": values(entry["values"])} if "values" in entry else entry
            for name, entry in (tree.get("lists") or {}).items()
        },
        "skip_words": [],
    }


def _listed(said: Any) -> list[str]:
    return [said] if isinstance(said, str) else [str(one) for one in said]


def _words(tree: Mapping[str, Any], language: Language) -> dict[str, str]:
    """Return all words of templates, rules, lists and names: folded to as written."""
    texts = [*(tree.get("expansion_rules") or {}).values(), *tree["skip_words"]]
    for entry in tree["intents"].values():
        texts += [text for block in entry["data"] for text in block["sentences"]]
    for entry in (tree.get("lists") or {}).values():
        values = entry.get("values", ())
        texts += [str(one["in"] if isinstance(one, dict) else one) for one in values]
    texts += [name for said in tree["names"].values() for name in _listed(said)]
    bare = (_REFERENCE.sub(" ", text) for text in texts)
    return {folded(word, language): word for text in bare for word in _WORD.findall(text)}


def _examples(intents: Intents) -> Iterator[str]:
    """Yield the shortest sentence of each template; those with other slots are left out.

    Raises ConfigError for a template that has no words of its own: names alone are no sentence.
    """
    from hassil.sample import sample_sentence

    for intent in intents.intents.values():
        for template in (one for block in intent.data for one in block.sentences):
            made = sample_sentence(
                template, intents.slot_lists, intents.expansion_rules, intents.language,
                expand_lists=False, skip_optionals=True,
            )  # fmt: skip
            shortest = list(islice(made, _MOST_SHORTEST))
            if not all(_says_something(_ROOM_NAME.sub("", text)) for text in shortest):
                raise ConfigError(
                    f"intents.{intent.name}", f"{template.text!r} may consist only of names"
                )
            lists = set(_NAME.findall(shortest[0]))
            if unknown := lists - set(intents.slot_lists) - set(ROOM_LISTS):
                raise ConfigError(
                    f"intents.{intent.name}", f"{template.text!r} needs a list {min(unknown)!r}"
                )
            if set(_REFERENCE.findall(shortest[0])) <= {"{subject}", "{person}"}:
                yield shortest[0]


def _says_something(text: str) -> bool:
    return any(one.isalnum() for one in text)
