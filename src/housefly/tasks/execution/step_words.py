"""What a step does, in words for people."""

from __future__ import annotations

from housefly.tasks.document.step_forms import default_of
from housefly.tasks.document.steps import StepKind, TaskStep
from housefly.tasks.document.templates import plain_text

_WORDS: dict[StepKind, str] = {
    StepKind.TAKE_OFF: "take off",
    StepKind.GO_TO: "fly to {subject}",
    StepKind.LOOK_AT: "look at {subject}",
    StepKind.SWEEP: "take {views} pictures all around",
    StepKind.FOLLOW: "follow {person} for {time} s",
    StepKind.RETURN_HOME: "come home and land",
    StepKind.LAND: "land here",
    StepKind.RECORD: "record {time} s",
    StepKind.SNAPSHOT: "take a picture",
    StepKind.SAY: "say: {words}",
    StepKind.ANNOUNCE: "announce: {words}",
    StepKind.REPORT: "report: {words}",
    StepKind.PUBLISH: "publish to {topic}",
    StepKind.ASK: "ask: {question}",
    StepKind.WAIT: "wait up to {time} s",
    StepKind.FIND: "ask the memory where {subject} is",
    StepKind.SEARCH: "look for {subject}",
    StepKind.COVERAGE: "say how much of the floor was seen",
    StepKind.CONTENTS: "see what is in {thing}",
    StepKind.CHANGES: "see what changed",
    StepKind.CHECK_PEOPLE: "see how everybody is",
    StepKind.FAIL: "give up: {words}",
}


def step_words(step: TaskStep) -> str:
    """Return what a step does; what other steps find stays open, as $name."""
    words = _WORDS[step.kind]
    for name in _names(words):
        value = step.arguments.get(name, default_of(step.kind, name))
        shown = f"{value:g}" if isinstance(value, float) else _shown(value)
        words = words.replace("{" + name + "}", shown)
    return words


def open_words(words: str) -> str:
    """Return what a step does while nobody knows yet what other steps find: (visitor)."""
    return plain_text(words, lambda name: f"({name})")


def _names(words: str) -> list[str]:
    return [part.partition("}")[0] for part in words.split("{")[1:]]


def _shown(value: object) -> str:
    return value if isinstance(value, str) else "a point"
