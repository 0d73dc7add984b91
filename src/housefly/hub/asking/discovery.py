"""Where a run tells other programs of the same user how to ask its room: a file that only this user
can read.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path

from housefly.errors import LinkError

ROOM_KEY = "HOUSEFLY_ROOM_KEY"
"""The hub finds the key of its run in this variable of its environment: other users can read
command lines.
"""


@dataclass(frozen=True, slots=True)
class MeetingPlace:
    """One run.

    Attributes:
        site: name of the site.
        address: of its HTTP API, without a path.
        key: bearer token.
        pid: of the launcher.
        port: loopback TCP port on which the hub answers itself; 0 where it does not.
    """

    site: str
    address: str
    key: str
    pid: int
    port: int = 0


@contextmanager
def announced(place: MeetingPlace) -> Iterator[None]:
    """Tell of a run until the block ends."""
    file = folder() / f"{place.pid}.json"
    file.touch(mode=0o600)
    file.write_text(json.dumps(asdict(place)), encoding="utf-8")
    try:
        yield
    finally:
        file.unlink(missing_ok=True)


def running() -> tuple[MeetingPlace, ...]:
    """Return the runs of this user, the youngest first; files of runs that are gone are removed."""
    found = []
    for file in sorted(
        folder().glob("*.json"), key=lambda path: path.stat().st_mtime, reverse=True
    ):
        place = _read(file)
        if place is None or not _lives(place.pid):
            file.unlink(missing_ok=True)
        else:
            found.append(place)
    return tuple(found)


def find(site: str = "") -> MeetingPlace:
    """Return the youngest run, of one site or of any; raises LinkError that says what to do."""
    places = running()
    for place in places:
        if not site or place.site.lower() == site.lower():
            return place
    others = f"; running: {', '.join(place.site for place in places)}" if places else ""
    which = f" called {site!r}" if site else ""
    raise LinkError(
        f"no room{which} is running here{others}: start one with `housefly demo` or `housefly run`"
    )


def folder() -> Path:
    """Return the folder of the meeting places; made when there is none, and nobody else may look
    into it.
    """
    base = (
        os.environ.get("XDG_RUNTIME_DIR")
        or os.environ.get("XDG_STATE_HOME")
        or str(Path.home() / ".local" / "state")
    )
    path = Path(base) / "housefly" / "running"
    path.mkdir(parents=True, exist_ok=True, mode=0o700)
    return path


def _read(file: Path) -> MeetingPlace | None:
    try:
        tree = json.loads(file.read_text(encoding="utf-8"))
        return MeetingPlace(
            str(tree["site"]),
            str(tree["address"]),
            str(tree["key"]),
            int(tree["pid"]),
            int(tree.get("port", 0)),
        )
    except (OSError, ValueError, KeyError, TypeError):
        return None


def _lives(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        return True
    return True
