"""What is appended stays whole lines, for this user only, and the disk is asked at its pace."""

from __future__ import annotations

import resource
import stat
from pathlib import Path

import pytest

from housefly.config.durable import SYNC_PERIOD, SyncPace, append_lines


def test_what_was_cut_off_before_tears_no_line_that_comes_after(tmp_path: Path) -> None:
    file = tmp_path / "lines"
    assert append_lines(file, ["one", "two"]) == 8
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    with file.open("a") as torn:
        torn.write("thr")
    append_lines(file, ["four"], sync=False)
    assert file.read_text() == "one\ntwo\nthr\nfour\n"


def test_a_disk_that_fills_up_within_a_line_tears_only_that_one(tmp_path: Path) -> None:
    """A limit on the size of files stands for a full disk: the same call fails."""
    file, limits = tmp_path / "lines", resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, limits[1]))
    try:
        with pytest.raises(OSError, match="too large"):
            append_lines(file, ["x" * 300])
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    append_lines(file, ["whole"])
    assert file.read_text().splitlines() == ["x" * 100, "whole"]


def test_a_link_in_its_place_is_not_followed(tmp_path: Path) -> None:
    (tmp_path / "lines").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(OSError, match="symbolic links"):
        append_lines(tmp_path / "lines", ["one"])
    assert not (tmp_path / "elsewhere").exists()


def test_the_disk_is_asked_once_a_period() -> None:
    now = [5.0]
    pace = SyncPace(lambda: now[0])
    asked = 0
    for _ in range(100):
        now[0] += 0.1
        asked += pace.is_due()
    assert asked == pytest.approx(10.0 / SYNC_PERIOD, abs=4)
