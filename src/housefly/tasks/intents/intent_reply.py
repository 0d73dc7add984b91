"""What comes of an intent: words, and what is to be done. Nothing here does it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from housefly.evidence.clip_values import ClipsQuestion
from housefly.messages import OrderKind
from housefly.tasks.api.questions import BoardQuestion, SetMode
from housefly.tasks.api.values import TaskRequest
from housefly.tasks.intents.speech import Speech


class TaskAct(StrEnum):
    """What is to be done with the task that flies, or is next."""

    CANCEL = "cancel"
    PAUSE = "pause"
    CONTINUE = "continue"


@dataclass(frozen=True, slots=True)
class Notice:
    """Somebody wants to be told, once.

    Attributes:
        words: what to say then.
        kinds: of the events of the room that are waited for; any of them.
        thing: id of the thing or person that the event must be of; "" is any.
        at: or the time that is waited for [Unix time, s].
    """

    words: str
    kinds: tuple[str, ...] = ()
    thing: str = ""
    at: float | None = None

    def is_due(self, kind: str, thing: str) -> bool:
        """Return whether an event of the room is what is waited for."""
        return kind in self.kinds and self.thing in ("", thing)

    def is_due_at(self, now: float) -> bool:
        """Return whether the time has come [Unix time, s]."""
        return self.at is not None and now >= self.at


@dataclass(frozen=True, slots=True)
class IntentReply:
    """The reply to an intent; at most one of the fields after ``words`` is there, or none.

    Attributes:
        words: the answer, in the language that was asked in.
        request: asks for this service.
        offer: what a yes would ask for; nothing is asked for yet.
        without_offer: the answer without the question that goes with the offer.
        act: concerns the task that flies.
        order: for the pilot, at once.
        question: for the tasks.
        notice: to be kept until it is due.
    """

    words: str
    request: TaskRequest | None = None
    offer: TaskRequest | None = None
    act: TaskAct | None = None
    order: OrderKind | None = None
    question: SetMode | ClipsQuestion | BoardQuestion | None = None
    notice: Notice | None = None
    without_offer: str = ""


def offering(say: Speech, words: str, offer: TaskRequest) -> IntentReply:
    """Return a reply that ends with the question whether to do what is offered."""
    asked = say.joined(words, say("shall_i_look"))
    return IntentReply(asked, offer=offer, without_offer=words)
