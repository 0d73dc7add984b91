"""A report of any flight: of a recording of ours, and of logs that others wrote."""

from __future__ import annotations

import csv
import shutil
from pathlib import Path

import pytest
from foreign_logs import crazyflie_csv, flight, ulog_bytes, write_bag

from housefly.cli import main

RECORDED = Path(__file__).parents[2] / "record" / "data" / "default"


def test_a_bag_of_others_becomes_a_page_with_its_drawings_and_its_events(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bag = write_bag(tmp_path / "hover.bag", flight())
    assert main(["report", str(bag)]) == 0
    page = (tmp_path / "hover.bag.html").read_text(encoding="utf-8")
    for title in ("The flight", "Position", "Velocity", "Attitude", "Battery", "Events"):
        assert f"<h2>{title}</h2>" in page
    assert "the battery is weak" in page and "/odom" in page and "2023-11-14" in page
    told = capsys.readouterr().out
    assert "this file holds no velocity setpoints" in told and "duration: 2.0 s" in told


def test_what_a_log_lacks_has_no_drawing_and_where_it_is_cut_is_said(tmp_path: Path) -> None:
    pytest.importorskip("pyulog")
    file, out = tmp_path / "cut.ulg", tmp_path / "mine.html"
    whole = ulog_bytes(flight())
    file.write_bytes(whole[: len(whole) // 2 + 1])
    assert main(["report", str(file), "--out", str(out)]) == 0
    page = out.read_text(encoding="utf-8")
    assert "cut off or damaged after" in page and "velocity setpoints" in page
    table = tmp_path / "short.csv"
    lines = crazyflie_csv(flight()).splitlines()
    table.write_text("\n".join(line.rsplit(",", 5)[0] for line in lines))
    assert main(["report", str(table)]) == 0
    page = (tmp_path / "short.csv.html").read_text(encoding="utf-8")
    assert "<h2>Battery</h2>" not in page and "no battery" in page


def test_a_recording_of_ours_gets_the_report_of_its_flight(tmp_path: Path) -> None:
    shutil.copytree(RECORDED, tmp_path / "mine")
    assert main(["report", str(tmp_path / "mine")]) == 0
    page = (tmp_path / "mine" / "report.html").read_text(encoding="utf-8")
    assert "Errand, behavior, safety" in page and "not known: there is no summary.json" in page


def test_a_log_of_others_is_exported_as_a_table_too(tmp_path: Path) -> None:
    bag, table = write_bag(tmp_path / "hover.bag", flight()), tmp_path / "hover.csv"
    assert main(["export", str(table), "--flight", str(bag)]) == 0
    with table.open(encoding="utf-8", newline="") as file:
        told = list(csv.DictReader(file))
    assert [float(row["x_m"]) for row in told] == [row.position[0] for row in flight()]
    assert told[0]["time"].startswith("2023-11-14") and told[0]["cmd_vx_m_s"] == ""


@pytest.mark.parametrize("content", [b"", b"hello", b"a,b\n1,2\n", bytes(100)])
def test_what_is_no_log_is_refused_with_what_is_allowed(
    content: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "log").write_bytes(content)
    assert main(["report", str(tmp_path / "log")]) == 2
    assert "of no known kind; allowed: a recording of Housefly" in capsys.readouterr().err
