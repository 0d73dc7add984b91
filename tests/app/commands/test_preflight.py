"""``housefly preflight``: its list; ``--frames`` over real wires, where somebody presses Enter."""

from __future__ import annotations

import asyncio
import os
import signal
import sys
from asyncio.subprocess import DEVNULL
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from math import pi
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from frame_check_run import FrameCheckRun

from housefly.app.frame_check.run import run_frame_check
from housefly.bus.endpoint import endpoint_in
from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.cli import main
from housefly.config.frame_check import frames_known, read_frame_check
from housefly.errors import LinkError
from housefly.hub.api.pilot_queries import PreflightView
from housefly.hub.api.pilot_queries_json import to_json
from housefly.hub.client.discovery import RoomAddress, announced
from housefly.lab.frames.plan import STEPS, carry_plan
from housefly.messages.preflight import FrameCheckState, PreflightCheck
from housefly.sites.loaded_site import load_site, read_site
from housefly.twin.hands import CarryOrder
from housefly.twin.hands_link import send_carry

TOPICS = DroneTopics()

SITE = """
name = "frames"
[drone]
address = "{address}"
has_video = false
[tracking]
kind = "{kind}"
address = "{address}"
[hub]
store = "{folder}/room.db"
[twin]
enabled = {twin}
video = false
"""
WriteFrameSite = Callable[..., Path]


@pytest.fixture
def write(tmp_path: Path, loopback: str) -> WriteFrameSite:
    """Return a function that writes a site, simulated or not, at an address of its own."""

    def written(name: str, *, twin: bool, kind: str = "vrpn", more: str = "") -> Path:
        file = tmp_path / f"{name}.toml"
        flag = "true" if twin else "false"
        text = SITE.format(address=loopback, folder=tmp_path, kind=kind, twin=flag)
        file.write_text(text + more)
        return file

    return written


@asynccontextmanager
async def room_and_drone(site: Path, hands: Path) -> AsyncIterator[None]:
    """Run a simulated room that stands for a real one; its drone is carried by ``hands``."""
    process = await asyncio.create_subprocess_exec(
        *(sys.executable, "-m", "housefly.twin.process", "--site", str(site)),
        *("--hands", str(hands)),
        stdout=DEVNULL,
    )
    try:
        while not hands.exists():
            assert process.returncode is None
            await asyncio.sleep(0.05)
        yield
    finally:
        process.terminate()
        await process.wait()


@pytest.mark.wire
@pytest.mark.realtime
@pytest.mark.interop
@pytest.mark.slow
@pytest.mark.timeout(400)
async def test_a_person_finds_that_the_body_is_defined_turned_and_it_is_kept(
    write: WriteFrameSite, tmp_path: Path
) -> None:
    fault = '[[faults]]\nfault = "mocap.yaw:wrong@0s=-2.2"\n'
    site, hands = write("real", twin=False), tmp_path / "hands"
    plan = carry_plan(load_site("bsen").room)

    async def carry(number: int) -> None:
        step = STEPS[number - 1]
        x, y, z = plan.place(step)
        send_carry(hands, CarryOrder((x, y, z + 0.05), plan.nose(step), 1.2))
        await asyncio.sleep(2.8)

    async with (
        room_and_drone(write("room", twin=True, more=fault), hands),
        FrameCheckRun(site) as run,
    ):
        assert frames_known(read_site(str(site))).state is FrameCheckState.NEVER
        assert await run.follow(carry) == 1, run.text
    assert "wrong body yaw" in run.text
    assert "FRAMES WRONG" in run.text
    assert "the drone: turned" in run.text
    told = next(line for line in run.told if line.startswith("  body_yaw = "))
    assert float(told.partition("=")[2]) == pytest.approx(2.2, abs=0.1)
    known = frames_known(read_site(str(site)))
    assert known.state is FrameCheckState.WRONG and "body yaw" in known.words
    site.write_text(site.read_text().replace("[hub]", f"{told.strip()}\n[hub]"))
    assert frames_known(read_site(str(site))).state is FrameCheckState.STALE


@pytest.mark.safety
@pytest.mark.wire
@pytest.mark.realtime
@pytest.mark.timeout(400)
@pytest.mark.parametrize("kind", ["natnet", "vicon", "vrpn"])
async def test_what_is_told_mends_it_with_simulated_hands(write: WriteFrameSite, kind: str) -> None:
    faults = ("--fault", "mocap.map_yaw:wrong@0s=1.57", "--fault", "mocap.origin_z:wrong@0s=0.6")
    site = write("mylab", twin=True, kind=kind)
    async with FrameCheckRun(site, *faults) as run:
        assert await run.follow() == 1
    start = run.told.index("  [tracking]") + 1
    lines = [line.strip() for line in run.told[start : start + 4]]
    assert [line.split(" = ")[0] for line in lines] == ["yaw", "x", "y", "z"]
    assert float(lines[0].partition("=")[2]) == pytest.approx(-pi / 2, abs=1e-3)
    site.write_text(site.read_text().replace("[hub]", "\n".join((*lines, "[hub]"))))
    async with FrameCheckRun(site, *faults) as run:
        assert await run.follow() == 0, run.text
    assert "FRAMES RIGHT" in run.text


