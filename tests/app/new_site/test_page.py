"""``housefly new NAME --page`` as a process: it prints a link, serves it, keeps, and ends."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from urllib.request import HTTPCookieProcessor, build_opener

import pytest

from housefly.room.draft.files import load_draft

pytestmark = pytest.mark.wire


@pytest.fixture
def serving(tmp_path: Path) -> Iterator[subprocess.Popen[str]]:
    process = subprocess.Popen(
        [
            sys.executable,
            "-m",
            "housefly.cli",
            "new",
            str(tmp_path / "mylab"),
            "--page",
            "--room",
            "6x4",
            "--drone",
            "tello",
        ],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    yield process
    process.kill()
    process.communicate()


def test_the_printed_link_opens_the_page_with_what_options_said_and_ctrl_c_ends_it(
    serving: subprocess.Popen[str], tmp_path: Path
) -> None:
    assert serving.stdout is not None
    found = re.search(r"http://127\.0\.0\.1:\d+/\?token=\S+", serving.stdout.readline())
    assert found is not None
    with build_opener(HTTPCookieProcessor()).open(found[0], timeout=30) as answer:
        assert answer.status == 200 and b"/static/new.js" in answer.read()
    assert "Ctrl+C" in serving.stdout.readline()
    serving.send_signal(signal.SIGINT)
    rest, _ = serving.communicate(timeout=30)
    assert (serving.returncode, rest) == (0, "")
    draft = load_draft(tmp_path / "mylab")
    assert draft is not None and draft.bounds == (0.0, 0.0, 6.0, 4.0)
    assert draft.drone is not None and draft.drone.model == "tello"
