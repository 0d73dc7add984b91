"""Flights with faults, through the command line and in a program; scored on the truth."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from quick_flights import QUICK

from housefly.app.flight import fly_service
from housefly.app.people_note import UNSEEN_PEOPLE
from housefly.cli import main
from housefly.errors import ConfigError
from housefly.lab.lockstep.service import fly_lockstep
from housefly.lab.lockstep.simulation import Simulation
from housefly.messages import Order, OrderKind
from housefly.record.truth import read_truth
from housefly.sites.loaded_site import load_site
from housefly.twin.faults.fault import Fault
from housefly.twin.faults.vocabulary import FaultComponent, FaultKind
from housefly.twin.movable import Movable
from housefly.twin.world import SimulatedWorld

CHAIR = Movable("chair", 0.25, 1.5)
SERVICE = Order(OrderKind.SERVICE, place="table", look_s=0.5)


def put_chair_on_the_drone(world: SimulatedWorld) -> None:
    """Make a contact that no pilot can avoid."""
    x, y, z = world.truth().pose.position
    if z > 0.8 and not world.contact_log:
        world.put(CHAIR.name, (x + 0.3, y))


@pytest.mark.slow
def test_a_service_in_which_something_was_touched_is_not_completed(tmp_path: Path) -> None:
    truth_file = tmp_path / "truth.jsonl"
    outcome = fly_lockstep(
        load_site("bsen", **QUICK), SERVICE, lambda step: None, movables=(CHAIR,),
        on_world=put_chair_on_the_drone, truth_file=truth_file, give_up_after=40.0,
    )  # fmt: skip
    assert outcome != "completed"
    assert "with contact: chair" in outcome
    truth = read_truth(truth_file)
    assert truth is not None
    assert truth.contacts[0].name == "chair" and truth.solid.min() == 0.0


@pytest.mark.slow
@pytest.mark.usefixtures("no_report")
def test_a_fault_of_the_command_line_happens_is_printed_and_recorded(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    fault, site = "commands:off@6s", tmp_path / "quick.toml"
    site.write_text("[control]\nrate_hz = 50\n[twin]\nmocap_rate_hz = 25\n")
    arguments = ["fly", "table", "--headless", "--lockstep", "--look", "0", "--site", str(site)]
    assert main([*arguments, "--out", str(tmp_path), "--fault", fault]) == 1
    summary = json.loads((tmp_path / "summary.json").read_text())
    assert summary["outcome"] != "completed"
    assert summary["faults"] == [fault]
    assert summary["contacts"] == []
    assert summary["min_clearance_m"] > 0.0
    assert json.loads((tmp_path / "site.json").read_text())["faults"] == [{"fault": fault}]
    printed = capsys.readouterr().out
    assert "contacts" in printed and "made to fail" in printed and fault in printed
    assert 0 <= printed.find(UNSEEN_PEOPLE) < printed.find("contacts"), "said before it flies"


@pytest.mark.parametrize(
    ("fault", "words"),
    [("cat:off", "is no component"), ("F27@2s", "covered by"), ("video:off", "only in wires")],
)
def test_a_fault_that_cannot_be_is_refused_before_anything_flies(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], fault: str, words: str
) -> None:
    out = ["--out", str(tmp_path / "never")]
    assert main(["fly", "table", "--headless", "--lockstep", *out, "--fault", fault]) == 2
    assert words in capsys.readouterr().err
    assert not (tmp_path / "never").exists()


def test_a_fault_with_real_hardware_is_refused_in_words(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    site = tmp_path / "site.toml"
    site.write_text("[twin]\nenabled = false\n")
    assert main(["fly", "table", "--site", str(site), "--fault", "F13@20s"]) == 2
    assert "simulated room only" in capsys.readouterr().err


def test_a_fault_that_needs_lock_step_is_refused_over_wires(tmp_path: Path) -> None:
    loaded = load_site("bsen", faults=[{"fault": "pilot:off"}])
    with pytest.raises(ConfigError, match="only in lock step"):
        fly_service(loaded, "table", 0.0, tmp_path, lockstep=False, web=False)


def test_faults_are_injected_into_a_simulation_as_text_or_as_values() -> None:
    simulation = Simulation(load_site("bsen"))
    simulation.inject("mocap:off@0.5s+0.5s", Fault(FaultComponent.TELEMETRY, FaultKind.OFF, "", 1))
    seen, reported = [], []
    for _ in range(150):
        simulation.advance()
        inputs = simulation.inputs()
        seen += [sighting.captured_at for sighting in inputs.sightings]
        reported.append(inputs.telemetry and inputs.telemetry.received_at)
        simulation.step(inputs)
    assert [at for at in seen if 0.5 <= at < 1.0] == []
    assert len(seen) > 90
    assert max(at for at in reported if at is not None) <= 1.0