@pytest.mark.safety
@pytest.mark.wire
@pytest.mark.realtime
@pytest.mark.timeout(400)
@pytest.mark.parametrize(
    ("fault", "words"),
    [
        ("mocap.map:wrong@0s", "Places and headings are mirrored: y runs the wrong way"),
        ("mocap.axes:wrong@0s", "Places are mirrored, headings are not: y runs the wrong way"),
        ("mocap.latency:wrong@0s=0.4", "wrong late tracking"),
        ("mocap.origin_x:wrong@0s=0.8", "wrong origin"),
        ("mocap:stuck@0s", "wrong no movement"),
    ],
)
async def test_each_lie_of_tracking_is_found_on_wires(write: WriteFrameSite, fault, words) -> None:
    async with FrameCheckRun(write("mylab", twin=True), "--fault", fault) as run:
        assert await run.follow() == 1
    assert words in run.text


@pytest.mark.wire
@pytest.mark.realtime
@pytest.mark.interop
@pytest.mark.slow
@pytest.mark.timeout(400)
async def test_who_gives_up_half_way_keeps_nothing(write: WriteFrameSite) -> None:
    site = write("mylab", twin=True)
    async with FrameCheckRun(site) as run:
        while not (await run.line()).startswith("1/6"):
            pass
        run.press_enter()
        while not (await run.line()).startswith("2/6"):
            pass
        run.process.send_signal(signal.SIGINT)
        assert await run.process.wait() == 130
        while await run.line():
            pass
    assert "given up: nothing is kept; put the drone down" in run.text
    assert "Traceback" not in run.text
    assert read_frame_check(read_site(str(site))) is None


@pytest.mark.wire
@pytest.mark.realtime
@pytest.mark.slow
@pytest.mark.timeout(400)
async def test_an_input_that_ends_is_told_and_keeps_nothing(write: WriteFrameSite) -> None:
    site = write("mylab", twin=True)
    async with FrameCheckRun(site, stdin=DEVNULL) as run:
        while await run.line():
            pass
        assert await run.process.wait() == 2
    assert "the input ended before the last step: nothing is kept" in run.text
    assert read_frame_check(read_site(str(site))) is None


def test_nobody_carries_a_drone_that_a_run_may_start(
    write: WriteFrameSite, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    loaded = load_site(str(write("real", twin=False)))
    there = RoomAddress("frames", "http://127.0.0.1:1", "key", os.getpid())
    with announced(there), pytest.raises(LinkError, match="end it first"):
        run_frame_check(loaded)


def test_the_help_teaches_how(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["preflight", "--help"])
    text = capsys.readouterr().out
    for words in ("1 m along its nose", "no pilot", "mocap.map:wrong", "tape measure"):
        assert words in text


FINE = PreflightCheck(
    *("battery", "battery", "battery low", True, True, "87 %", "40 % or more", "falls", "charge it")
)
FRAMES = PreflightCheck(
    *("frames", "frames", "frames never checked", False, False, "of [Drone]", "checked once"),
    *("it may fly away", "put yaw into [tracking]"),
)
TRACKING = PreflightCheck(
    *("tracking", "tracking", "tracking silent", False, True, "0 Hz [/x]", "20 Hz", "lost", "on"),
)


@pytest.mark.wire
@pytest.mark.parametrize(
    ("view", "code", "lines"),
    [
        (
            PreflightView(True, (FINE, FRAMES)),
            0,
            [
                "ok    battery: 87 %  (40 % or more)",
                "look  frames never checked: of [Drone]  (checked once)",
                "        it may fly away",
                "        -> put yaw into [tracking]",
                "READY",
            ],
        ),
        (
            PreflightView(False, (FINE, TRACKING)),
            1,
            [
                "ok    battery: 87 %  (40 % or more)",
                "no    tracking silent: 0 Hz [/x]  (20 Hz)",
                "        lost",
                "        -> on",
                "NOT READY",
            ],
        ),
        (PreflightView(), 2, []),
    ],
)
def test_the_list_of_a_house_that_runs_is_printed_and_says_whether_it_may_take_off(
    view: PreflightView,
    code: int,
    lines: list[str],
    write: WriteFrameSite,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    site = write("mylab", twin=True)
    with TemporaryDirectory() as folder:
        monkeypatch.setenv("XDG_RUNTIME_DIR", folder)
        bus = endpoint_in(Path(folder))
        there = RoomAddress("frames", "http://127.0.0.1:1", "key", os.getpid(), bus=bus)
        with ZenohBus(listen=bus) as pilot, announced(there):
            pilot.answer(TOPICS.preflight, lambda _: to_json(view))
            assert main(["preflight", "--site", str(site)]) == code
    assert capsys.readouterr().out.splitlines() == lines
