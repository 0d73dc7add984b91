"""Every situation that the detectors claim."""

from __future__ import annotations

from housefly.hub.situations.appliance import APPLIANCE_ON, CONTACT_OPEN
from housefly.hub.situations.bed import BED_OCCUPIED
from housefly.hub.situations.door import OPEN_LONG
from housefly.hub.situations.entrance import AT_ENTRANCE
from housefly.hub.situations.fall import FALLEN
from housefly.hub.situations.move import PUT, TAKEN
from housefly.hub.situations.objects import MISSING
from housefly.hub.situations.person import PRESENT
from housefly.hub.situations.posture import LYING, SITTING, STANDING, WALKING

SITUATION_KINDS = (
    PRESENT,
    WALKING,
    STANDING,
    SITTING,
    LYING,
    FALLEN,
    BED_OCCUPIED,
    OPEN_LONG,
    APPLIANCE_ON,
    CONTACT_OPEN,
    AT_ENTRANCE,
    TAKEN,
    PUT,
    MISSING,
)
