"""``housefly identify``: whole flights with hidden constants, refits, refusals and faults."""

from __future__ import annotations

import signal
import subprocess
import sys
from collections.abc import Callable
from math import inf
from pathlib import Path
from typing import Any

import pytest
from gate_bench import blind
from quick_flights import QUICK

from housefly.app.commands.identify import refuse_without_tilt
from housefly.app.identification_flight import IdentificationFlight, fly_identification_lockstep
from housefly.cli import main
from housefly.config.profile import Interval, load_profile, write_profile
from housefly.config.site import Site, changed, site_from_file
from housefly.errors import ConfigError
from housefly.lab.identification.box import Box, find_box
from housefly.lab.identification.maneuver import IdentificationManeuver
from housefly.lab.identification.pattern import blocks
from housefly.lab.identification.result import Limits, fit_constants
from housefly.lab.identification.samples import samples_of
from housefly.messages import Action, DroneStatus, Phase, PilotStep
from housefly.pilot import assembly
from housefly.pilot.safety.gate import Gate
from housefly.pilot.safety.limits import CommandLimits
from housefly.pilot.site_parameters import pilot_parameters
from housefly.pilot.step import PilotParameters
from housefly.sites.loaded_site import LoadedSite, open_site, read_site
from housefly.twin.world import SimulatedWorld

LIMITS = Limits(0.21, 0.7, 1.75)
IDENTIFY = [sys.executable, "-m", "housefly.cli", "identify"]


def flight(
    believed: LoadedSite, real: LoadedSite, repeats: int = 4
) -> tuple[str, list[PilotStep], IdentificationManeuver, Box]:
    plan = blocks(repeats, believed.site.limits.tilt_max)
    box = find_box(believed.grid, believed.room.home, 0.62, believed.site.map.flight_height)
    maneuver, steps = IdentificationManeuver(plan, box), []
    outcome = fly_identification_lockstep(
        believed,
        SimulatedWorld(real.site, real.room),
        IdentificationFlight(box, maneuver, 400.0),
        steps.append,
    )
    return outcome, steps, maneuver, box


@pytest.mark.slow
def test_a_drone_that_hovers_in_the_box_but_not_in_its_middle_goes_there_first() -> None:
    loaded = open_site(read_site("bsen", **QUICK))
    x, y = loaded.room.home
    box = Box((x - 0.4, y + 0.3), reach=0.62, height=loaded.site.map.flight_height)
    maneuver = IdentificationManeuver(blocks(4, loaded.site.limits.tilt_max)[:2], box)
    world, steps = SimulatedWorld(loaded.site, loaded.room), []
    assert (
        fly_identification_lockstep(
            loaded, world, IdentificationFlight(box, maneuver, 60.0), steps.append
        )
        == "completed"
    )
    assert maneuver.done == 2


@pytest.mark.slow
@pytest.mark.interop
@pytest.mark.parametrize("seed", [1, pytest.param(2, marks=pytest.mark.safety)])
def test_what_a_profile_says_of_a_simulated_drone_is_found_in_its_flight(
    seed: int, tmp_path: Path
) -> None:
    truth = {
        "attitude_lag": 5.0 + seed,
        "attitude_gain": 0.9,
        "drag": 0.4,
        "climb_lag": 2.0,
        "yaw_lag": 14.0,
        "command_delay": (0.11, 0.05)[seed - 1],
    }
    exactly = {key: Interval(value, value, value) for key, value in truth.items()}
    write_profile(tmp_path / "drone.toml", exactly, {})
    (tmp_path / "site.toml").write_text('[drone]\nprofile = "drone.toml"\n')
    tracking = {"twin__mocap_rate_hz": 30, "twin__seed": seed, "twin__mocap_dropout": 0.05}
    believed = open_site(read_site("bsen", **tracking))
    real = open_site(read_site(str(tmp_path / "site.toml"), **tracking))
    outcome, steps, maneuver, box = flight(believed, real, repeats=(4, 6)[seed - 1])
    assert outcome == "completed"
    began = maneuver.flown[0].began
    inside = [
        box.holds(step.outputs.estimate.position)
        for step in steps
        if step.outputs.estimate and step.now > began and step.outputs.phase is Phase.HOLDING
    ]
    assert all(inside) and len(inside) > 1000
    found = fit_constants(
        samples_of(steps, tuple(maneuver.flown), believed.site.tracking.body), LIMITS
    )
    assert not found.problems
    for key, value in truth.items():
        # A single flight: the interval, and a tenth more for the few flights that lie outside.
        interval = found.constants[key]
        slack = 0.5 * (interval.high - interval.low)
        assert interval.low - slack <= value <= interval.high + slack, (key, interval)


