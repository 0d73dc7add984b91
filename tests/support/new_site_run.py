"""A newcomer types a site into a real terminal; their keys are counted, and the site is flown.

``python tests/support/new_site_run.py [FOLDER]`` does it for an empty rectangle, for a ROS map and
for a scan that the twin's own depth camera made, and prints keys and outcomes.
"""

from __future__ import annotations

import os
import pty
import select
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from depth_scan import scan_points, write_ply

import housefly
from housefly.sites.loaded_site import load_site

HOUSEFLY = (sys.executable, "-m", "housefly.cli")
KEYS_PER_SECOND = 1.0
"""A newcomer who reads, thinks and corrects himself."""
SMALL_HOUSE = Path(__file__).resolve().parents[3] / "shared/data/rooms/small_house/map.yaml"


CTRL_C, _END = "\x03", "\x04"
_LONGEST = 60.0
"""A dialog that takes longer hangs [s]."""


@dataclass(frozen=True, slots=True)
class TypedSite:
    """A site that was typed: every key, Enter included, and what the terminal showed."""

    folder: Path
    keys: int
    shown: str
    status: int


def typed_site(folder: Path, *lines: str, arguments: tuple[str, ...] = ()) -> TypedSite:
    """Type lines into ``housefly new`` in a terminal, each when a question stands there.

    ``CTRL_C`` interrupts instead; after the last line the input ends.
    """
    master, slave = pty.openpty()
    process = subprocess.Popen(
        [*HOUSEFLY, "new", folder.name, *arguments],
        stdin=slave, stdout=slave, stderr=slave, cwd=folder.parent,
        env={**os.environ, "TERM": "dumb", "COLUMNS": "200"},
    )  # fmt: skip
    os.close(slave)
    shown, waiting, ends_at = "", [*lines, _END], time.monotonic() + _LONGEST
    try:
        while (part := _read(master)) is not None and time.monotonic() < ends_at:
            shown += part
            if waiting and shown.endswith(": "):
                line = waiting.pop(0)
                shown += "\0"
                if line == CTRL_C:
                    process.send_signal(signal.SIGINT)
                else:
                    os.write(master, line.encode() if line == _END else f"{line}\n".encode())
        status = process.wait(60.0)
    finally:
        process.kill()
        process.wait()
        os.close(master)
    command = f"housefly new {folder.name}\n"
    keys = len(command) + sum(1 if line == CTRL_C else len(line) + 1 for line in lines)
    return TypedSite(folder, keys, shown.replace("\0", "").replace("\r", ""), status)


def _read(master: int) -> str | None:
    """Return what the terminal shows next, "" for nothing yet, None when it was closed."""
    if not select.select([master], [], [], 0.1)[0]:
        return ""
    try:
        return os.read(master, 65536).decode(errors="replace")
    except OSError:  # the other side is closed
        return None


def flown(folder: Path, look_s: float = 0.5) -> str:
    """Return the outcome of a simulated service to the site's nearest place."""
    site = load_site(str(folder))
    x, y = site.room.home
    place = min(
        (place for place in site.room.places if place.name != "home"),
        key=lambda place: (place.viewpoint[0] - x) ** 2 + (place.viewpoint[1] - y) ** 2,
    )
    return housefly.fly(place.name, site, look_s=look_s).outcome


def main() -> None:
    """Type three rooms, fly in each, and print a table."""
    with tempfile.TemporaryDirectory() as name:
        base = Path(sys.argv[1] if len(sys.argv) > 1 else name)
        base.mkdir(parents=True, exist_ok=True)
        write_ply(scan_points(load_site("bsen")), base / "scan.ply")
        rooms = {"rectangle": "6x4x2.5", "small_house": str(SMALL_HOUSE), "scan": "scan.ply"}
        print(f"{'room':<12} {'keys':>5} {'typing':>8} {'machine':>8}  outcome")
        for room, answer in rooms.items():
            began = time.monotonic()
            done = typed_site(base / room, answer, "", "", "", "", "")
            outcome = flown(base / room) if done.status == 0 else done.shown
            seconds = time.monotonic() - began
            print(
                f"{room:<12} {done.keys:>5} {done.keys / KEYS_PER_SECOND:>6.0f} s"
                f" {seconds:>6.0f} s  {outcome}"
            )


if __name__ == "__main__":
    main()
