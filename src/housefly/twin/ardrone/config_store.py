"""The simulated drone's configuration: common keys, and custom ones by session, user, application.

Rules: Parrot ARDroneLib SDK 2.0.1, multiconfiguration. The server acknowledges every well-formed
CONFIG; ``write`` returns whether it counted:

- names count in any case; a boolean is read by its first letter, a whole number up to what is no
  digit, as the maker's parser does (``strtol``);
- a key that may never be written, does not exist, or a value of another type does not count;
- keys that need ids count only right after CONFIG_IDS with the three ids in force, none of them the
  default one;
- CONFIG_IDS with other ids than those in force spoils the CONFIG that follows;
- without CONFIG_IDS, other keys are written into the configuration in force.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from housefly.errors import WireError
from housefly.twin.contracts import DroneCamera, OnboardLimits
from housefly.wires.ardrone.config import (
    DEFAULT_ID,
    KEYS_BY_NAME,
    ConfigValue,
    MulticonfigIds,
    VideoChannel,
    default_values,
    encode_custom_list,
    encode_dump,
    format_value,
    is_config_id,
    parse_value,
)
from housefly.wires.ardrone.config_keys import CONFIG_KEYS, Category, ConfigKey, KeyType

_ID_KEYS = {
    "custom:session_id": Category.SESSION,
    "custom:profile_id": Category.USER,
    "custom:application_id": Category.APPLICATION,
}
_DESCRIPTION_KEYS = {
    Category.APPLICATION: "custom:application_desc",
    Category.USER: "custom:profile_desc",
    Category.SESSION: "custom:session_desc",
}
_FORGET_ALL = "-all"
"""Value of an id key that deletes every custom configuration of its category."""
MAX_CUSTOM_CONFIGS = 32
"""How many configurations one category keeps."""

_LIVE_LIMITS = ("euler_angle_max", "control_vz_max", "control_yaw")
"""Limits kept in one set for indoors and one for outdoors; ``control:outdoor`` chooses."""

_TILT_MAX = 0.52
_CLIMB_MAX = 2.0
_YAW_RATE_MAX = 6.11
_ALTITUDE_MAX = 100.0
"""Largest tilt [rad], climb [m/s], yaw rate [rad/s] and altitude [m] that the firmware follows."""
_SILENCE_MIN = 1.0
"""Shortest time without a command that the twin lands after [s]; of a real drone not known."""

_WHOLE_PART = re.compile(r"\s*([+-]?\d{1,10})", re.ASCII)
_TRUTH = {"t": "TRUE", "f": "FALSE"}

_NEXT_CHANNEL = 4
"""Value of ``video:video_channel`` that means the other camera."""


class ConfigStore:
    """All values of one drone.

    Args:
        on_write: called with the key's name after each write that counted.
    """

    def __init__(self, on_write: Callable[[str], None] = lambda name: None) -> None:
        values = default_values()
        self._on_write = on_write
        self._common: dict[str, ConfigValue] = {
            key.name: values[key.name] for key in CONFIG_KEYS if key.category is Category.COMMON
        }
        self._customs: dict[Category, dict[str, dict[str, ConfigValue]]] = {
            category: {
                DEFAULT_ID: {
                    key.name: values[key.name] for key in CONFIG_KEYS if key.category is category
                }
            }
            for category in _DESCRIPTION_KEYS
        }
        self._active = dict.fromkeys(_DESCRIPTION_KEYS, DEFAULT_ID)

    @property
    def ids(self) -> MulticonfigIds:
        """The ids in force."""
        return MulticonfigIds(
            *(
                self._active[category]
                for category in (Category.SESSION, Category.USER, Category.APPLICATION)
            )
        )

    @property
    def demo(self) -> bool:
        """Whether the client wants the short navdata."""
        return self.value("general:navdata_demo") is True

    @property
    def demo_options(self) -> int:
        """Which options the client wants in the short navdata, a bit for each tag."""
        return int(self._number("general:navdata_options"))

    @property
    def video_enabled(self) -> bool:
        """Whether pictures may leave."""
        return self.value("general:video_enable") is True

    @property
    def camera(self) -> DroneCamera:
        """The camera in use."""
        return (
            DroneCamera.BOTTOM
            if self._number("video:video_channel") == VideoChannel.BOTTOM
            else DroneCamera.FRONT
        )

    @property
    def limits(self) -> OnboardLimits:
        """The maxima in force, in SI units."""
        return OnboardLimits(
            tilt=_within(self._number("control:euler_angle_max"), _TILT_MAX),
            climb=_within(self._number("control:control_vz_max") / 1000.0, _CLIMB_MAX),
            yaw_rate=_within(self._number("control:control_yaw"), _YAW_RATE_MAX),
            altitude=_within(self._number("control:altitude_max") / 1000.0, _ALTITUDE_MAX),
            silence=max(_SILENCE_MIN, self._number("general:com_watchdog")),
        )

    def value(self, name: str) -> ConfigValue:
        """Return the value in force of a known key."""
        if name in _ID_KEYS:
            return self._active[_ID_KEYS[name]]
        return self._layer(KEYS_BY_NAME[name])[name]

    def describe(self, customs: bool = False) -> bytes:
        """Return the configuration dump or, for ``customs``, the list of custom ones, with NUL."""
        if not customs:
            return encode_dump({key.name: self.value(key.name) for key in CONFIG_KEYS})
        return encode_custom_list(*(self._described(category) for category in _DESCRIPTION_KEYS))

    def write(self, name: str, text: str, ids: MulticonfigIds | None) -> bool:
        """Set a key as CONFIG asks and return whether it counted.

        Args:
            name: ``section:key``.
            text: the value as on the wire.
            ids: of the CONFIG_IDS right before; None when there was none.
        """
        key = KEYS_BY_NAME.get(name.lower())
        if key is None or not self._may_write(key, ids):
            return False
        category = _ID_KEYS.get(key.name)
        counted = self._assign(key, text) if category is None else self._switch(category, text)
        if counted:
            self._on_write(key.name)
        return counted

    def _may_write(self, key: ConfigKey, ids: MulticonfigIds | None) -> bool:
        if key.name in _ID_KEYS:
            return True
        if not key.writable or ids not in (None, self.ids):
            return False
        return not key.needs_ids or (ids is not None and DEFAULT_ID not in ids)

    def _switch(self, category: Category, text: str) -> bool:
        known = self._customs[category]
        if text == _FORGET_ALL:
            self._customs[category] = {DEFAULT_ID: known[DEFAULT_ID]}
            self._active[category] = DEFAULT_ID
            return True
        if not is_config_id(text) or (text not in known and len(known) >= MAX_CUSTOM_CONFIGS):
            return False
        known.setdefault(text, dict(known[DEFAULT_ID]))
        self._active[category] = text
        return True

    def _assign(self, key: ConfigKey, text: str) -> bool:
        try:
            value = parse_value(key, _as_read(key, text))
            format_value(key, value)
        except WireError:
            return False
        self._layer(key)[key.name] = (
            self._other_camera() if _asks_for_next_camera(key, value) else value
        )
        self._align_limits(key.name)
        return True

    def _align_limits(self, name: str) -> None:
        """Keep the live limits equal to the chosen indoor or outdoor set after a write."""
        chosen = "outdoor" if self.value("control:outdoor") else "indoor"
        for limit in _LIVE_LIMITS:
            live, kept = f"control:{limit}", f"control:{chosen}_{limit}"
            if name == live:
                self._layer(KEYS_BY_NAME[kept])[kept] = self.value(live)
            elif name in (kept, "control:outdoor"):
                self._layer(KEYS_BY_NAME[live])[live] = self.value(kept)

    def _other_camera(self) -> int:
        return VideoChannel.FRONT if self.camera is DroneCamera.BOTTOM else VideoChannel.BOTTOM

    def _layer(self, key: ConfigKey) -> dict[str, ConfigValue]:
        if key.category is Category.COMMON:
            return self._common
        return self._customs[key.category][self._active[key.category]]

    def _described(self, category: Category) -> list[tuple[str, str]]:
        return [
            (identity, str(values[_DESCRIPTION_KEYS[category]]))
            for identity, values in self._customs[category].items()
        ]

    def _number(self, name: str) -> float:
        value = self.value(name)
        return float(value) if isinstance(value, int | float) else 0.0


def _as_read(key: ConfigKey, text: str) -> str:
    """Return a value as the drone's own parser reads it."""
    if key.type is KeyType.BOOL:
        return _TRUTH.get(text.strip()[:1].lower(), text)
    whole = _WHOLE_PART.match(text) if key.type is KeyType.INT else None
    return text if whole is None else whole[1]


def _asks_for_next_camera(key: ConfigKey, value: ConfigValue) -> bool:
    return key.name == "video:video_channel" and value == _NEXT_CHANNEL


def _within(value: float, largest: float) -> float:
    return min(largest, max(0.0, value))
