"""Betaflight's own program on board of a simulated drone.

It serves MSP on TCP 5761 of every address by itself; its simulator's ports are fixed, so there is
one of it in a network namespace.
"""

from __future__ import annotations

from pathlib import Path

from housefly.twin.contracts import TwinDrone
from housefly.twin.firmware.beside import Beside
from housefly.twin.firmware.program import Program, drone_to_board
from housefly.twin.link_filters import UNFILTERED, LinkFilters

_NAME = "Betaflight"
SETTINGS = (
    "feature -GPS", "feature -RX_UDP", "feature RX_MSP",
    "aux 0 0 0 1700 2100 0 0", "aux 1 1 1 1700 2100 0 0",
    "set angle_limit = 60", "set thr_expo = 0", "set acc_calibration = 0,0,0,1",
    "set failsafe_delay = 15", "set failsafe_procedure = AUTO-LAND", "rxfail 3 h",
    "set failsafe_landing_time = 6", "set small_angle = 180", "save",
)  # fmt: skip
"""What is set on it before it starts, in its own command line; all else is as its makers have it.

MSP is its receiver, AUX1 arms, AUX2 is ANGLE.
"""


class BetaflightProgram:
    """Lets Betaflight's program fly one simulated drone.

    Args:
        drone: what it flies.
        address: IP address to answer at.
        program: of Betaflight for simulation.
        beyond_loopback: allow an address, and interfaces, that other machines can reach.
        filters: faults of a link; none can be put between a client and this program.
        settings: lines of its command line.

    Raises:
        ConfigError: an address that is not loopback, or an interface beside loopback, without
            ``beyond_loopback``.
        LinkError: the port where its motors are heard cannot be had.
    """

    def __init__(
        self,
        drone: TwinDrone,
        address: str = "127.0.0.1",
        *,
        program: Path,
        beyond_loopback: bool = False,
        filters: LinkFilters = UNFILTERED,
        settings: tuple[str, ...] = SETTINGS,
    ) -> None:
        boarded = drone_to_board(_NAME, drone, address, beyond_loopback)
        self._drone, self._settings = boarded, settings
        self._program = Program(program)
        self.steps = Beside()

    @property
    def problem(self) -> str:
        """Why it does not fly; "" while it does."""
        return f"{_NAME} has ended: {self._program.said}" if self._program.has_ended else ""

    async def start(self) -> None:
        """Set the program and start it; raises LinkError when that cannot be done."""
        settings = self._program.folder / "settings.txt"
        settings.write_text("\n".join(self._settings) + "\n")
        self._program.prepare(["--config", str(settings)])
        self._program.start([])
        self._drone.board(self.steps)

    async def stop(self) -> None:
        """End the program and close the ports."""
        self._program.stop()
        self.steps.close()
