"""A phone on another machine opens the QR code's address and flies: two networks and a cable.

The console is the real one, started by the commands that a person types. The phone is Chromium in
the other network; it trusts the authority and nothing else, and ignores nothing.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

SUPPORT = Path(__file__).resolve().parents[1] / "support"
HOUSEFLY = (sys.executable, "-m", "housefly.cli")
SITE = """
name = "two machines"
[drone]
has_video = false
[hub]
store = "room.db"
[tasks]
enabled = false
[twin]
video = false
"""
"""Without what costs much and is not the subject."""

pytestmark = [
    pytest.mark.interop,
    pytest.mark.wire,
    pytest.mark.realtime,
    pytest.mark.browser,
    pytest.mark.slow,
]


def can_make_networks() -> bool:
    if sys.platform != "linux" or os.geteuid() != 0 or not Path("/etc/chromium").is_dir():
        return False
    tried = ["unshare", "-n", "-m", "sh", "-c", "ip link add cable type veth peer name plug"]
    return subprocess.run(tried, capture_output=True, check=False).returncode == 0


@pytest.mark.skipif(not can_make_networks(), reason="only root makes networks, with iproute2")
@pytest.mark.timeout(420)
def test_a_phone_on_another_machine_opens_the_address_of_the_code_and_flies(
    tmp_path: Path,
) -> None:
    site, store = tmp_path / "site.toml", tmp_path / "room.db"
    site.write_text(SITE.replace("room.db", str(store)))
    private = tmp_path / "run"
    private.mkdir(mode=0o700)
    environment = {**os.environ, "XDG_RUNTIME_DIR": str(private)}
    made = subprocess.run(
        [*HOUSEFLY, "cert", "--site", str(site)], env=environment, capture_output=True, check=True
    )
    assert b"fingerprint" in made.stdout
    # The address of the cable is not in that certificate: the start renews it, and the phone
    # trusts it as before.
    shutil.copy(tmp_path / "tls" / "authority.pem", tmp_path)
    record = tmp_path / "record"
    server = [*HOUSEFLY, "run", "--lan", "--site", str(site), "--record", str(record)]
    client = [sys.executable, str(SUPPORT / "phone_client.py"), str(tmp_path)]
    script = ["bash", str(SUPPORT / "second_machine.sh"), str(tmp_path), *server, "--", *client]
    done = subprocess.run(
        ["unshare", "-n", "-m", *script],
        env=environment,
        capture_output=True,
        text=True,
        timeout=400,
        check=False,
    )
    said = (tmp_path / "said").read_text()
    assert done.returncode == 0, done.stdout + done.stderr + said
    seen = json.loads(done.stdout.splitlines()[-1])
    assert seen["link"].startswith("https://10.77.0.1:8080/?token=")
    assert seen["address"] == "https://10.77.0.1:8080/" and seen["secure"]
    assert "Your drone is home" in seen["said"]
    assert len(seen["kept"]) == 1, "the shell is kept: the certificate is trusted, not ignored"
    assert seen["again"] == 403, "the code opens one browser"
    assert "made anew, phones trust it as before" in said and said.endswith("server: 0\n")
    summary = json.loads((record / "summary.json").read_text())
    assert summary["flown_length_m"] > 10.0, summary
    assert any("service entrance by" in event["text"] for event in summary["events"])
