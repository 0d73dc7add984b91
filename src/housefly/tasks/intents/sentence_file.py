"""A file of sentences: hassil's YAML format, checked key by key, and what we add to it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Any

import yaml
from pydantic import Field, field_validator

from housefly.config.section import Section
from housefly.config.text import read_text_file
from housefly.config.validation import validated
from housefly.errors import ConfigError
from housefly.tasks.intents.intent import IntentName, Language

ROOM_LISTS = ("subject", "person", "place")
"""Lists that the room fills; sentences use them and files never define them."""
_Text = Annotated[str, Field(min_length=1, max_length=1000)]
_Key = Annotated[str, Field(pattern=r"^[a-z][a-z0-9_]*$", max_length=40)]
_Value = str | float | bool


class _Block(Section):
    """Sentences, and the slots that they all set."""

    sentences: tuple[_Text, ...]
    slots: dict[_Key, _Value] = Field(default_factory=dict)


class _Sentences(Section):
    """The sentences of one intent."""

    data: tuple[_Block, ...]


class _ListValue(Section):
    """One value of a list: what is said, and what it means."""

    said: _Text = Field(alias="in")
    out: _Value


class _Range(Section):
    """Whole numbers, in digits and in words."""

    begin: int = Field(alias="from", ge=-10000, le=10000)
    end: int = Field(alias="to", ge=-10000, le=10000)


class _SlotList(Section):
    """A list: values or a range of numbers."""

    values: tuple[_Text | _ListValue, ...] | None = None
    range: _Range | None = None


class _Settings(Section):
    """How hassil matches."""

    ignore_whitespace: bool = False


class SentenceFile(Section):
    """A file of sentences in one language."""

    language: Language
    settings: _Settings = _Settings()
    intents: dict[IntentName, _Sentences] = Field(default_factory=dict)
    expansion_rules: dict[_Key, _Text] = Field(default_factory=dict)
    lists: dict[_Key, _SlotList] = Field(default_factory=dict)
    skip_words: tuple[_Text, ...] = ()
    negations: tuple[_Text, ...] = ()
    stop_words: tuple[_Text, ...] = ()
    names: dict[_Text, _Text | tuple[_Text, ...]] = Field(default_factory=dict)

    @field_validator("lists")
    @classmethod
    def _leaves_the_rooms_lists_alone(cls, lists: dict[str, _SlotList]) -> dict[str, _SlotList]:
        if taken := sorted(set(lists) & set(ROOM_LISTS)):
            raise ValueError(f"{taken[0]} is filled with the room's names")
        return lists


def read_sentence_file(path: Path) -> dict[str, Any]:
    """Return the values of a file as hassil wants them; raises ConfigError for a bad one."""
    try:
        tree = yaml.load(read_text_file(path), yaml.CSafeLoader)
    except (OSError, ValueError, yaml.YAMLError, RecursionError) as error:
        raise ConfigError("sentences", f"cannot be read ({error})", str(path)) from error
    checked = validated(SentenceFile, tree, "sentences", str(path))
    return dict(_plain(checked.model_dump(by_alias=True, exclude_none=True)))


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {str(key): _plain(item) for key, item in value.items()}
    if isinstance(value, tuple | list):
        return [_plain(item) for item in value]
    return value


def own_sentence_files(folder: Path | None, language: Language) -> Iterator[dict[str, Any]]:
    """Yield a person's own files of a language; raises ConfigError for a bad one of any."""
    if folder is None or not folder.is_dir():
        return
    for path in sorted(folder.glob("*.yaml")):
        tree = read_sentence_file(path)
        if tree.pop("language") == language:
            tree.pop("settings")
            yield tree
