"""The step that looks for a lost thing where it most likely is, one look each time it begins."""

from __future__ import annotations

from housefly.errors import HouseflyError
from housefly.hub.api.questions import WhereQuestion
from housefly.messages.words import Words
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.execution.flight_steps import START_TIME, GoTo
from housefly.tasks.execution.step_behavior import StepFailed
from housefly.tasks.execution.task_room import SearchPlan
from housefly.tasks.execution.values import Report, Say
from housefly.tasks.vantage.thing_search import SearchLook, SearchSummary
from housefly.tasks.vantage.viewpoint import Viewpoint

LOOKS_MAX = 8
"""Most looks of one search."""
SENSED_WITHIN = 5.0
"""What a sensor of the room told so lately is no longer lost [s]."""
YES, NO = "yes", "no"
"""What is replied to whether the thing is in the picture."""
PLACES_TOLD = 4
"""Most places that are told not to have been looked at."""
_TELLING = 0.01
"""Less likely ones are not told."""


class Search(GoTo):
    """Flies to where a lost thing shows most likely soonest, and faces that.

    Begun again in the same task, the last look showed nothing, or nobody said so. It never finds
    anything itself: a sensor of the room tells where the thing is, or a person sees it in a
    picture.
    """

    FACES = True
    _search: SearchPlan | None = None
    _spot: SearchLook | None = None
    _thing = ""
    _looks = 0
    _until = 0.0

    def begin(self) -> None:
        """Choose the next look and set off, or end the search."""
        self._usual = START_TIME
        thing, self._view = self.text("subject"), None
        if self._search is None or thing != self._thing:
            self._start(thing)
        elif self._spot is not None:
            self._note_reply(self._spot)
        self._spot = None
        if self._has_ended() or self._is_sensed():
            return
        self._spot = self._next()
        if self._spot is None:
            self._give_up()
            return
        self._looks += 1
        self.context.results[self.text("as")] = self._spot.view.subject
        super().begin()

    def is_done_already(self) -> bool:
        """Return whether there is nothing to fly to."""
        return self._spot is None

    def viewpoint(self) -> Viewpoint:
        """Return where to look from."""
        assert self._spot is not None
        return self._spot.view

    def look_in_words(self) -> Words:
        """Return that it looks for the thing: nobody says that it is there."""
        return Words("Looking for {thing}", thing=self.context.title_of(self._thing))

    def proceed(self) -> bool:
        """Wait until it has arrived; a place without a way is left out."""
        if self._spot is None:
            return True
        try:
            return super().proceed()
        except StepFailed as failed:
            if failed.code is not ReasonCode.NO_WAY or self._search is None:
                raise
            self._search.leave_out(self._spot)
            self._spot = None
            self.context.results[self.text("as")] = ""
            return True

    def _start(self, thing: str) -> None:
        context = self.context
        for name in ("as", "ended", "reply"):
            context.results.pop(self.text(name), None)
        drone, look_time = context.inputs.position, self.number("look")
        self._thing, self._looks = thing, 0
        self._search = context.room.search(thing, drone, look_time)
        self._until = context.time + self.number("time")

    def _has_ended(self) -> bool:
        return bool(self.context.results.get(self.text("ended")))

    def _end(self, *lines: str) -> None:
        self.context.results[self.text("ended")] = YES
        self.context.actions += [Report(line) for line in lines]
        self.context.actions += [Say(line) for line in lines[:1]]

    def _note_reply(self, look: SearchLook) -> None:
        """Take in what somebody said of the last picture; a yes ends the search."""
        reply = self.context.results.get(self.text("reply"))
        if reply == YES:
            self.context.results[self.text("ended")] = YES
        elif self._search is not None:
            self._search.was_shown(look, nothing=reply == NO)

    def _is_sensed(self) -> bool:
        """Return whether a sensor of the room sees the thing itself now, and say so."""
        try:
            answer = self.context.room.ask(WhereQuestion(self._thing))
        except HouseflyError:
            return False
        is_new = answer.age is not None and answer.age <= SENSED_WITHIN
        if not is_new or answer.position is None or answer.by_container or answer.alternatives:
            return False
        self._end(f"The sensors of the room have it now: {answer.words}")
        return True

    def _next(self) -> SearchLook | None:
        left = self._until - self.context.time
        if self._search is None or self._looks >= LOOKS_MAX or left <= 0.0:
            return None
        least = self.number("least") / 100.0
        looks = self._search.looks(self.context.inputs.position, least, left)
        return looks[0] if looks else None

    def _give_up(self) -> None:
        """Say that it was not found, what was looked at and what was not."""
        assert self._search is not None
        title = self.context.title_of(self._thing)
        self._end(*_lines(title, self._search.summary()))


def _lines(title: str, found: SearchSummary) -> list[str]:
    """Return what became of a search in vain, a line each."""
    name = title[:1].upper() + title[1:]
    lines = [
        f"{name} was not found; the pictures cover {100.0 * found.covered:.0f} % of where it may be"
    ]
    unanswered = found.covered - found.answered
    if unanswered >= _TELLING:
        lines.append(
            f"For {100.0 * unanswered:.0f} % nobody said whether it is in the pictures:"
            " please look at them"
        )
    if found.looked:
        lines.append(f"Looked at: {', '.join(found.looked)}")
    left = [f"{place} ({100.0 * p:.0f} %)" for place, p in found.left if p >= _TELLING]
    if left:
        more = "" if len(left) <= PLACES_TOLD else f" and {len(left) - PLACES_TOLD} more"
        lines.append(f"Not looked at: {', '.join(left[:PLACES_TOLD])}{more}")
    return lines
