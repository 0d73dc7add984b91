"""Every parser of bytes from outside, by name: the one table of fuzzing."""

from __future__ import annotations

from fuzz_drone_wires import DRONE_WIRES
from fuzz_files import FILES
from fuzz_room_wires import ROOM_WIRES
from fuzz_target import FuzzTarget
from fuzz_web import WEB

TARGETS: dict[str, FuzzTarget] = {**DRONE_WIRES, **ROOM_WIRES, **FILES, **WEB}
