"""What ArduCopter's own program does in our room, beside what our simulated vehicle does.

    ARDUCOPTER=PATH unshare -rn sh -c 'ip link set lo up; python benchmarks/their_firmware.py'

Both fly the airframe ``arducopter.toml``, by our driver over MAVLink, in real time; judged on the
truth of the room. Without ARDUCOPTER only our own is flown.
"""

from __future__ import annotations

import argparse
import asyncio
import os
from dataclasses import dataclass, fields
from pathlib import Path
from statistics import median

from _firmware_flight import FirmwareFlight, flight_of
from _run import table
from housefly.geometry import euler_from_quaternion, rotate
from housefly.messages import Action, Command, VelocitySetpoint
from housefly.messages.steering import flying
from housefly.twin.contracts import GroundTruth

AHEAD, UP = 0.4, 0.3
"""Asked for in a step [m/s]."""
_REACHED, _STILL = 0.632, 0.05
"""Share of a step that counts as its time constant; a speed that counts as none [m/s]."""


@dataclass(frozen=True, slots=True)
class Figures:
    """What one flight showed; times in s, speeds in m/s, lengths in m."""

    ready: float
    arming: float
    take_off: float
    take_off_height: float
    hover_rms: float
    tilt_peak: float
    tilt_peak_after: float
    ahead_lag: float
    ahead_overshoot: float
    stop: float
    stop_way: float
    climb_lag: float
    climb_overshoot: float
    silence_stop: float
    silence_landing: float
    silence_down: float


NAMES = {
    "ready": "from start until it would take off [s]",
    "arming": "from the order until its motors turn [s]",
    "take_off": "... until it says that it flies [s]",
    "take_off_height": "height then [m]",
    "hover_rms": "hover, rms from its mean over 5 s [mm]",
    "tilt_peak": f"step to {AHEAD} m/s ahead: largest tilt [degrees]",
    "tilt_peak_after": "... after [s]",
    "ahead_lag": "... 63 % of the speed after [s]",
    "ahead_overshoot": "... overshoot [%]",
    "stop": f"stop from {AHEAD} to {_STILL} m/s [s]",
    "stop_way": "... way [m]",
    "climb_lag": f"step to {UP} m/s up: 63 % after [s]",
    "climb_overshoot": "... overshoot [%]",
    "silence_stop": "its driver gone at 0.4 m/s: it stands after [s]",
    "silence_landing": "... begins to sink after [s]",
    "silence_down": "... is down after [s]",
}


def ahead(truth: GroundTruth) -> float:
    """Return the speed along the body's own forward axis [m/s]."""
    w, x, y, z = truth.pose.orientation
    return rotate((w, -x, -y, -z), truth.velocity)[0]


def tilt(truth: GroundTruth) -> float:
    """Return how far it leans [degrees]."""
    phi, theta, _ = euler_from_quaternion(truth.pose.orientation)
    return 57.29578 * float((phi * phi + theta * theta) ** 0.5)


def lag(values: list[tuple[float, float]], asked: float) -> float:
    """Return when 63 % of a step was reached [s]; -1 for never."""
    return next((at for at, value in values if value >= _REACHED * asked), -1.0)


async def one(program: Path | None, address: str) -> Figures:
    """Fly once."""
    async with flight_of(program, address) as flight:
        ready = await flight.ready()
        arming = await flight.arm()
        take_off = await flight.take_off()
        height = flight.height
        flight.command = Command(Action.HOVER)
        await flight.wait(5.0)
        hovered = await _noted(flight, 5.0)
        flight.command = flying(VelocitySetpoint(forward=AHEAD))
        step = await _noted(flight, 3.0)
        flight.command = Command(Action.HOVER)
        rest = await _noted(flight, 4.0)
        flight.command = flying(VelocitySetpoint(vz=UP))
        climb = await _noted(flight, 2.5)
        flight.command = Command(Action.HOVER)
        await flight.wait(3.0)
        flight.command = flying(VelocitySetpoint(forward=-AHEAD))
        await flight.wait(1.2)
        silence = await _silence(flight)
    begun = step[0].at
    leans = [(one.at - begun, tilt(one)) for one in step if one.at - begun < 1.5]
    peak = max(leans, key=lambda pair: pair[1])
    speeds = [(one.at - begun, ahead(one)) for one in step]
    rising = [(one.at - climb[0].at, one.velocity[2]) for one in climb]
    stood = next((one for one in rest if ahead(one) < _STILL), rest[-1])
    way = sum(
        (a - b) ** 2
        for a, b in zip(stood.pose.position[:2], rest[0].pose.position[:2], strict=True)
    )
    return Figures(
        ready, arming, take_off, height, 1000.0 * _spread(hovered), peak[1], peak[0],
        lag(speeds, AHEAD), _over(speeds, AHEAD), stood.at - rest[0].at, way**0.5,
        lag(rising, UP), _over(rising, UP), *silence,
    )  # fmt: skip


async def _noted(flight: FirmwareFlight, seconds: float) -> list[GroundTruth]:
    begun = len(flight.track)
    await flight.wait(seconds)
    return flight.track[begun:]


async def _silence(flight: FirmwareFlight) -> tuple[float, float, float]:
    await flight.drone.close()
    begun, height = flight.world.now, flight.height
    stood = await flight.until(lambda: flight.speed < _STILL, 30.0)
    await flight.until(lambda: flight.height < height - 0.15, 40.0)
    sank = flight.world.now - begun
    await flight.until(lambda: flight.height < 0.4, 40.0)
    await flight.until(lambda: abs(flight.world.truth().velocity[2]) < 0.02, 20.0)
    return stood, sank, flight.world.now - begun


def _spread(track: list[GroundTruth]) -> float:
    """Return the rms distance from the middle [m]."""
    places = [one.pose.position for one in track]
    middle = [sum(place[axis] for place in places) / len(places) for axis in range(3)]
    squares = [sum((place[axis] - middle[axis]) ** 2 for axis in range(3)) for place in places]
    return float((sum(squares) / len(squares)) ** 0.5)


def _over(values: list[tuple[float, float]], asked: float) -> float:
    return 100.0 * (max(value for _, value in values) / asked - 1.0)


async def flown(program: Path | None, times: int, first: int) -> list[Figures]:
    """Fly so often, each time at an address of its own."""
    return [await one(program, f"127.61.{first}.{number + 1}") for number in range(times)]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("times", nargs="?", type=int, default=3, help="flights of each")
    times = parser.parse_args().times
    path = os.environ.get("ARDUCOPTER", "")
    columns = {"our simulated one": asyncio.run(flown(None, times, 2))}
    if path:
        columns = {"ArduCopter's program": asyncio.run(flown(Path(path), times, 1)), **columns}
    rows = [
        [
            NAMES[field.name],
            *(
                f"{median(values):.2f} ({min(values):.2f} to {max(values):.2f})"
                for values in (
                    [getattr(figures, field.name) for figures in found]
                    for found in columns.values()
                )
            ),
        ]
        for field in fields(Figures)
    ]
    print(f"### Their firmware and ours: median (least to most) of {times} flights\n")
    print(table(("", *columns), rows))


if __name__ == "__main__":
    main()
