"""Where the MQTT broker mosquitto is on this machine."""

from __future__ import annotations

import os
import shutil

_SEARCH_PATH = os.pathsep.join((os.environ.get("PATH", ""), "/usr/sbin", "/usr/local/sbin"))
"""Debian installs mosquitto outside the PATH of ordinary users."""


def find_mosquitto() -> str | None:
    """Return the path of mosquitto; None where it is not installed."""
    return shutil.which("mosquitto", path=_SEARCH_PATH)
