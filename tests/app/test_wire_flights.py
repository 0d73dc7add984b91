"""Whole services over real sockets: launcher, pilot and twin processes, bus, recorder."""

import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import av
import pytest
from tello_ports import tello_ports

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow]


def start(site: Path, out: Path, *arguments: str) -> subprocess.Popen[str]:
    command = [
        sys.executable,
        "-m",
        "housefly.cli",
        "fly",
        *arguments,
        "--headless",
        "--site",
        str(site),
        "--out",
        str(out),
    ]
    return subprocess.Popen(
        [*command, "--look", "2"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )


def summary_of(out: Path) -> dict[str, Any]:
    summary: dict[str, Any] = json.loads((out / "summary.json").read_text())
    return summary


def stalled(out: Path) -> float:
    """Return how long the twin stood still for want of processor time [s], by its own log."""
    found = re.findall(r"([0-9.]+) s lost to stalls", (out / "logs" / "twin.log").read_text())
    return float(found[-1]) if found else 0.0


def assert_flown(
    flight: subprocess.Popen[str], again: Callable[[], subprocess.Popen[str]], out: Path
) -> None:
    """Wait for a flight to succeed; one with a stalled twin is flown once more."""
    output = flight.communicate(timeout=300)[0]
    if flight.returncode != 0 and stalled(out) > 0.5:
        flight = again()
        output = flight.communicate(timeout=300)[0]
    assert flight.returncode == 0, output


def assert_completed(out: Path) -> dict[str, Any]:
    summary = summary_of(out)
    assert summary["outcome"] == "completed"
    assert summary["arrival_error_m"] < 0.3
    assert summary["min_clearance_m"] > 0.0
    return summary


def assert_replays(out: Path) -> None:
    replayed = subprocess.run(
        [sys.executable, "-m", "housefly.cli", "replay", str(out)],
        capture_output=True,
        text=True,
        check=False,
    )
    if summary_of(out)["missing_steps"]:  # a starved recorder lost some: then it has to say so
        assert replayed.returncode == 1 and "steps are missing" in replayed.stdout
        return
    assert replayed.returncode == 0, replayed.stdout


@pytest.mark.timeout(600)
def test_the_service_is_completed_over_real_wires_filmed_and_replays_bit_for_bit(
    tmp_path: Path, write_site: Any
) -> None:
    site, out = write_site(rate=100, video=True), tmp_path / "out"
    assert_flown(start(site, out, "entrance"), partial(start, site, out, "entrance"), out)
    assert assert_completed(out)["video_frames"] > 300
    with av.open(str(out / "video.mp4")) as movie:
        frames = [frame for _, frame in zip(range(60), movie.decode(video=0), strict=False)]
    assert len(frames) == 60
    assert (frames[0].width, frames[0].height) == (640, 360)
    assert_replays(out)


@pytest.mark.interop
@pytest.mark.timeout(600)
def test_a_tello_completes_the_service_over_its_own_wires_filmed(
    tmp_path: Path, write_site: Any
) -> None:
    site, out = write_site(rate=100, video=True, kind="tello"), tmp_path / "out"
    with tello_ports():
        assert_flown(start(site, out, "entrance"), partial(start, site, out, "entrance"), out)
    assert assert_completed(out)["video_frames"] > 100
    with av.open(str(out / "video.mp4")) as movie:
        frame = next(movie.decode(video=0))
    assert (frame.width, frame.height) == (960, 720)


@pytest.mark.interop
@pytest.mark.timeout(600)
def test_the_service_is_completed_over_real_wires_at_30_and_10_hz(
    tmp_path: Path, write_site: Any
) -> None:
    sites = {rate: write_site(rate=rate, video=False) for rate in (30, 10)}
    flights = {rate: start(site, tmp_path / str(rate), "entrance") for rate, site in sites.items()}
    for rate, flight in flights.items():
        out = tmp_path / str(rate)
        assert_flown(flight, partial(start, sites[rate], out, "entrance"), out)
        assert_completed(out)
    assert_replays(tmp_path / "30")


@pytest.mark.interop
@pytest.mark.timeout(300)
@pytest.mark.parametrize("tracking", ["natnet", "vrpn"])
def test_the_drone_flies_by_other_tracking_systems(
    tmp_path: Path, write_site: Any, tracking: str
) -> None:
    out = tmp_path / "out"
    site = write_site(tracking=tracking)
    assert_flown(start(site, out, "sofa"), partial(start, site, out, "sofa"), out)
    assert_completed(out)


@pytest.mark.interop
@pytest.mark.timeout(600)
@pytest.mark.parametrize("kind", ["arducopter", "px4"])
def test_an_autopilot_completes_the_service_over_mavlink(
    tmp_path: Path, write_site: Any, kind: str
) -> None:
    site, out = write_site(rate=100, video=False, kind=kind), tmp_path / "out"
    assert_flown(start(site, out, "entrance"), partial(start, site, out, "entrance"), out)
    assert_completed(out)


@pytest.mark.interop
@pytest.mark.timeout(600)
def test_a_crazyflie_completes_the_service_over_its_wire_by_full_states(
    tmp_path: Path, write_site: Any
) -> None:
    site, out = write_site(rate=100, video=False, kind="crazyflie"), tmp_path / "out"
    chosen = '[drone]\nsteered_by = "trajectory"\n'
    site.write_text(site.read_text().replace("[drone]\n", chosen))
    assert_flown(start(site, out, "entrance"), partial(start, site, out, "entrance"), out)
    assert_completed(out)


@pytest.mark.interop
@pytest.mark.timeout(600)
def test_a_betaflight_completes_the_service_over_msp(tmp_path: Path, write_site: Any) -> None:
    site, out = write_site(rate=100, video=False, kind="betaflight"), tmp_path / "out"
    assert_flown(start(site, out, "entrance"), partial(start, site, out, "entrance"), out)
    assert_completed(out)


@pytest.mark.timeout(300)
def test_ctrl_c_in_flight_lands_first(tmp_path: Path, write_site: Any) -> None:
    flight = start(write_site(), tmp_path / "out", "entrance")
    assert flight.stdout is not None
    assert any("in the air" in line for line in flight.stdout), "it never took off"
    time.sleep(3.0)
    os.kill(flight.pid, signal.SIGINT)
    flight.communicate(timeout=120)
    summary = summary_of(tmp_path / "out")
    assert flight.returncode == 1
    assert summary["outcome"] == "interrupted"
    assert summary["path_length_m"] > 0
    assert any("land" in json.dumps(event).lower() for event in summary["events"])


@pytest.mark.interop
@pytest.mark.timeout(300)
def test_the_imported_aws_house_flies(tmp_path: Path, write_site: Any, shared_data: Path) -> None:
    house, out = tmp_path / "house", tmp_path / "out"
    map_file = str(shared_data / "rooms" / "small_house" / "map.yaml")
    subprocess.run(
        [sys.executable, "-m", "housefly.cli", "room", "import", map_file, "--out", str(house)],
        check=True,
    )
    site = write_site(model=str(house))
    assert_flown(start(site, out, "far"), partial(start, site, out, "far"), out)
    assert summary_of(out)["outcome"] == "completed"
