"""What each mode of the house allows: who may launch, what is recorded, which zones are blank."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from housefly.config.house_mode import HouseMode
from housefly.tasks.api.values import ATTENDED, Confirm, Priority, ReasonCode, RequestSurface


class UnattendedLaunch(Enum):
    """What may happen when no person asks: a rule, a webhook, a message, an assistant."""

    AS_ASKED = "as the rule says"
    NAMED = "alarms, and rules that name this mode"
    ALARM_AFTER_YES = "alarms, after a yes"
    NEVER = "never"


@dataclass(frozen=True, slots=True)
class ModeRules:
    """What one mode allows.

    Attributes:
        person: whether people may fly tasks.
        unattended: what may launch when no person asks.
        words: all of it, for people.
    """

    person: bool
    unattended: UnattendedLaunch
    words: str


MODE_TABLE = {
    HouseMode.HOME: ModeRules(
        True, UnattendedLaunch.AS_ASKED, "people and rules may fly; tasks may record"
    ),
    HouseMode.AWAY: ModeRules(
        True, UnattendedLaunch.AS_ASKED, "people and rules may fly; tasks may record"
    ),
    HouseMode.NIGHT: ModeRules(
        True,
        UnattendedLaunch.NAMED,
        "people may fly, of rules only alarms and those made for the night; tasks may record",
    ),
    HouseMode.PRIVACY: ModeRules(
        True,
        UnattendedLaunch.ALARM_AFTER_YES,
        "nothing flies by itself and nothing records; an alarm asks first",
    ),
    HouseMode.MAINTENANCE: ModeRules(
        False, UnattendedLaunch.NEVER, "no task flies and nothing records"
    ),
}
"""All modes; the console, the rules and the camera read the same table."""


@dataclass(frozen=True, slots=True)
class LaunchPermit:
    """Whether a task may be queued: OK with how it is confirmed, or why not, in words."""

    code: ReasonCode
    confirm: Confirm
    words: str = ""

    @property
    def is_given(self) -> bool:
        """Whether it may."""
        return self.code is ReasonCode.OK


def launch_permit(
    mode: HouseMode,
    surface: RequestSurface,
    *,
    confirm: Confirm = Confirm.AUTO,
    priority: Priority = Priority.PERSON,
    names_mode: bool = False,
    flies: bool = True,
) -> LaunchPermit:
    """Return whether a task may be queued in a mode.

    Args:
        mode: of the house.
        surface: where the request comes from.
        confirm: as asked for; a mode makes it stricter, never laxer.
        priority: of the task.
        names_mode: whether a rule is made for this mode.
        flies: whether the task flies; one that does not may always run.
    """
    allowed = MODE_TABLE[mode]
    if not flies:
        return LaunchPermit(ReasonCode.OK, confirm)
    if surface in ATTENDED:
        return LaunchPermit(ReasonCode.OK, confirm) if allowed.person else _refused(mode, confirm)
    match allowed.unattended:
        case UnattendedLaunch.AS_ASKED:
            is_given = True
        case UnattendedLaunch.NAMED:
            is_given = names_mode or priority is Priority.ALARM or confirm is Confirm.ASK
        case UnattendedLaunch.ALARM_AFTER_YES:
            is_given, confirm = priority is Priority.ALARM, _stricter(confirm)
        case UnattendedLaunch.NEVER:
            is_given = False
    return LaunchPermit(ReasonCode.OK, confirm) if is_given else _refused(mode, confirm)


def _stricter(confirm: Confirm) -> Confirm:
    return Confirm.ASK if confirm is Confirm.AUTO else confirm


def _refused(mode: HouseMode, confirm: Confirm) -> LaunchPermit:
    words = f"the house is in mode {mode.value}: {MODE_TABLE[mode].words}"
    return LaunchPermit(ReasonCode.MODE, confirm, words)
