"""The outcome of a frame check is kept with the site, and holds until [tracking] changes."""

from __future__ import annotations

import tempfile
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.config.frame_check import (
    FrameCheckRecord,
    frame_check_file,
    frames_known,
    read_frame_check,
    tracking_digest,
    write_frame_check,
)
from housefly.config.site import Site, changed, site_from_file
from housefly.errors import ConfigError
from housefly.messages.preflight import FrameCheckState


@pytest.fixture
def site(tmp_path: Path) -> Site:
    return changed(Site(), twin__enabled=False, hub__store=str(tmp_path / "room.db"))


def kept(site: Site, *findings: str) -> None:
    write_frame_check(
        site, FrameCheckRecord("2026-01-02T03:04:05Z", tracking_digest(site.tracking), findings)
    )


def test_never_right_wrong_and_stale_are_told_apart(site: Site) -> None:
    assert frames_known(site).state is FrameCheckState.NEVER
    kept(site, "mirrored axes: y runs the wrong way")
    assert frames_known(site).state is FrameCheckState.WRONG
    assert "y runs" in frames_known(site).words
    kept(site)
    assert frames_known(site).state is FrameCheckState.RIGHT
    for change in ({"tracking__yaw": 0.1}, {"tracking__body": "x"}, {"tracking__kind": "vrpn"}):
        assert frames_known(changed(site, **change)).state is FrameCheckState.STALE
    assert frames_known(changed(site, limits__speed=0.4)).state is FrameCheckState.RIGHT


def test_the_simulated_room_needs_none(site: Site) -> None:
    twin = changed(site, twin__enabled=True)
    kept(twin, "mirrored")
    assert frames_known(twin).state is FrameCheckState.NOT_NEEDED


def test_the_pilot_that_reads_the_site_as_json_finds_the_same_digest(
    site: Site, tmp_path: Path
) -> None:
    site = changed(site, tracking__yaw=-0.7001, tracking__x=1.676)
    file = tmp_path / "site.json"
    file.write_text(site.model_dump_json())
    kept(site)
    assert frames_known(site_from_file(file)).state is FrameCheckState.RIGHT


def test_sites_with_stores_of_their_own_have_checks_of_their_own(site: Site) -> None:
    other = changed(site, hub__store=site.hub.store.replace("room.db", "lab.db"))
    assert frame_check_file(site) != frame_check_file(other)
    assert frame_check_file(site).parent == Path(site.hub.store).parent


@settings(max_examples=40)
@given(st.text(max_size=80), st.lists(st.text(max_size=80), max_size=3), st.floats(-9.0, 9.0))
def test_whatever_words_are_kept_are_read_again(words, findings, value):
    record = FrameCheckRecord(words, "d", tuple(findings), (words,), (("lag_s", value),))
    with tempfile.TemporaryDirectory() as folder:
        site = changed(Site(), hub__store=f"{folder}/room.db")
        write_frame_check(site, record)
        assert read_frame_check(site) == record


@pytest.mark.parametrize("text", ["]", "tracking = 3", "\x00", "measured = 2\ntracking='x'"])
def test_a_damaged_file_counts_as_no_check_and_says_so(site: Site, text: str) -> None:
    frame_check_file(site).write_text(text)
    with pytest.raises(ConfigError):
        read_frame_check(site)
    known = frames_known(site)
    assert known.state is FrameCheckState.NEVER and "frame check" in known.words
