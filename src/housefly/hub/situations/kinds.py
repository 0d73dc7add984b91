"""What the detectors claim: one kind for each situation, whatever its words."""

from __future__ import annotations

from enum import StrEnum

_ENDED = " ended"


class SituationKind(StrEnum):
    """What a situation is about; its value is the kind of the event that begins it."""

    PERSON_PRESENT = "person present"
    PERSON_WALKING = "person walking"
    PERSON_STANDING = "person standing"
    PERSON_SITTING = "person sitting"
    PERSON_LYING = "person lying"
    PERSON_FALLEN = "person fallen"
    BED_OCCUPIED = "bed occupied"
    DOOR_OPEN_LONG = "door open too long"
    APPLIANCE_ON = "appliance on"
    CONTACT_OPEN = "contact open"
    AT_ENTRANCE = "someone at the entrance"
    OBJECT_TAKEN = "object taken"
    OBJECT_PUT = "object put"
    OBJECT_MISSING = "object missing"

    @property
    def ended(self) -> str:
        """The kind of the event that ends it."""
        return self.value + _ENDED


POSTURES: dict[str, str] = {
    SituationKind.PERSON_LYING: "lying",
    SituationKind.PERSON_SITTING: "sitting",
    SituationKind.PERSON_STANDING: "standing",
    SituationKind.PERSON_WALKING: "walking",
}
"""What each posture is called in answers; of several that hold the first counts."""
OF_PEOPLE: frozenset[str] = frozenset(
    {*POSTURES, SituationKind.PERSON_PRESENT, SituationKind.PERSON_FALLEN}
)
"""Situations whose thing is a person."""
BEGUN_BY: dict[str, SituationKind] = {kind.ended: kind for kind in SituationKind}
"""The situation that an event ends, by the event's kind."""