@pytest.mark.slow
def test_the_command_writes_a_profile_that_a_site_and_the_advisor_read(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out, lab = tmp_path / "flown", tmp_path / "quick.toml"
    lab.write_text("[control]\nrate_hz = 50\n[twin]\nmocap_rate_hz = 30\n")
    line = ["identify", "--lockstep", "--site", str(lab), "--repeats", "5", "--out", str(out)]
    assert main(line) == 0
    constants = load_profile(out / "drone.toml")
    assert constants["attitude_lag"] == pytest.approx(7.0, rel=0.1)
    assert (out / "fit.png").stat().st_size > 50_000
    assert "attitude_gain" in capsys.readouterr().out
    assert main(["identify", "--from", str(out)]) == 0
    assert load_profile(out / "drone.toml") == constants
    site = tmp_path / "lab.toml"
    site.write_text('[drone]\nprofile = "flown/drone.toml"\ndrag = 0.3\n')
    drone = site_from_file(site).drone
    assert (drone.attitude_lag, drone.drag) == (constants["attitude_lag"], 0.3)
    assert main(["gains", "--profile", str(out / "drone.toml")]) == 0
    assert f"lambda {constants['attitude_lag']:.3g} 1/s" in capsys.readouterr().out


@pytest.mark.slow
@pytest.mark.parametrize(
    ("fault", "words"),
    [("mocap", "tracking was lost"), ("stop", "interrupted in the middle of a step")],
)
def test_a_fault_in_the_middle_of_a_step_ends_the_test_and_lands_the_drone(
    fault: str, words: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    loaded = open_site(read_site("bsen", **QUICK))
    outcome, steps, maneuver = broken_flight(loaded, fault, monkeypatch)
    assert words in outcome
    assert (
        steps[-1].inputs.telemetry is not None
        and steps[-1].inputs.telemetry.status is DroneStatus.LANDED
    )
    assert len(maneuver.flown) == 1


def broken_flight(
    loaded: LoadedSite, fault: str, monkeypatch: pytest.MonkeyPatch
) -> tuple[str, list[PilotStep], IdentificationManeuver]:
    from housefly.lab.lockstep.lockstep_room import LockstepRoom
    from housefly.messages import Order, OrderKind

    plan = blocks(4, loaded.site.limits.tilt_max)
    box = find_box(loaded.grid, loaded.room.home, 0.62, loaded.site.map.flight_height)
    maneuver, steps = IdentificationManeuver(plan, box), []
    flight = IdentificationFlight(box, maneuver, 120.0)
    blind = {"since": None}
    sightings, next_order = LockstepRoom.sightings, IdentificationFlight.next_order

    def in_a_step(now: float) -> bool:
        return bool(maneuver.flown) and 0.3 < now - maneuver.flown[0].began < 1.3

    def unseen(room: LockstepRoom) -> tuple[object, ...]:
        seen = sightings(room)
        return () if fault == "mocap" and in_a_step(room.now) else seen

    def stopped(self: IdentificationFlight, step: PilotStep) -> Order | None:
        order = next_order(self, step)
        if fault == "stop" and in_a_step(step.now) and blind["since"] is None:
            blind["since"] = step.now
            return Order(OrderKind.STOP, issued_at=step.now)
        if blind["since"] is not None and step.now - blind["since"] > 1.0 and blind["since"] > 0.0:
            blind["since"] = -1.0
            return Order(OrderKind.RESUME, issued_at=step.now)
        return order

    monkeypatch.setattr(LockstepRoom, "sightings", unseen)
    monkeypatch.setattr(IdentificationFlight, "next_order", stopped)
    outcome = fly_identification_lockstep(
        loaded, SimulatedWorld(loaded.site, loaded.room), flight, steps.append
    )
    return outcome, steps, maneuver


def unlimited(*site: Any) -> PilotParameters:
    return pilot_parameters(*site)._replace(limits=CommandLimits(inf, inf, inf))


@pytest.mark.parametrize(("guarded", "tilt"), [(True, 0.21), (False, 3.0)])
def test_what_a_maneuver_asks_goes_through_the_last_gate(
    guarded: bool, tilt: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    loaded = open_site(read_site("bsen", **QUICK))
    monkeypatch.setattr(
        "housefly.lab.identification.pattern.Block.asked", lambda self, elapsed: 3.0
    )
    if not guarded:
        monkeypatch.setattr(Gate, "assess", lambda self, inputs: blind(inputs))
        monkeypatch.setattr(assembly, "pilot_parameters", unlimited)
    _, steps, _, _ = flight(loaded, loaded, repeats=1)
    flown = [step.outputs.command for step in steps if step.outputs.command.action is Action.FLY]
    assert max(abs(command.setpoint.theta) for command in flown) == pytest.approx(tilt)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--repeats", "2"], "--repeats: is 2; allowed: a number from 4 to 40"),
        (["--box", "0.5"], "--box: is 0.5 m; allowed: from 1."),
        (["--box", "9"], "no free square of 9.0 m anywhere"),
        (["--at", "moon"], "--at: "),
        (["--from", "/nowhere"], "/nowhere"),
    ],
)
def test_bad_options_are_named(
    arguments: list[str], words: str, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    assert main(["identify", "--lockstep", "--out", str(tmp_path / "x"), *arguments]) == 2
    assert words in capsys.readouterr().err


@pytest.mark.parametrize("kind", ["px4", "arducopter", "tello"])
def test_a_drone_that_is_not_steered_by_tilt_is_refused_before_it_flies(kind: str) -> None:
    with pytest.raises(ConfigError, match=f"is {kind}, which is steered by velocity"):
        refuse_without_tilt(changed(Site(), drone__kind=kind).drone)
    refuse_without_tilt(changed(Site(), drone__kind="betaflight").drone)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (
            "[constants]\nattitude_lag = 500.0\n",
            "constants.attitude_lag: is 500.0; allowed: a number from 0.5 to 50 1/s",
        ),
        ("[constants]\nspin = 1.0\n", "constants.spin: is no constant of a drone"),
        ("x = 1\n", "this is no drone profile"),
        ("x = ", "cannot be parsed"),
    ],
)
def test_a_bad_profile_is_named(text: str, words: str, tmp_path: Path) -> None:
    path = tmp_path / "drone.toml"
    path.write_text(text)
    with pytest.raises(ConfigError) as caught:
        load_profile(path)
    assert words in str(caught.value)


