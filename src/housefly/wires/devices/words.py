"""Words of many makers for on and off, open and closed, online and offline, and for not knowing."""

from __future__ import annotations

from collections.abc import Iterable

MakerWords = tuple[str, tuple[str, ...], tuple[str, ...]]
"""Who says so, and the words for yes (on, open, online) and for no."""
SWITCH_ROWS: tuple[MakerWords, ...] = (
    ("Zigbee2MQTT, Tasmota, ESPHome, Home Assistant, FHEM", ("on",), ("off",)),
    ("JSON, Homematic, Z-Wave JS", ("true",), ("false",)),
    ("KNX, mqtt-smarthome", ("1",), ("0",)),
    ("Shelly of the first generation", (), ("overpower",)),
)
CONTACT_ROWS: tuple[MakerWords, ...] = (
    ("Zigbee2MQTT", ("false",), ("true",)),
    ("Home Assistant, ESPHome, Tasmota", ("on",), ("off",)),
    ("Shelly of the first generation", ("open",), ("close",)),
    ("openHAB, Homematic IP, FHEM", ("open", "tilted"), ("closed",)),
    ("covers of Zigbee2MQTT and Home Assistant", ("open", "opening", "closing"), ("close",)),
    ("shutters of Shelly", ("opened",), ("closed",)),
    ("Z-Wave JS UI", ("window/door is open",), ("window/door is closed",)),
)
_PRESENCE_ROWS: tuple[MakerWords, ...] = (
    ("Zigbee2MQTT, Tasmota, ESPHome, Home Assistant", ("online",), ("offline",)),
    ("Shelly", ("true",), ("false",)),
    ("Homie", ("ready", "sleeping", "alert"), ("disconnected", "lost", "init")),
    ("OpenMQTTGateway, deCONZ", ("connected", "available"), ("unavailable",)),
    ("Z-Wave JS UI", ("alive", "awake", "asleep"), ("dead",)),
)
UNKNOWN_WORDS = frozenset({"", "unknown", "unavailable", "none", "null", "nan", "undef", "n/a"})
"""What devices say that do not know their own value, in lower case."""


def _table(rows: Iterable[MakerWords]) -> dict[str, bool]:
    """Return what each word means, in lower case."""
    return {
        word: meaning
        for _, yes, no in rows
        for meaning, words in ((True, yes), (False, no))
        for word in words
    }


ON_WORDS = _table(SWITCH_ROWS)
"""What a switch may say, in any case; JSON's true and false and the numbers too."""
OPEN_WORDS = _table(CONTACT_ROWS)
"""What a contact may say: true is closed as in Zigbee2MQTT, "ON" is open as in Home Assistant.

Of 1 and 0 the makers think otherwise each, so that the site file has to say it.
"""
PRESENCE_WORDS = _table(_PRESENCE_ROWS)
"""What an availability topic may say."""
FLAG_WORDS = {"true": True, "on": True, "yes": True, "1": True,
              "false": False, "off": False, "no": False, "0": False}  # fmt: skip
"""What a truth value may be on our own topics."""
