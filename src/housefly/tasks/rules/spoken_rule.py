"""What a rule waits for, as people say it: the beginning of its sentence on the page."""

from __future__ import annotations

from housefly.messages.words import Words, figure
from housefly.tasks.rules.rule import (
    WEEKDAYS,
    EventPattern,
    Rule,
    SituationPattern,
    TimePattern,
    WebhookPattern,
    awaited_words,
)

_SPOKEN = {
    "bell pressed": Words("When the bell rings"),
    "person fallen": Words("When somebody may have fallen"),
}


def spoken_when(rule: Rule) -> Words:
    """Return what a rule waits for, and what must hold beside the mode."""
    when = _when(rule)
    others = rule.conditions.model_copy(update={"mode": ()})
    more = rule.model_copy(update={"conditions": others}).if_words()
    return Words("{when}, if {what}", when=when, what=more) if more else when


def _when(rule: Rule) -> Words:
    match rule.when:
        case WebhookPattern(webhook=name):
            return Words("When the webhook {name} is called", name=name)
        case TimePattern(every=every) if every:
            return Words("Every {n} min", n=figure(every / 60.0, "g"))
        case TimePattern(at=times, days=days):
            told = ", ".join(f"{at:%H:%M}" for at in times)
            if len(days) == len(WEEKDAYS):
                return Words("Every day at {time}", time=told)
            return Words("On {days} at {time}", days=", ".join(days), time=told)
        case EventPattern(event=name, thing="", facts=facts) if not facts and name in _SPOKEN:
            return _SPOKEN[name]
        case SituationPattern(situation=name, thing="", edge="begins") if name in _SPOKEN:
            return _SPOKEN[name]
        case happens:
            return Words("When {what}", what=awaited_words(happens))