@pytest.mark.wire
@pytest.mark.realtime
@pytest.mark.slow
@pytest.mark.interop
@pytest.mark.timeout(240)
def test_it_flies_over_real_wires(tmp_path: Path, write_site: Callable[..., Path]) -> None:
    site = write_site(rate=30.0)
    done = subprocess.run(
        [*IDENTIFY, "--site", str(site), "--out", str(tmp_path / "o"), "--repeats", "4"],
        capture_output=True,
        text=True,
        timeout=230,
        check=False,
    )
    assert "given up" not in done.stdout, done.stdout + done.stderr
    assert done.returncode == 0 or "is known only to" in done.stdout, done.stdout + done.stderr
    assert "attitude_lag" in done.stdout


@pytest.mark.wire
@pytest.mark.realtime
@pytest.mark.slow
@pytest.mark.interop
def test_ctrl_c_lands_the_drone(tmp_path: Path, write_site: Callable[..., Path]) -> None:
    out = tmp_path / "o"
    process = subprocess.Popen(
        [*IDENTIFY, "--site", str(write_site()), "--out", str(out)],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    try:
        process.wait(12.0)
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGINT)
    output, _ = process.communicate(timeout=60)
    assert "given up: interrupted" in " ".join(output.split()), output
    from housefly.record.replay import read_steps

    last = list(read_steps(out))[-1]
    assert last.inputs.telemetry is not None and last.inputs.telemetry.status is DroneStatus.LANDED
