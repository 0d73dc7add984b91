"""Says what the tasks answered to an intent: which recordings there are, which mode is set."""

from __future__ import annotations

from pathlib import Path

from housefly.evidence.clip_values import ClipsAnswer
from housefly.tasks.api.answers import TaskBoard
from housefly.tasks.intents.intent import Intent
from housefly.tasks.intents.names import Names
from housefly.tasks.intents.recognizer import recognizer
from housefly.tasks.intents.speech import Speech


def words_of_answer(
    intent: Intent,
    answer: ClipsAnswer | TaskBoard,
    names: Names,
    now: float,
    own: Path | None = None,
) -> str:
    """Return in words what ``IntentReply.question`` was answered with, in the intent's language."""
    say = Speech(recognizer(intent.language, own).book, names, now)
    if isinstance(answer, TaskBoard):
        return say("mode_is", mode=say.say(f"mode {answer.mode.value}"))
    if not answer.clips:
        return say("no_clips")
    count, newest = len(answer.clips), say.clock(answer.clips[0].began_at)
    return say("one_clip" if count == 1 else "some_clips", count=count, clock=newest)
