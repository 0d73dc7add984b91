"""Everything that an answer is made from."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.hub.client.room_queries import RoomQueries
from housefly.tasks.intents.intent import Intent, IntentSlots, NameKind
from housefly.tasks.intents.names import NamedSubject, Names
from housefly.tasks.intents.speech import Speech


@dataclass(frozen=True, slots=True)
class Asking:
    """An intent, whom it is asked of, and how to speak.

    Attributes:
        intent: what is asked.
        names: of the room.
        room: remembers.
        now: Unix time [s].
        say: speaks the language of the intent.
    """

    intent: Intent
    names: Names
    room: RoomQueries
    now: float
    say: Speech

    @property
    def slots(self) -> IntentSlots:
        """What was said."""
        return self.intent.slots

    def subject(self) -> NamedSubject | None:
        """Return what it is about; what no name is known of is called by its id."""
        wanted = self.slots.subject
        if wanted is None:
            return None
        kind = self.slots.subject_kind
        known = self.names.of(wanted, kind) or self.names.of_thing(wanted)
        return known or NamedSubject(wanted, kind or NameKind.THING, (wanted,), wanted)

    def people(self) -> tuple[str, ...]:
        """Return the ids of whom it is about: the person who was named, or everybody."""
        subject = self.subject()
        if subject is not None:
            return (subject.thing,)
        return tuple(one.thing for one in self.names.subjects if one.kind is NameKind.PERSON)
