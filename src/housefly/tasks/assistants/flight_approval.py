"""What a person is asked before an assistant's flight: our own words around checked values."""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from threading import Lock

from housefly.errors import HouseflyError, TaskError
from housefly.hub.api.questions import WhereQuestion
from housefly.tasks.api.questions import ServicesQuestion
from housefly.tasks.api.values import ParameterInfo, ParameterValue, ReasonCode, ServiceInfo
from housefly.tasks.assistants.assistant_room import AssistantRoom

PATIENCE = 120.0
"""A yes that comes later counts for nothing [s]."""
_NAMED = frozenset({"place", "thing", "place_or_thing", "person", "places"})
"""Types of parameters that name a subject in the room."""
_SAFE_ID = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.:-]{0,39}")
_SAFE_CHOICE = re.compile(r"[a-z][a-z_]{0,19}")
_MAX_OPEN = 32


@dataclass(frozen=True, slots=True)
class CheckedFlight:
    """A request whose service and parameters exist.

    Attributes:
        service: its name.
        parameters: as given.
        words: the question to a person; "" when a value cannot be shown without text of the room.
    """

    service: str
    parameters: dict[str, ParameterValue]
    words: str


def checked_flight(
    room: AssistantRoom, service: str, parameters: Mapping[str, ParameterValue]
) -> CheckedFlight:
    """Return a request with the words that ask a person for it.

    Raises:
        TaskError: UNKNOWN_SERVICE, BAD_PARAMETER.
        ThingError: a thing is not known.
        LinkError: nobody answers.
    """
    services = {info.name: info for info in room.ask_tasks(ServicesQuestion()).services}
    info = services.get(service)
    if info is None:
        raise TaskError("there is no such service", ReasonCode.UNKNOWN_SERVICE.value)
    known = {item.name: item for item in info.parameters}
    if any(name not in known for name in parameters):
        raise TaskError(
            f"{info.name} takes {', '.join(known) or 'no parameters'}",
            ReasonCode.BAD_PARAMETER.value,
        )
    shown = [_shown(room, known[name], value) for name, value in parameters.items()]
    words = "" if "" in shown or not _SAFE_ID.fullmatch(service) else _question(info, shown)
    return CheckedFlight(service, dict(parameters), words)


def _question(info: ServiceInfo, shown: list[str]) -> str:
    given = f" with {', '.join(shown)}" if shown else ""
    flies = "The drone flies then." if info.flies else "Nothing flies."
    return f"An assistant asks for the service {info.name}{given}. {flies} May it?"


def _shown(room: AssistantRoom, parameter: ParameterInfo, value: ParameterValue) -> str:
    """Return a value for a person's eyes, "" when that takes words that are not ours."""
    if isinstance(value, bool):
        return f"{parameter.name} {'yes' if value else 'no'}"
    if isinstance(value, float):
        return f"{parameter.name} {value:g}{f' {parameter.unit}' if parameter.unit else ''}"
    if parameter.type == "choice":
        return f"{parameter.name} {value}" if _SAFE_CHOICE.fullmatch(value) else ""
    if parameter.type not in _NAMED:
        return ""
    names = value.split(",") if parameter.type == "places" else [value]
    known = [_id_of(room, name.strip()) for name in names]
    return "" if "" in known else f"{parameter.name} {' and '.join(known)}"


def _id_of(room: AssistantRoom, name: str) -> str:
    """Return the id of a thing in quotes, "" when there is none that may be shown.

    The site's owner gave it; a name or an alias may be anybody's.
    """
    try:
        known: str = room.ask(WhereQuestion(name)).thing
    except HouseflyError:
        return ""
    return f'"{known}"' if _SAFE_ID.fullmatch(known) else ""


class ApprovalBook:
    """Numbers the questions, so that one yes starts one flight.

    Args:
        clock: monotonic time [s].
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock, self._lock = clock, Lock()
        self._open: dict[tuple[object, ...], tuple[int, float]] = {}
        self._number = 0

    def question(self, flight: CheckedFlight) -> str:
        """Return the words that ask for a flight; the same until it is approved or too late."""
        with self._lock:
            key, now = _key(flight), self._clock()
            number, since = self._open.get(key, (0, now))
            if not number or now - since > PATIENCE:
                self._number += 1
                number, since = self._number, now
                while len(self._open) >= _MAX_OPEN:
                    del self._open[next(iter(self._open))]
            self._open[key] = number, since
            return f"Request {number}. {flight.words}"

    def take(self, flight: CheckedFlight) -> bool:
        """Return whether a yes to this flight counts now; it counts once."""
        with self._lock:
            _, since = self._open.pop(_key(flight), (0, float("-inf")))
            return self._clock() - since <= PATIENCE


def _key(flight: CheckedFlight) -> tuple[object, ...]:
    return flight.service, tuple(sorted((k, str(v)) for k, v in flight.parameters.items()))
