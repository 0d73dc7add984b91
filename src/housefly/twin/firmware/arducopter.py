"""ArduCopter's own program on board of a simulated drone.

Its parameters are those of docs/drones/mavlink.md, and what a simulated board needs: no GPS and no
compass, an accelerometer that counts as calibrated, pulses of 1000 to 2000 us.
"""

from __future__ import annotations

from pathlib import Path

from housefly.twin.contracts import TwinDrone
from housefly.twin.firmware.lock_step import LockStep
from housefly.twin.firmware.program import Program, drone_to_board
from housefly.twin.firmware.relay import Relay
from housefly.twin.link_filters import UNFILTERED, LinkFilters
from housefly.wires.mavlink.autopilots import AUTOPILOTS

_ROW = AUTOPILOTS["arducopter"]
_UNUSED = range(1, 8)
"""Serial ports on which it would open ports of its own."""
PARAMETERS: dict[str, float] = {
    "FRAME_CLASS": 1, "FRAME_TYPE": 1, "MOT_PWM_MIN": 1000, "MOT_PWM_MAX": 2000,
    "MOT_THST_HOVER": 0.5, "FS_GCS_ENABLE": 5, "GUID_TIMEOUT": 3, "FS_THR_ENABLE": 0,
    "EK3_SRC1_POSXY": 6, "EK3_SRC1_VELXY": 6, "EK3_SRC1_POSZ": 6, "EK3_SRC1_VELZ": 6,
    "EK3_SRC1_YAW": 6, "VISO_TYPE": 1, "GPS_TYPE": 0, "COMPASS_ENABLE": 0,
    "WPNAV_SPEED_UP": 40, "LAND_SPEED": 40, "LOG_BACKEND_TYPE": 0, "TERRAIN_ENABLE": 0,
    "FENCE_ENABLE": 0, "BATT_MONITOR": 4, "SCHED_LOOP_RATE": 200, "INS_USE2": 0, "EK3_IMU_MASK": 1,
}  # fmt: skip
"""What is set on it before it starts; all else is as its makers have it."""


class ArduCopterProgram:
    """Lets ArduCopter's program fly one simulated drone, and serves its MAVLink on UDP 14550.

    Args:
        drone: what it flies.
        address: IP address to answer at.
        program: of ArduCopter for simulation.
        beyond_loopback: allow an address, and interfaces, that other machines can reach.
        filters: what stands between a client and the program.

    Attributes:
        steps: the lock step with it.

    Raises:
        ConfigError: an address that is not loopback, or an interface beside loopback, without
            ``beyond_loopback``.
    """

    def __init__(
        self,
        drone: TwinDrone,
        address: str = "127.0.0.1",
        *,
        program: Path,
        beyond_loopback: bool = False,
        filters: LinkFilters = UNFILTERED,
    ) -> None:
        boarded = drone_to_board(_ROW.name, drone, address, beyond_loopback)
        self._drone = boarded
        self._program = Program(program)
        self._relay = Relay(address, _ROW.udp_port, filters)
        self.steps = LockStep(lambda: self._program.has_ended)

    @property
    def problem(self) -> str:
        """Why it does not fly; "" while it does."""
        return f"{_ROW.name} has ended: {self._program.said}" if self._program.has_ended else ""

    async def start(self) -> None:
        """Open the ports and start the program; raises LinkError when either cannot be had."""
        port = await self._relay.start()
        settings = self._program.folder / "settings.parm"
        settings.write_text("".join(f"{name} {value}\n" for name, value in PARAMETERS.items()))
        self._program.start(
            [
                *("--model", "JSON:127.0.0.1", "--sim-port-out", str(self.steps.port)),
                *("--defaults", str(settings), "--home", "45,7,0,0", "--wipe"),
                *("--serial0", f"udpclient:127.0.0.1:{port}"),
                *(word for n in _UNUSED for word in (f"--serial{n}", f"none:{n}")),
            ]
        )
        self._drone.board(self.steps)

    async def stop(self) -> None:
        """End the program and close the ports."""
        self._program.stop()
        self._relay.stop()
        self.steps.close()
