"""The bus beside a bare TCP socket, the codec beside pickle, and the flight recorder's cost."""

from __future__ import annotations

import pickle
import socket
import struct
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from fractions import Fraction
from functools import partial
from pathlib import Path as FilePath
from typing import Any

import av
import numpy as np

from _run import percentile, table
from housefly.bus.codec import from_cdr, to_cdr
from housefly.bus.endpoint import endpoint_in
from housefly.bus.stop_sender import StopSender
from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.site import Site
from housefly.messages import (
    Action,
    Behavior,
    Command,
    DroneStatus,
    Estimate,
    Inputs,
    LinkStatus,
    Outputs,
    Path,
    Phase,
    PilotStep,
    Pose,
    Reference,
    Setpoint,
    Sighting,
    Telemetry,
    VideoFrame,
)
from housefly.record.recorder import FlightRecorder
from housefly.room.files import load_room
from housefly.room.grid import build_grid

TOPICS = DroneTopics()

HOST, TCP_PORT = "127.77.0.1", 7448
RATE_HZ, SECONDS = 100.0, 10.0
PATH = Path(tuple((0.3 * n, 0.1 * n) for n in range(30)), 9.5, 0.4)
PICTURE_BYTES = 15_000


def step(number: int, now: float) -> PilotStep:
    """Return a step as large as those in flight."""
    pose = Pose((0.01 * number, 2.0, 1.1), (0.9, 0.0, 0.0, 0.436))
    return PilotStep(
        number,
        now,
        Inputs(
            (
                Sighting("ardrone", pose, now - 0.02, now),
                Sighting("visitor", pose, now - 0.02, now),
            ),
            Telemetry(now, DroneStatus.FLYING, 0.8),
        ),
        Outputs(
            Command(Action.FLY, Setpoint(0.1, 0.02, 0.0, 0.1)),
            Estimate(now, pose.position, (0.5, 0.0, 0.0), 0.9, 0.02, 0.003),
            Reference(pose.position, (0.5, 0.0, 0.0), 0.9),
            Behavior.PATH_TRACKING,
            Phase.OUTBOUND,
            goal_name="entrance",
            path=PATH,
            waypoint=number % 30,
        ),
    )


def listen(endpoint: str) -> None:
    """The other process: measures the age of each step where its handler begins, and reports all
    ages as LINK notes.
    """
    ages: dict[str, list[float]] = {"zenoh": [], "tcp": []}
    with (
        ZenohBus(connect=endpoint) as bus,
        socket.create_connection((HOST, TCP_PORT)) as link,
    ):
        link.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        bus.subscribe(
            TOPICS.step, lambda message: ages["zenoh"].append(time.monotonic() - message.now)
        )
        bus.answer("ready", str)
        stream = link.makefile("rb")
        while head := stream.read(4):
            message = from_cdr(PilotStep, stream.read(struct.unpack("<I", head)[0]))
            ages["tcp"].append(time.monotonic() - message.now)
        print(
            " ".join(map(str, ages["zenoh"])), " ".join(map(str, ages["tcp"])), sep="\n", flush=True
        )


def transports() -> str:
    """Send steps to another process by the bus and by a bare socket in turn."""
    count = int(SECONDS * RATE_HZ)
    with (
        socket.create_server((HOST, TCP_PORT)) as server,
        tempfile.TemporaryDirectory() as folder,
        ZenohBus(listen=endpoint_in(FilePath(folder))) as bus,
    ):
        other = subprocess.Popen(
            [sys.executable, __file__, "listen", endpoint_in(FilePath(folder))],
            stdout=subprocess.PIPE,
            text=True,
        )
        link, _ = server.accept()
        link.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        bus.ask("ready", timeout=10.0)
        for number in range(2 * count):
            time.sleep(0.5 / RATE_HZ)
            if number % 2:
                bus.publish(TOPICS.step, step(number, time.monotonic()))
            else:
                data = to_cdr(step(number, time.monotonic()))
                link.sendall(struct.pack("<I", len(data)) + data)
        time.sleep(0.2)
        link.close()
        output, _ = other.communicate(timeout=20)
    zenoh, tcp = ([1e6 * float(age) for age in line.split()] for line in output.splitlines())
    rows = [
        (
            name,
            f"{len(ages)} of {count}",
            *(f"{percentile(ages, share):.0f}" for share in (0.5, 0.99, 1.0)),
        )
        for name, ages in (("zenoh bus", zenoh), ("bare TCP socket", tcp))
    ]
    ratio = percentile(zenoh, 0.5) / percentile(tcp, 0.5)
    return (
        "### Bus: from publish to handler in another process\n\n"
        + table(("transport", "arrived", "p50 [us]", "p99 [us]", "max [us]"), rows)
        + f"\n\nPilot steps of {len(to_cdr(step(0, 0.0)))} bytes at {RATE_HZ:.0f} Hz over loopback,"
        f" encoding and decoding included, in turn in the same run: the bus takes {ratio:.2f}"
        " times the bare socket at the median.\n"
    )


def cost(work: Callable[[], object], repeats: int = 2000) -> float:
    """Return the time of one call [us], best of five rounds."""
    best = float("inf")
    for _ in range(5):
        started = time.perf_counter()
        for _ in range(repeats):
            work()
        best = min(best, (time.perf_counter() - started) / repeats)
    return 1e6 * best


