"""Who may have fallen, and who left their bed at night and is not seen: from posture over time."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from housefly.errors import HouseflyError
from housefly.hub.api.questions import NightsQuestion, PeopleQuestion
from housefly.hub.api.state_answers import NightAnswer, PersonAnswer
from housefly.tasks.execution.run_context import RunContext

NIGHT = 12 * 3600.0
"""Beds are asked about as far back as this [s]."""
ON_THE_FLOOR = "on the floor"
_VISITOR = "visitor"
"""A guest whom nobody sees is not here: how they are is no question."""

Named = tuple[str, str]
"""An id, and what people call it."""


@dataclass(frozen=True, slots=True)
class PeopleCheck:
    """What counts: a fall of which one is so sure (0 to 1), and a bed left for so long [s]."""

    sure: float
    away: float


@dataclass(frozen=True, slots=True)
class PeopleFound:
    """How everybody is, one line each; who may have fallen; who left their bed and is not seen.

    ``unsure`` names those of whom nobody knows how they are, "" for none.
    """

    lines: tuple[str, ...]
    in_need: Named | None
    missing: Named | None
    unsure: str = ""


def check_people(context: RunContext, person: str, check: PeopleCheck) -> PeopleFound:
    """Return how people are.

    Args:
        context: of the task.
        person: one of them, or "" for all.
        check: what counts.

    Raises:
        HouseflyError: the memory does not answer, or knows no such person.
    """
    known: tuple[PersonAnswer, ...] = context.room.ask(PeopleQuestion(person)).people
    people = [each for each in known if each.person != _VISITOR or not _is_unknown(each)]
    lines = [each.words[:1].upper() + each.words[1:] for each in people]
    fallen = [each for each in people if _may_have_fallen(each, check.sure)]
    worst = max(fallen, key=lambda each: each.fallen, default=None)
    missing = None if worst else _missing(context, people, check.away)
    if missing is not None:
        minutes = (context.inputs.unix - missing[1]) / 60.0
        lines.append(f"{missing[0][1]} left the bed {minutes:.0f} min ago and is not seen")
    if not people:
        lines.append("Nobody is known to be here")
    return PeopleFound(
        tuple(lines),
        None if worst is None else (worst.person, worst.name),
        None if missing is None else missing[0],
        " and ".join(each.name for each in people if _is_unknown(each)),
    )


def _may_have_fallen(person: PersonAnswer, sure: float) -> bool:
    """Who lies on the floor counts, too, whom nobody saw come down there."""
    lies = person.posture == "lying" and ON_THE_FLOOR in person.activity
    return person.fallen >= sure or (lies and person.confidence >= sure)


def _is_unknown(person: PersonAnswer) -> bool:
    return person.present != "no" and not person.posture and person.confidence <= 0.0


def _missing(
    context: RunContext, people: Iterable[PersonAnswer], away: float
) -> tuple[Named, float] | None:
    """Return who left their bed in this night, did not come back and is not seen; and when."""
    now = context.inputs.unix
    try:
        nights = context.room.ask(NightsQuestion(max(0.0, now - NIGHT))).nights
    except HouseflyError:
        return None
    by_id = {each.person: each for each in people}
    for night in nights:
        left = _left_at(night)
        who = by_id.get(night.thing)
        is_seen = (
            who.present == "yes"
            if who is not None
            else any(each.present == "yes" for each in people)
        )
        is_late = left is not None and night.begin <= now <= night.end and now - left > away
        if left is not None and is_late and not is_seen:
            return (night.thing, who.name if who else "whoever slept there"), left
    return None


def _left_at(night: NightAnswer) -> float | None:
    """Return when somebody left their bed for good [Unix time, s], None when they did not."""
    if night.rose is not None:
        return night.rose
    last = night.times_up[-1] if night.times_up else None
    return last.left if last is not None and last.back is None else None
