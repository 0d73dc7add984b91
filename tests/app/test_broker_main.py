"""The run's own MQTT broker, as a process."""

from __future__ import annotations

import signal
import socket
import subprocess
import sys
import time
from pathlib import Path

import pytest
from mqtt_broker import mosquitto_or_skip

from housefly.app.new_runtime import new_runtime
from housefly.config.site import Site, changed

pytestmark = pytest.mark.wire


def test_it_answers_and_leaves_nothing_but_what_ends_with_the_run(tmp_path: Path) -> None:
    mosquitto_or_skip()
    run, temporary = tmp_path / "run", tmp_path / "tmp"
    run.mkdir()
    temporary.mkdir()
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    site = changed(Site(), mqtt__broker="127.0.0.1", mqtt__port=port, mqtt__start=True)
    environment = {**new_runtime(site, run).environment(), "TMPDIR": str(temporary)}
    command = [sys.executable, "-m", "housefly.app.broker_main"]
    with subprocess.Popen(command, env=environment, stderr=subprocess.DEVNULL) as broker:
        try:
            wait_for(port)
        finally:
            broker.send_signal(signal.SIGTERM)
    assert list(temporary.iterdir()) == []
    assert {file.name for file in run.iterdir()} == {"site.json", "mosquitto.conf"}


def wait_for(port: int) -> None:
    """Return when somebody answers there."""
    deadline = time.monotonic() + 60.0
    while True:
        try:
            socket.create_connection(("127.0.0.1", port), timeout=5.0).close()
        except OSError:
            assert time.monotonic() < deadline
            time.sleep(0.1)
        else:
            return
