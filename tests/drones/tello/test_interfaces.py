"""Several Tellos that all have one address, told apart by the network interface towards each."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("mujoco")

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow, pytest.mark.interop]

SCRIPT = Path(__file__).with_name("two_at_one_address.py")


def can_make_networks() -> bool:
    try:
        made = subprocess.run(
            [
                "unshare",
                "-rn",
                "ip",
                "link",
                "add",
                "veth7",
                "type",
                "veth",
                "peer",
                "name",
                "veth8",
            ],
            capture_output=True,
            check=False,
        )
    except OSError:
        return False
    return made.returncode == 0


def test_two_at_one_address_are_told_apart_by_their_interfaces() -> None:
    if not can_make_networks():
        pytest.skip("this machine lets nobody make a network namespace with a veth in it")
    told = subprocess.run(
        ["unshare", "-rn", sys.executable, str(SCRIPT)],
        capture_output=True,
        text=True,
        timeout=90,
        check=False,
    )
    assert told.returncode == 0, told.stderr
    assert json.loads(told.stdout.splitlines()[-1]) == {"wifi0": 0.9, "wifi1": 0.6}
