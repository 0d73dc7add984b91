"""The MQTT broker of a run: mosquitto on loopback, for a site with ``mqtt.start = true``.

``python -m housefly.app.broker_main``, started by the launcher. It keeps nothing on disk and
accepts every program of this machine.
"""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
import time
from pathlib import Path

from housefly.app.runtime import runtime_from_environment

_SEARCH_PATH = os.pathsep.join((os.environ.get("PATH", ""), "/usr/sbin", "/usr/local/sbin"))
"""Debian installs mosquitto outside the PATH of ordinary users."""
_RETRY_PAUSE = 60.0
"""Pause before the process ends where mosquitto is not installed [s]; the launcher tries again."""
_REMEDY = "mosquitto is not installed, so no devices are heard: apt-get install mosquitto"


def _find_mosquitto() -> str | None:
    """Return the path of mosquitto, or None."""
    return shutil.which("mosquitto", path=_SEARCH_PATH)


def main() -> int:
    """Become the broker."""
    site = runtime_from_environment().site()
    found = _find_mosquitto()
    if found is None:
        print(_REMEDY, file=sys.stderr, flush=True)
        time.sleep(_RETRY_PAUSE)
        return 1
    folder = Path(tempfile.mkdtemp(prefix="housefly-broker-"))
    settings = folder / "mosquitto.conf"
    settings.write_text(
        f"listener {site.mqtt.port} {site.mqtt.broker}\nallow_anonymous true\npersistence"
        " false\nuser root\n"
    )
    os.execv(found, [found, "-c", str(settings)])


if __name__ == "__main__":
    sys.exit(main())
