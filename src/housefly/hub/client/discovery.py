"""How a run announces its room to other programs of the same user: a file only they can read."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path

from housefly.config.drone import DRONE_NAME
from housefly.errors import LinkError


@dataclass(frozen=True, slots=True)
class RoomAddress:
    """How to reach the room of one run.

    Attributes:
        site: name of the site.
        address: of its HTTP API, without a path.
        key: bearer token.
        pid: of the launcher.
        socket: path of the hub's query server; "" for none.
        bus: endpoint of the run's bus; "" when it is not told.
        drones: their names; where there is none, the name under which the room answers.
    """

    site: str
    address: str
    key: str
    pid: int
    socket: str = ""
    bus: str = ""
    drones: tuple[str, ...] = (DRONE_NAME,)


@contextmanager
def announced(place: RoomAddress) -> Iterator[None]:
    """Announce a run until the block ends."""
    file = folder() / f"{place.pid}.json"
    # A file that is there already, with whatever mode, belongs to a run that is gone.
    file.unlink(missing_ok=True)
    with os.fdopen(os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w") as entry:
        json.dump(asdict(place), entry)
    try:
        yield
    finally:
        file.unlink(missing_ok=True)


def running() -> tuple[RoomAddress, ...]:
    """Return the runs of this user, the newest first; removes files of runs that are gone."""
    found = []
    for file in sorted(folder().glob("*.json"), key=_written_at, reverse=True):
        place = _read(file)
        if place is None or not is_alive(place.pid):
            file.unlink(missing_ok=True)
        else:
            found.append(place)
    return tuple(found)


def find(site: str = "") -> RoomAddress:
    """Return the newest run, of one site or of any; raises LinkError that says what to do."""
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
    """Return the folder of the announcements; created if missing, readable by this user only."""
    base = (
        os.environ.get("XDG_RUNTIME_DIR")
        or os.environ.get("XDG_STATE_HOME")
        or str(Path.home() / ".local" / "state")
    )
    path = Path(base) / "housefly" / "running"
    path.mkdir(parents=True, exist_ok=True, mode=0o700)
    return path


def _written_at(file: Path) -> float:
    """Return when a file was written; one whose run has just ended is the oldest."""
    try:
        return file.stat().st_mtime
    except OSError:
        return 0.0


def _read(file: Path) -> RoomAddress | None:
    try:
        tree = json.loads(file.read_text(encoding="utf-8"))
        return RoomAddress(
            str(tree["site"]),
            str(tree["address"]),
            str(tree["key"]),
            int(tree["pid"]),
            str(tree.get("socket", "")),
            str(tree.get("bus", "")),
            tuple(str(name) for name in tree.get("drones", ())) or (DRONE_NAME,),
        )
    except (OSError, ValueError, KeyError, TypeError, OverflowError, RecursionError):
        return None


def is_alive(pid: int) -> bool:
    """Return whether a process with this number exists."""
    try:
        os.kill(pid, 0)
    except (ProcessLookupError, OverflowError):
        return False
    except PermissionError:
        return True
    return True
