"""What is remembered as a table, with names or without, and a person deleted."""

from __future__ import annotations

import csv
import json
import time
from pathlib import Path

import pyarrow.parquet as pq
import pytest

from housefly.app.commands.asked_room import asked_site
from housefly.cli import build_parser, main
from housefly.hub.store.lock import reserved_store
from housefly.hub.store.open import open_site_store
from housefly.messages import Observation, RoomEvent

NOW = time.time() // 5.0 * 5.0
"""At the beginning of an interval of ``--every 5``."""


@pytest.fixture(autouse=True)
def _lived(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path / "run"))
    monkeypatch.chdir(tmp_path)
    store = open_site_store(asked_site(build_parser().parse_args(["where", "cup"])))
    facts = (("weight", 0.21), ("words", "=1+1"), ("taken_by", "person-1"))
    events = [
        RoomEvent("object taken", "cup", NOW - 60.0, "cabinet", "person-1", facts=facts),
        RoomEvent("=cmd", "plug", NOW - 50.0, "plug"),
    ]
    seen = [
        Observation("person-1", "floor-1", NOW - at, NOW - at, (1.0 + at, 2.0, 0.0))
        for at in (30.0, 29.9, 20.0)
    ]
    store.write(seen, events)
    store.close()


def rows(file: str) -> list[dict[str, str]]:
    with Path(file).open(encoding="utf-8", newline="") as table:
        return list(csv.DictReader(table))


def test_events_are_written_as_csv_and_as_parquet_with_the_same_rows() -> None:
    assert main(["export", "e.csv"]) == main(["export", "e.parquet"]) == 0
    taken, odd = rows("e.csv")
    assert (taken["name"], taken["cause_name"]) == ("the cup", "the resident")
    assert taken["words"].startswith("the resident took the cup")
    assert float(taken["unix"]) == pytest.approx(NOW - 60.0)
    assert json.loads(taken["facts"])["weight"] == 0.21
    assert odd["kind"] == "'=cmd", "a spreadsheet takes it for a formula"
    assert main(["export", "of.csv", "--thing", "resident"]) == 0
    assert [one["thing"] for one in rows("of.csv")] == ["cup"], "what somebody did is about them"
    table = pq.read_table("e.parquet").to_pylist()
    assert [one["kind"] for one in table] == ["object taken", "=cmd"]
    assert table[0]["facts"] == taken["facts"]


def test_ways_are_thinned_and_no_row_is_an_exit_code(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["export", "w.csv", "--ways", "--thing", "resident", "--every", "5"]) == 0
    assert len(rows("w.csv")) == 2
    assert main(["export", "n.csv", "--since", "1s"]) == 1
    assert main(["export", "x.txt"]) == 2
    assert "ends in .csv or .parquet" in capsys.readouterr().err


def test_pseudonyms_name_nobody_and_are_the_same_in_every_export() -> None:
    for file in ("a.csv", "b.csv"):
        assert main(["export", file, "--pseudonyms", "key.json"]) == 0
        text = Path(file).read_text()
        assert "P01 took the cup" in text and "1+1" not in text
        assert "resident" not in text and "person-1" not in text
    assert Path("a.csv").read_text() == Path("b.csv").read_text()
    assert json.loads(Path("key.json").read_text())["person-1"] == "P01"
    assert Path("key.json").stat().st_mode & 0o077 == 0
    assert main(["export", "w.csv", "--ways", "--pseudonyms", "key.json"]) == 0
    assert {(one["thing"], one["name"]) for one in rows("w.csv")} == {("P01", "P01")}
    Path("key.json").write_text("[1]")
    assert main(["export", "c.csv", "--pseudonyms", "key.json"]) == 2


def test_a_person_is_forgotten_only_on_a_yes_and_while_no_room_runs(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["memory", "forget", "resident"]) == 1
    with reserved_store(asked_site(build_parser().parse_args(["where", "cup"]))):
        assert main(["memory", "forget", "resident", "--yes"]) == 2
    assert main(["memory", "forget", "resident", "--yes"]) == 0
    assert "3 sightings, 1 events" in capsys.readouterr().out
    assert main(["export", "e.csv"]) == 0
    assert [one["thing"] for one in rows("e.csv")] == ["plug"]
    assert main(["memory", "forget", "nobody", "--yes"]) == 2
