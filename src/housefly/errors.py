"""Every error that Housefly raises on purpose.

HouseflyError
├── ConfigError        a configured value is wrong; names the key and the allowed range
├── RoomError          a room or map cannot be read or makes no sense
├── EditsError         changes to the room are refused; names the item and what is allowed
│   └── StaleEdits     somebody else saved in between
├── WireError          received bytes do not follow the protocol
│   └── UnknownState   a device says a state that is not known, or that it does not know it
├── LinkError          a drone, tracking system or bus peer does not answer
├── RecordingError     a recording cannot be read or written
├── ThingError         a thing is not known, is ambiguous, or cannot be where somebody puts it
├── TaskError          a task, or a request for one, is refused; carries a reason code
├── StoreError         the room's memory cannot be opened, read or written
└── MissingPartError   an optional part (extra, system library, renderer) is not installed
"""

from __future__ import annotations


class HouseflyError(Exception):
    """Base of all errors raised on purpose; the command line prints it without a traceback."""


class ConfigError(HouseflyError):
    """A configured value is missing, of the wrong type, out of range, or contradicts another.

    Attributes:
        key: dotted path of the value in its file, for example ``limits.speed``.
        problem: what is wrong and what is allowed, with the unit.
    """

    def __init__(self, key: str, problem: str, source: str = "") -> None:
        self.key = key
        self.problem = problem
        self.source = source
        where = f"{source}: " if source else ""
        super().__init__(f"{where}{key}: {problem}")


class RoomError(HouseflyError):
    """A room description or a map file cannot be used."""


class EditsError(HouseflyError):
    """Changes to places and zones are refused.

    Attributes:
        item: which one: ``places.0``, ``removed.1``, ``zones.2``, or "" for all of them.
    """

    def __init__(self, problem: str, item: str = "") -> None:
        self.item = item
        super().__init__(problem)


class StaleEdits(EditsError):
    """Somebody else saved a version after the one that these changes are based on."""


class WireError(HouseflyError):
    """Bytes received do not follow the protocol."""


class UnknownState(WireError):
    """A device says a state that its kind does not know, or that it does not know its own."""


class LinkError(HouseflyError):
    """The other side of a wire does not answer, or refused."""


class RecordingError(HouseflyError):
    """A recording cannot be read or written."""


class ThingError(HouseflyError):
    """A thing is not known, is meant by several names, or would contain itself."""


class TaskError(HouseflyError):
    """A task or a request for one is refused.

    Attributes:
        code: the reason, a value of ``tasks.api.values.ReasonCode``.
    """

    def __init__(self, problem: str, code: str) -> None:
        self.code = code
        super().__init__(problem)


class StoreError(HouseflyError):
    """The database of the room's memory refuses.

    Attributes:
        reason: why, in a few words that fit behind a colon: "disk is full".
    """

    def __init__(self, reason: str, remedy: str = "") -> None:
        self.reason = reason
        super().__init__(f"{reason}; {remedy}" if remedy else reason)


class SharedStoreError(StoreError):
    """Another run holds the database of the room's memory."""


class MissingPartError(HouseflyError):
    """An optional part is not installed.

    Attributes:
        part: what is missing.
        remedy: the one line that installs it.
    """

    def __init__(self, part: str, remedy: str) -> None:
        self.part = part
        self.remedy = remedy
        super().__init__(f"{part} is missing; install it with: {remedy}")
