"""A recorded flight as CSV and Parquet, read back by what others read with."""

from __future__ import annotations

import csv
import shutil
from math import hypot
from pathlib import Path

import pyarrow.parquet as pq
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.app.flight_tables import TABLE_FORMS, FlightTable
from housefly.cli import main
from housefly.messages import (
    Action,
    Command,
    Inputs,
    Outputs,
    PilotStep,
    PositionSetpoint,
    Setpoint,
    VelocitySetpoint,
)
from housefly.record.replay import read_steps

RECORDED = Path(__file__).parents[1] / "record" / "data" / "default"


def rows(file: Path) -> list[dict[str, str]]:
    with file.open(encoding="utf-8", newline="") as table:
        return list(csv.DictReader(table))


SETPOINTS = st.one_of(
    st.builds(Setpoint, *[st.floats(-1.0, 1.0)] * 4),
    st.builds(VelocitySetpoint, *[st.floats(-1.0, 1.0)] * 4),
    st.builds(PositionSetpoint, *[st.floats(-1.0, 1.0)] * 4),
)


@given(st.lists(SETPOINTS, max_size=5))
def test_each_row_has_a_cell_for_each_column_and_the_numbers_of_its_setpoint(
    asked: list[Setpoint | VelocitySetpoint | PositionSetpoint],
) -> None:
    form = TABLE_FORMS[FlightTable.STEPS]
    forms = {VelocitySetpoint: "velocity", PositionSetpoint: "position", Setpoint: "setpoint"}
    steps = [
        PilotStep(n, float(n), Inputs(), Outputs(Command(Action.FLY, **{forms[type(one)]: one})))
        for n, one in enumerate(asked)
    ]
    told = list(form.rows((1e9 + step.now, step) for step in steps))
    assert len(told) == len(asked)
    for row, one in zip(told, asked, strict=True):
        cells = dict(zip(form.headings, row, strict=True))
        given_ = sorted(getattr(one, name) for name in type(one).__slots__)
        known = [value for name, value in cells.items() if name.startswith("cmd_")]
        assert sorted(value for value in known if value == value) == given_


def test_a_table_has_a_row_for_each_step_and_csv_and_parquet_say_the_same(
    tmp_path: Path,
) -> None:
    steps = tuple(read_steps(RECORDED))
    for name in ("f.csv", "f.parquet"):
        assert main(["export", str(tmp_path / name), "--flight", str(RECORDED)]) == 0
    told, table = rows(tmp_path / "f.csv"), pq.read_table(tmp_path / "f.parquet").to_pylist()
    assert len(told) == len(table) == len(steps)
    for step, row, cells in zip(steps, told, table, strict=True):
        assert int(row["step"]) == cells["step"] == step.sequence
        estimate = step.outputs.estimate
        if estimate is None:
            assert row["x_m"] == "" and cells["x_m"] is None
        else:
            assert float(row["x_m"]) == cells["x_m"] == estimate.position[0]
            assert cells["speed_m_s"] == hypot(*estimate.velocity)
    assert float(told[0]["unix"]) > 1e9 and float(told[0]["t_s"]) == 0.0


def test_sightings_and_events_are_tables_of_their_own(tmp_path: Path) -> None:
    steps = tuple(read_steps(RECORDED))
    for name in ("sightings", "events"):
        command = ["export", str(tmp_path / f"{name}.csv"), "--flight", str(RECORDED)]
        assert main([*command, "--table", name]) == 0
    seen = [one for step in steps for one in step.inputs.sightings]
    told = rows(tmp_path / "sightings.csv")
    assert [row["body"] for row in told] == [one.body for one in seen]
    assert [float(row["x_m"]) for row in told] == [one.pose.position[0] for one in seen]
    codes = [event.code.value for step in steps for event in step.outputs.events]
    assert [row["code"] for row in rows(tmp_path / "events.csv")] == codes


def test_a_folder_that_is_there_is_not_written_over(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bag = tmp_path / "bag"
    bag.mkdir()
    assert main(["export", str(bag), "--flight", str(RECORDED)]) == 2
    assert "cannot be written" in capsys.readouterr().err


def test_a_cut_recording_gives_what_is_there(tmp_path: Path) -> None:
    shutil.copytree(RECORDED, tmp_path / "cut")
    file = tmp_path / "cut" / "flight.mcap"
    file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])
    table = tmp_path / "f.csv"
    assert main(["export", str(table), "--flight", str(tmp_path / "cut")]) == 0
    assert 0 < len(rows(table)) < sum(1 for _ in read_steps(RECORDED))


@pytest.mark.parametrize("argument", [["--ways"], ["--thing", "cup"], ["--kind", "bell pressed"]])
def test_what_is_asked_of_the_memory_is_refused_for_a_flight(
    argument: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    command = ["export", str(tmp_path / "f.csv"), "--flight", str(RECORDED), *argument]
    assert main(command) == 2
    assert argument[0] in capsys.readouterr().err
