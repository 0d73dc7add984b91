"""Asks one question after the other and keeps the draft after each answer."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from housefly.app.new_site.answers import answered, place_of_point, with_frame_point
from housefly.app.new_site.asker import Asker
from housefly.app.new_site.questions import ANY_TIME, QUESTIONS, Question
from housefly.errors import ConfigError, HouseflyError, LinkError
from housefly.messages.words import Words, joined
from housefly.room.draft.alignment import fit_words, rigid_fit
from housefly.room.draft.files import save_draft
from housefly.room.draft.missing import DraftStep, Missing, missing
from housefly.room.draft.model import DraftDrone, DraftTracking, SiteDraft
from housefly.room.draft.shapes import room_of_draft
from housefly.room.draft.site_of_draft import site_of_draft
from housefly.room.draw import text_map
from housefly.room.grid import build_grid
from housefly.tracking.live_check import LISTEN_SECONDS, Heard, heard_words

_POINT_SECONDS = 2.0
_FORWARD, _BACK = 1, -1


@dataclass(frozen=True, slots=True)
class Wires:
    """How tracking and drone are tried; None leaves the trial out."""

    hear: Callable[[DraftTracking, float], Heard] | None = None
    check: Callable[[DraftDrone], tuple[Words, ...]] | None = None


class LeftDialog(Exception):
    """Whoever answers wants to go on later."""


class NewSiteDialog:
    """One description of a site, from the first question that is open on.

    Args:
        draft: what is known already.
        folder: where the draft is kept.
        asker: whoever answers.
        wires: how tracking and drone are tried.
        given: answers of the command's options, by step; these questions are not asked.
        base: folder that names of files are relative to.
    """

    def __init__(
        self,
        draft: SiteDraft,
        folder: Path,
        asker: Asker,
        wires: Wires | None = None,
        given: dict[DraftStep, tuple[str, ...]] | None = None,
        base: Path | None = None,
    ) -> None:
        self.draft = draft
        self._folder, self._asker, self._wires = folder, asker, wires or Wires()
        self._given = given or {}
        self._base = base or Path()

    def run(self) -> SiteDraft:
        """Ask until nothing that hinders a flight is missing; return the draft.

        Raises:
            LeftDialog: they want to go on later.
            OutOfAnswers: a script's lines ended.
            HouseflyError: an option, or a script's answer, is refused.
        """
        self.take_given()
        for item in self._hindrances():
            if item.step in self._given:
                raise _refusal(item)
        number, way = self._first(), _FORWARD
        while number < len(QUESTIONS):
            if self._is_asked(QUESTIONS[number]):
                way = self._ask(QUESTIONS[number])
            elif number == 0:
                way = _FORWARD
            number = max(0, number + way)
            if number == len(QUESTIONS) and (open_ := self._hindrances()):
                self._tell("Still missing:", open_)
                number = next(n for n, q in enumerate(QUESTIONS) if q.step is open_[0].step)
                if not (self._asker.is_patient and self._is_asked(QUESTIONS[number])):
                    raise _refusal(open_[0])
        return self.draft

    def take_given(self) -> None:
        """Take the answers of the command's options in; raises HouseflyError for a refused one."""
        for question in QUESTIONS:
            for text in self._given.get(question.step, ()):
                self._take(question.step, text)

    def _first(self) -> int:
        steps = [question.step.value for question in QUESTIONS]
        done = self.draft.answered
        number = steps.index(done) + 1 if done in steps else 0
        is_open = any(self._is_asked(question) for question in QUESTIONS[number:])
        return number if is_open else 0

    def _is_asked(self, question: Question) -> bool:
        return question.step not in self._given and (self.draft.hardware or not question.hardware)

    def _ask(self, question: Question) -> int:
        """Ask one question until it is answered; return the way to go on."""
        while True:
            default = question.default(self.draft)
            text = self._asker.ask(question.words, default)
            if text == "back":
                return _BACK
            if self._serves(text, question):
                continue
            is_enter = text == "" or (text == default and question.keeps(self.draft))
            try:
                if not (is_enter and (question.keeps(self.draft) or not default)):
                    self._take(question.step, text or default)
            except HouseflyError as error:
                if not self._asker.is_patient:
                    raise
                self._asker.tell(str(error))
                continue
            lacks = [item for item in missing(self.draft) if item.step is question.step]
            self._tell("", lacks)
            hindered = [item for item in lacks if item.hinders]
            is_last = is_enter or not question.repeats
            if hindered and is_last and not self._asker.is_patient:
                raise _refusal(hindered[0])
            if not hindered and is_last:
                self.draft = replace(self.draft, answered=question.step.value)
                save_draft(self.draft, self._folder)
                return _FORWARD

    def _serves(self, text: str, question: Question) -> bool:
        """Do what may be asked for at any question; return whether it was such a word."""
        if text in ("help", "?"):
            self._asker.tell(f"{question.help}\n{ANY_TIME}")
        elif text == "missing":
            self._tell("", list(missing(self.draft)))
        elif text == "map":
            self._asker.tell(map_words(self.draft))
        elif text == "quit":
            raise LeftDialog("left")
        else:
            return False
        return True

    def _take(self, step: DraftStep, text: str) -> None:
        """Take one answer in, try what it names, and keep the draft."""
        if step is DraftStep.FRAME and "=" not in text and text != "again":
            words: tuple[str, ...] = self._measure_point(text)
        else:
            self.draft, words = answered(self.draft, step, text, self._base)
        save_draft(self.draft, self._folder)
        for line in (*words, *self._trial(step)):
            self._asker.tell(line)

    def _trial(self, step: DraftStep) -> tuple[str, ...]:
        """Return what tracking or drone say, and how well the points of the frame agree."""
        draft, wires = self.draft, self._wires
        if not draft.hardware:
            return ()
        if step is DraftStep.TRACKING and draft.tracking and wires.hear:
            self._asker.tell("listening ...")
            heard = wires.hear(draft.tracking, LISTEN_SECONDS)
            return heard_words(heard, draft.tracking.body)
        if step is DraftStep.DRONE and draft.drone and draft.drone.address and wires.check:
            self._asker.tell("asking the drone ...")
            return wires.check(draft.drone)
        if step is DraftStep.FRAME and len(draft.frame_points) > 1:
            return fit_words(rigid_fit(draft.frame_points), draft.frame_points)
        if step is DraftStep.FRAME and draft.frame_points:
            return ("one point; take another one, metres away",)
        return ()

    def _measure_point(self, text: str) -> tuple[str, ...]:
        """Take where tracking sees the drone now as a point whose place on the map was typed."""
        on_map = place_of_point(self.draft, text)
        tracking, hear = self.draft.tracking, self._wires.hear
        if tracking is None or hear is None:
            raise ConfigError("point", "tracking is not listened to; type X,Y = X,Y,Z")
        heard = hear(tracking, _POINT_SECONDS)
        body = heard.body(tracking.body)
        if body is None:
            raise LinkError(joined("; ", heard_words(heard, tracking.body)))
        if not body.is_still:
            raise LinkError(
                f"{body.name} moved by {100 * body.spread:.0f} cm meanwhile: put it down, and type"
                " the point again"
            )
        self.draft = with_frame_point(self.draft, on_map, body.position)
        x, y, z = body.position
        return (f"tracking sees it at ({x:.3f}, {y:.3f}, {z:.3f}) m",)

    def _hindrances(self) -> list[Missing]:
        return [item for item in missing(self.draft) if item.hinders]

    def _tell(self, title: str, items: list[Missing]) -> None:
        if title:
            self._asker.tell(title)
        for item in items:
            kind = "missing" if item.hinders else "note"
            self._asker.tell(f"{kind}: {item.words}\n   -> {item.mend}")


def map_words(draft: SiteDraft) -> str:
    """Return the room as text, as far as it is known."""
    if draft.bounds is None:
        return "there is nothing to draw before the room has a size"
    room = room_of_draft(draft)
    return text_map(room, build_grid(room, site_of_draft(draft, simulated=True)))


def _refusal(item: Missing) -> ConfigError:
    return ConfigError(item.step.value, joined("; ", (item.words, item.mend)))
