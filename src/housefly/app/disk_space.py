"""Room on the disks that a run writes to: with too little of it nothing takes off.

A flight that goes on is not touched: recording and memory say what they lack.
"""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable, Iterable
from contextlib import suppress
from pathlib import Path
from typing import Any

from housefly.app.stand_down import RISING_ORDERS
from housefly.config.site import Site
from housefly.config.state import database_file
from housefly.errors import HouseflyError
from housefly.messages import Event, Order, Severity
from housefly.messages.preflight import PreflightCheck

FREE_SHARE_MIN = 0.07
"""With a smaller share of a disk free nothing takes off."""
FREE_ENOUGH_GB = 10
"""So much room is enough on a disk of any size [1e9 bytes]; a flight takes some 10 MB a minute."""
DISK_LOOK_PERIOD = 2.0
"""How often to look [s]."""
_FAULT = "a disk is nearly full"
_MEND = "delete old flights, or move them to another disk"


class DiskSpace:
    """Looks how much room is left.

    Args:
        folders: on the disks that count; one that does not exist yet counts as its parent.
        usage: total and free bytes of a folder's disk.

    Attributes:
        shortage: what is too full, in words, or "".
    """

    def __init__(
        self, folders: Iterable[Path], usage: Callable[[Path], Any] = shutil.disk_usage
    ) -> None:
        self.shortage = ""
        self._folders, self._usage = tuple(folders), usage
        self._fullest = "unknown"

    def look(self) -> None:
        """Look again; blocks for as long as a disk does."""
        shares: dict[Path, float] = {}
        short: dict[Path, float] = {}
        for folder in self._folders:
            with suppress(OSError):
                found = self._usage(_existing(folder))
                shares[folder] = share = found.free / max(found.total, 1)
                if share < FREE_SHARE_MIN and found.free < FREE_ENOUGH_GB * 1e9:
                    short[folder] = share
        self._fullest = _words(shares) if shares else "unknown"
        self.shortage = _words(short) if short else ""

    def check(self) -> PreflightCheck:
        """Return the line of the pre-flight list."""
        return PreflightCheck(
            code="disk_space",
            title="there is room on the disk",
            fault=_FAULT,
            passed=not self.shortage,
            required=True,
            value=self.shortage or self._fullest,
            limit=f"at least {FREE_SHARE_MIN:.0%} free, or {FREE_ENOUGH_GB} GB",
            why="what happens in the flight could not be kept",
            mend=_MEND,
        )

    def allowed(
        self, orders: tuple[Order, ...], now: float
    ) -> tuple[tuple[Order, ...], tuple[Event, ...]]:
        """Return the orders without those that take off where there is no room, and the words."""
        refused = [order for order in orders if self.shortage and order.kind in RISING_ORDERS]
        told = (
            Event(
                now,
                Severity.WARNING,
                "order_refused",
                f"{order.kind.value.replace('_', ' ')} refused: {_FAULT}: {self.shortage}, must be"
                f" {self.check().limit}; {_MEND}",
            )
            for order in refused
        )
        return tuple(order for order in orders if order not in refused), tuple(told)


def disks_of(site: Site) -> DiskSpace:
    """Return the disks that a run of a site writes to: memory, logs, flights."""
    folders = [Path(tempfile.gettempdir()), Path.cwd()]
    with suppress(HouseflyError):
        folders += [database_file(site).parent] if site.hub.enabled else []
    return DiskSpace(folders)


def _existing(folder: Path) -> Path:
    return next((path for path in (folder, *folder.parents) if path.exists()), folder)


def _words(shares: dict[Path, float]) -> str:
    folder = min(shares, key=lambda path: shares[path])
    return f"{shares[folder]:.1%} free at {folder}"
