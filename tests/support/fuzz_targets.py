"""Every parser of bytes from outside, by name: the one table of fuzzing."""

from __future__ import annotations

from fuzz_betaflight import BETAFLIGHT
from fuzz_crazyflie import CRAZYFLIE
from fuzz_drone_wires import DRONE_WIRES
from fuzz_files import FILES
from fuzz_imports import IMPORTS
from fuzz_kept import KEPT
from fuzz_logs import LOGS
from fuzz_mavlink import MAVLINK
from fuzz_new_page import NEW_PAGE
from fuzz_room_wires import ROOM_WIRES
from fuzz_target import FuzzTarget
from fuzz_tasks import TASKS
from fuzz_tello import TELLO
from fuzz_twin import TWIN
from fuzz_web import WEB

TARGETS: dict[str, FuzzTarget] = {
    **DRONE_WIRES, **ROOM_WIRES, **FILES, **KEPT, **TASKS, **TWIN, **WEB,
    **NEW_PAGE, **IMPORTS, **CRAZYFLIE, **TELLO, **MAVLINK,
    **BETAFLIGHT, **LOGS,
}  # fmt: skip
