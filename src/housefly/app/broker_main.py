"""The MQTT broker of a run: mosquitto on loopback, for a site with ``mqtt.start = true``.

``python -m housefly.app.broker_main``, started by the launcher. It keeps nothing on disk and
accepts every program of this machine, and no other: ``mqtt.allow`` says which devices count.
"""

from __future__ import annotations

import ctypes
import os
import signal
import sys
import time

from housefly.app.mosquitto import find_mosquitto
from housefly.app.runtime import runtime_from_environment
from housefly.config.process_log import log_line

_RETRY_PAUSE = 60.0
"""Pause before the process ends where mosquitto is not installed [s]; the launcher tries again."""
_PR_SET_PDEATHSIG = 1
_MAX_CLIENTS, _MAX_PACKET = 512, 65536
"""Clients at a time, and the largest packet of one [bytes]."""
_REMEDY = "mosquitto is not installed, so no devices are heard: apt-get install mosquitto"


def main() -> int:
    """Become the broker."""
    runtime = runtime_from_environment()
    site = runtime.site()
    found = find_mosquitto()
    if found is None:
        log_line(_REMEDY, sys.stderr)
        time.sleep(_RETRY_PAUSE)
        return 1
    settings = runtime.site_file.with_name("mosquitto.conf")  # it ends with the run's folder
    settings.write_text(
        f"listener {site.mqtt.port} {site.mqtt.broker}\nallow_anonymous true\npersistence"
        f" false\nuser root\nmax_connections {_MAX_CLIENTS}\nmax_packet_size {_MAX_PACKET}\n"
    )
    _end_with_launcher()
    os.execv(found, [found, "-c", str(settings)])


def _end_with_launcher() -> None:
    """Let mosquitto, which cannot watch a pipe, end with the thread that started this process."""
    signal.pthread_sigmask(signal.SIG_SETMASK, ())
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGTERM)


if __name__ == "__main__":
    sys.exit(main())
