"""Room on the disks that a run writes to: with too little of it nothing takes off.

Nor does anything where nothing can be written at all, and flights are remembered or recorded.

A flight that goes on is not touched: recording and memory say what they lack.
"""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Callable, Iterable
from contextlib import suppress
from pathlib import Path
from typing import Any

from housefly.app.refused_orders import RefusedOrder, refuse_rising
from housefly.config.environment import RECORDING_VARIABLE
from housefly.config.site import Site
from housefly.config.state import database_file, tasks_folder
from housefly.errors import HouseflyError
from housefly.messages import Order, OrderOutcome
from housefly.messages.preflight import PreflightCheck
from housefly.messages.words import UNSAID, Words, figure, percentage

FREE_SHARE_MIN = 0.07
"""With a smaller share of a disk free nothing takes off."""
FREE_ENOUGH_GB = 10
"""So much room is enough on a disk of any size [1e9 bytes]; a flight takes some 10 MB a minute."""
DISK_LOOK_PERIOD = 2.0
"""How often to look [s]."""
_FAULT = Words("a disk is nearly full")
_MEND = Words("delete old flights, or move them to another disk")
_LOSS = Words("what happens in the flight could not be kept")
_UNWRITABLE = Words("a disk cannot be written to")
_WRITABLE_MEND = Words("mount the disk for writing again, or let this user write there")


class DiskSpace:
    """Looks how much room is left, and whether anything can be written.

    Args:
        folders: on the disks that count; one that does not exist yet counts as its parent.
        usage: total and free bytes of a folder's disk.
        kept: of these folders those in which a flight is remembered or recorded: a file is
            written there to see whether that can be.

    Attributes:
        shortage: what is too full, in words, or UNSAID.
        refusal: where nothing can be written, in words, or UNSAID.
    """

    def __init__(
        self,
        folders: Iterable[Path],
        usage: Callable[[Path], Any] = shutil.disk_usage,
        kept: Iterable[Path] = (),
    ) -> None:
        self.shortage = self.refusal = UNSAID
        self._kept = tuple(kept)
        self._folders, self._usage = (*folders, *self._kept), usage
        self._fullest = Words("unknown")

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
        self._fullest = _words(shares) if shares else Words("unknown")
        self.shortage = _words(short) if short else UNSAID
        refusals = (why_unwritable(folder) for folder in self._kept)
        self.refusal = next(filter(None, refusals), UNSAID)

    def checks(self) -> tuple[PreflightCheck, ...]:
        """Return the lines of the pre-flight list."""
        return (self._space(), self._writing()) if self._kept else (self._space(),)

    def _space(self) -> PreflightCheck:
        return PreflightCheck(
            code="disk_space",
            title=Words("there is room on the disk"),
            fault=_FAULT,
            passed=not self.shortage,
            required=True,
            value=self.shortage or self._fullest,
            limit=Words(
                "at least {p}% free, or {n} GB",
                p=percentage(FREE_SHARE_MIN),
                n=figure(FREE_ENOUGH_GB),
            ),
            why=_LOSS,
            mend=_MEND,
        )

    def _writing(self) -> PreflightCheck:
        return PreflightCheck(
            code="disk_writable",
            title=Words("the disk can be written to"),
            fault=_UNWRITABLE,
            passed=not self.refusal,
            required=True,
            value=self.refusal or Words("written a moment ago"),
            limit=Words("a file can be written"),
            why=_LOSS,
            mend=_WRITABLE_MEND,
        )

    def _fault(self) -> Words:
        if self.shortage:
            return self._space().refusal
        if not self.refusal:
            return UNSAID
        return Words(
            "{why}: {found}; {mend}", why=_UNWRITABLE, found=self.refusal, mend=_WRITABLE_MEND
        )

    def allowed(
        self, orders: tuple[Order, ...]
    ) -> tuple[tuple[Order, ...], tuple[RefusedOrder, ...]]:
        """Return the orders without those that take off where there is no room, and those."""
        return refuse_rising(orders, OrderOutcome.DISK, self._fault())


def disks_of(site: Site) -> DiskSpace:
    """Return the disks that a run of a site writes to: memory, tasks, logs, flights."""
    kept = [Path(folder)] if (folder := os.environ.get(RECORDING_VARIABLE)) else []
    with suppress(HouseflyError):
        kept += [database_file(site).parent] if site.hub.enabled else []
        kept += [tasks_folder(site)] if site.tasks.enabled else []
    return DiskSpace([Path(tempfile.gettempdir()), Path.cwd()], kept=kept)


def _existing(folder: Path) -> Path:
    return next((path for path in (folder, *folder.parents) if path.exists()), folder)


def _words(shares: dict[Path, float]) -> Words:
    folder = min(shares, key=lambda path: shares[path])
    share = figure(100.0 * shares[folder], ".1f")
    return Words("{p}% free at {name}", p=share, name=str(folder))


def why_unwritable(folder: Path) -> Words:
    """Write a file that never has a name, and return in words why that cannot be, or "".

    A folder that is not there yet will be made in the nearest one that is; one that does not even
    say whether it is there cannot be written.
    """
    place = folder
    try:
        place = _existing(folder)
        with tempfile.TemporaryFile(dir=place) as probe:
            probe.write(b"x")
            probe.flush()
    except OSError as error:
        why = str(error.strerror)
        return Words("nothing can be written at {name} ({why})", name=str(place), why=why)
    return UNSAID
