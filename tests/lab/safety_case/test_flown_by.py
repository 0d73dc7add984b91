"""The flights of a folder are of one source, which is written down before the first one."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from housefly.errors import ConfigError, RecordingError
from housefly.lab.safety_case import flown_by
from housefly.lab.safety_case.flown_by import (
    FLOWN_BY_FILE,
    FlownBy,
    claim_folder,
    flown_by_words,
    read_flown_by,
)

OLD, NEW = "0123456789ab", "fedcba987654"


def is_source(monkeypatch: pytest.MonkeyPatch, digest: str) -> None:
    monkeypatch.setattr(flown_by, "source_digest", lambda: digest)


def test_a_folder_without_flights_belongs_to_whoever_flies_first(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "case"
    for digest in (OLD, NEW):
        is_source(monkeypatch, digest)
        claim_folder(folder, has_flights=False)
        found = read_flown_by(folder)
        assert found is not None and found.source == digest
        assert re.fullmatch(r"\d{4}-\d\d-\d\d \d\d:\d\d", found.since)


def test_the_same_source_flies_on_and_keeps_the_day_on_which_it_began(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    is_source(monkeypatch, OLD)
    kept = f'{{"source": "{OLD}", "since": "2026-11-25 10:00"}}'
    (tmp_path / FLOWN_BY_FILE).write_text(kept)
    claim_folder(tmp_path, has_flights=True)
    assert read_flown_by(tmp_path) == FlownBy(OLD, "2026-11-25 10:00")
    assert flown_by_words(tmp_path) == f"source {OLD} since 2026-11-25 10:00"


def test_flights_of_another_source_are_told_with_both_and_what_to_do(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    is_source(monkeypatch, OLD)
    claim_folder(tmp_path, has_flights=False)
    before = (tmp_path / FLOWN_BY_FILE).read_bytes()
    is_source(monkeypatch, NEW)
    with pytest.raises(ConfigError, match=f"--out.*{OLD} since.*{NEW}.*remove.*--seeds 0"):
        claim_folder(tmp_path, has_flights=True)
    assert (tmp_path / FLOWN_BY_FILE).read_bytes() == before
    assert re.fullmatch(f"source {OLD} since .*; now it is {NEW}", flown_by_words(tmp_path))


def test_flights_of_which_nothing_is_known_are_refused_too(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match="not known"):
        claim_folder(tmp_path, has_flights=True)
    assert not (tmp_path / FLOWN_BY_FILE).exists()
    assert "not known" in flown_by_words(tmp_path)


@pytest.mark.parametrize(
    "damaged",
    [b"", b"\xff\xfe", b"[" * 100_000, b"5", b"{}", b'{"source": "<b>", "since": "x"}'],
)
def test_a_damaged_file_is_told_by_its_name(damaged: bytes, tmp_path: Path) -> None:
    (tmp_path / FLOWN_BY_FILE).write_bytes(damaged)
    with pytest.raises(RecordingError, match=FLOWN_BY_FILE):
        read_flown_by(tmp_path)