def codec() -> str:
    """Encode and decode the messages of the bus."""
    samples = (
        step(7, 1.0),
        VideoFrame(bytes(PICTURE_BYTES), True, 640, 360, 1, 1.0),
        LinkStatus(1.0),
    )
    rows = []
    for sample in samples:
        data, pickled = to_cdr(sample), pickle.dumps(sample)
        kind = type(sample)
        times = (
            cost(partial(to_cdr, sample)),
            cost(partial(from_cdr, kind, data)),
            cost(partial(pickle.dumps, sample)),
            cost(partial(pickle.loads, pickled)),
        )
        rows.append((kind.__name__, len(data), len(pickled), *(f"{value:.1f}" for value in times)))
    headings = (
        "message",
        "CDR bytes",
        "pickle bytes",
        "encode [us]",
        "decode [us]",
        "pickle [us]",
        "unpickle [us]",
    )
    return (
        "### Codec: CDR of ROS 2 types\n\n"
        + table(headings, rows)
        + "\n\nAgainst Python's own pickle in the same run, which checks nothing and which no other"
        " program reads.\n"
    )


def stop_path() -> str:
    """Not a flight: only what handing over a STOP costs its caller."""
    sender = StopSender("127.0.0.1", 9, "a secret for the benchmark")
    times = []
    for _ in range(100):
        started = time.perf_counter()
        sender.send()
        times.append(1e6 * (time.perf_counter() - started))
        time.sleep(0.005)
    sender.close()
    return (
        "### STOP: cost of sending it\n\n"
        + table(
            ("p50 [us]", "p99 [us]", "limit [us]"),
            [(f"{percentile(times, 0.5):.0f}", f"{percentile(times, 0.99):.0f}", 1000)],
        )
        + "\n\nTime until `StopSender.send` returns, the first datagram being on its way, against"
        " the limit of 1 ms.\n"
    )


def recorder() -> str:
    """Record a flight in real time and read this process's own CPU clock."""
    site, room = Site(), load_room("bsen")
    film = _film()
    with tempfile.TemporaryDirectory() as folder:
        log = FlightRecorder(FilePath(folder), site, room, build_grid(room, site))
        log.add_step(step(0, time.monotonic()))
        time.sleep(0.5)
        idle = _cpu_share(lambda number: None)
        busy = _cpu_share(lambda number: _feed(log, number, film))
        log.finish("benchmark")
        size = (FilePath(folder) / "flight.mcap").stat().st_size / SECONDS / 1000.0
    share = 100.0 * (busy - idle)
    picture = sum(len(data) for data, _ in film) / len(film) / 1000.0
    headings = (
        "recorder [%]",
        "budget of all processes [%]",
        "share of the budget [%]",
        "flight.mcap [kB/s]",
    )
    return (
        "### Flight recorder: share of one core\n\n"
        + table(headings, [(f"{share:.1f}", 120, f"{share / 1.2:.1f}", f"{size:.0f}")])
        + f"\n\n{RATE_HZ:.0f} steps and 30 pictures of {picture:.0f} kB a second for {SECONDS:.0f}"
        " s, less the same loop without a recorder, against the goal of 1.2 cores for the whole"
        " demo.\n"
    )


def _film() -> list[tuple[bytes, bool]]:
    """Return noisy H.264 pictures of 640 x 360 at about 3.6 Mbit/s, like those of the drone."""
    encoder: Any = av.CodecContext.create("libx264", "w")
    encoder.width, encoder.height, encoder.pix_fmt, encoder.bit_rate = (
        640,
        360,
        "yuv420p",
        3_600_000,
    )
    encoder.time_base, encoder.framerate = Fraction(1, 30), Fraction(30)
    encoder.options = {"preset": "ultrafast", "tune": "zerolatency", "g": "30"}
    noise = np.random.default_rng(1)
    film = []
    for number in range(90):
        coarse = noise.integers(0, 255, (90, 160, 3), dtype=np.uint8)
        frame = av.VideoFrame.from_ndarray(
            coarse.repeat(4, axis=0).repeat(4, axis=1), format="rgb24"
        )
        frame.pts = number
        film += [(bytes(packet), packet.is_keyframe) for packet in encoder.encode(frame)]
    return film


def _feed(log: FlightRecorder, number: int, film: list[tuple[bytes, bool]]) -> None:
    now = time.monotonic()
    log.add_step(step(number + 1, now))
    if number % 10 in (0, 3, 6):
        shown = number // 10 * 3 + number % 10 // 3
        data, keyframe = film[shown % len(film)]
        log.add_video(VideoFrame(data, keyframe, 640, 360, shown, now))


def _cpu_share(work: Callable[[int], None]) -> float:
    started, cpu = time.monotonic(), time.process_time()
    for number in range(int(SECONDS * RATE_HZ)):
        time.sleep(max(0.0, started + number / RATE_HZ - time.monotonic()))
        work(number)
    return (time.process_time() - cpu) / (time.monotonic() - started)


if __name__ == "__main__":
    if sys.argv[1:2] == ["listen"]:
        listen(sys.argv[2])
    else:
        for section in (transports, codec, stop_path, recorder):
            print(section(), flush=True)
