"""Every script of the course runs and prints what its docstring promises."""

from __future__ import annotations

import ast
import os
import runpy
import subprocess
import sys
import time
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path
from threading import Thread

import pytest
from served_room import KEY, ServedRoom

from housefly.hub.client.discovery import RoomAddress, announced

pytestmark = [pytest.mark.timeout(300), pytest.mark.usefixtures("no_report")]

FOLDER = Path(__file__).resolve().parents[1] / "examples"
SCRIPTS = sorted(path.name for path in FOLDER.glob("*.py"))


@pytest.fixture(autouse=True)
def own_state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Keep the examples away from the memory of a room that runs meanwhile."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))


def run(name: str, *arguments: str) -> str:
    """Run a script in this process, which has imported and loaded already what each one needs."""
    with redirect_stdout(StringIO()) as said, pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "argv", [name, *arguments])
        runpy.run_path(str(FOLDER / name), run_name="__main__")
    return said.getvalue()


def run_alone(name: str) -> str:
    """Run a script in a process of its own, as somebody types it."""
    line = [sys.executable, str(FOLDER / name)]
    done = subprocess.run(line, capture_output=True, text=True, timeout=280.0, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def assert_in_order(output: str, *words: str) -> None:
    at = 0
    for word in words:
        found = output.find(word, at)
        assert found >= 0, f"{word!r} is missing, or too early, in:\n{output}"
        at = found + len(word)


def test_a_path_is_planned_and_a_bad_goal_is_refused_in_words() -> None:
    output = run_alone("01_plan_a_path.py")
    assert_in_order(
        output,
        "150 x 80 cells",
        "to the entrance:",
        "into the sofa: the goal",
        "nearest place that works: (",
    )


@pytest.mark.slow
def test_the_service_is_flown_in_lock_step() -> None:
    output = run("02_fly_in_lock_step.py")
    assert_in_order(
        output,
        "taking off",
        "flying to goal",
        "looking",
        "returning",
        "landing",
        "idle",
        "completed",
    )


@pytest.mark.interop
@pytest.mark.slow
def test_lost_tracking_means_hover_then_landing() -> None:
    output = run("03_lost_tracking.py")
    assert_in_order(
        output, "hold: hover", "land: land; tracking lost for 2.0 s", "landed", "all is well"
    )


@pytest.mark.wire
@pytest.mark.slow
def test_the_drone_is_driven_over_the_wire(loopback: str) -> None:
    output = run("04_drive_the_drone_yourself.py", loopback)
    assert_in_order(
        output, f"drone at {loopback}", "taking off", "flying", "landing", "0 malformed"
    )


@pytest.mark.interop
@pytest.mark.wire
@pytest.mark.slow
def test_a_listener_hears_steps_and_gets_a_plan(loopback: str) -> None:
    output = run("05_listen_on_the_bus.py", loopback)
    assert_in_order(output, "drones/drone/step", '"path": {"waypoints"', "idle, at (10.5")


@pytest.mark.interop
@pytest.mark.slow
def test_a_recording_is_read_by_the_mcap_library() -> None:
    output = run("06_read_a_recording.py")
    assert_in_order(
        output, "completed; files: flight.mcap", "nav_msgs/msg/OccupancyGrid", "highest point 1."
    )


@pytest.mark.interop
@pytest.mark.slow
def test_a_room_of_ones_own_is_flown_in() -> None:
    output = run("07_your_own_room.py")
    assert_in_order(output, "H home", "and back: completed")


@pytest.mark.slow
def test_a_thousand_drones_are_flown_and_read() -> None:
    output = run("08_fly_a_thousand.py")
    assert_in_order(
        output,
        "20 points x 50 seeds = 1000 drones",
        "1000 rows",
        "mode default",
        "mode paper",
        "cm off the path",
    )


@pytest.mark.slow
@pytest.mark.interop
def test_hidden_constants_are_identified() -> None:
    output = run("09_identify_your_drone.py")
    assert_in_order(
        output,
        "24 blocks were flown",
        "attitude_lag",
        "true 5.5",
        "true 0.08",
        "true 30",
        "each interval holds the simulated value; the profile may be written",
    )


@pytest.mark.slow
@pytest.mark.interop
def test_gains_are_chosen_for_a_slow_tracking_system() -> None:
    output = run("10_choose_gains.py")
    assert_in_order(output, "100 Hz", "30 Hz", "10 Hz", "in mode paper: gain margin", "below 2")


@pytest.mark.wire
def test_a_sensor_of_ones_own_is_heard() -> None:
    output = run("11_add_a_sensor.py")
    assert_in_order(
        output,
        "('illuminance_lx', 320.5)",
        "'malformed': 1",
        "desk-lamp is -7",
        "Light window",
        "nothing lost",
    )


@pytest.mark.wire
@pytest.mark.realtime
@pytest.mark.interop
@pytest.mark.slow
def test_a_drone_of_ones_own_flies_the_service_over_its_own_wire() -> None:
    assert_in_order(
        run_alone("13_add_a_drone.py"),
        "it is steered by position, and told where it is 20/s",
        "it hovers by itself: no; camera: none",
        "taking off",
        "looking",
        "landing",
        "completed: true rms error 0.0",
        "() touched",
        "the same to the last bit",
    )


@pytest.mark.wire
def test_a_running_house_is_awaited(
    loopback: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    room = ServedRoom(loopback, tmp_path)

    def fly() -> None:
        while not room.tasks.tasks:
            time.sleep(0.02)
        room.tasks.finish(1, "Nobody is there.")

    with announced(RoomAddress("B-sen", room.address, KEY, os.getpid())):
        flying = Thread(target=fly)
        flying.start()
        output = run("14_await_the_room.py")
        flying.join()
    room.close()
    assert_in_order(
        output, "now: cup: in the cabinet", "2 things, 4 services", "task 1", "Nobody is there."
    )


@pytest.mark.slow
def test_the_room_is_asked_what_happened_in_it() -> None:
    output = run("12_ask_the_room.py")
    assert_in_order(
        output,
        "now:  the cup: in the cabinet",
        "then: the cup: with the resident",
        "in the cabinet: the cup, the book",
    )
    assert_in_order(
        output,
        "object taken by the resident",
        "object put by the resident",
        "someone at the entrance",
    )


def test_every_script_of_the_course_says_what_it_teaches_and_is_tested_and_listed() -> None:
    contents, tests = (FOLDER / "README.md").read_text(), Path(__file__).read_text()
    assert [name[:2] for name in SCRIPTS] == [
        f"{number:02}" for number in range(1, len(SCRIPTS) + 1)
    ]
    for name in SCRIPTS:
        docstring = ast.get_docstring(ast.parse((FOLDER / name).read_text())) or ""
        for part in ("Needs: ", "Learns: ", "Prints: "):
            assert part in docstring, f"{name}: {part}"
        assert f"]({name})" in contents and f'"{name}"' in tests, name
