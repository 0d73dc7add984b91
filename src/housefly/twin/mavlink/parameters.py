"""What is set on a simulated autopilot: its parameters, as their makers' descriptions name them."""

from __future__ import annotations

import struct
from typing import Any

from housefly.wires.mavlink.autopilots import Autopilot
from housefly.wires.mavlink.dialect import dialect

_REAL, _COUNT = 9, 6
_SET = {
    "arducopter": {
        "FS_GCS_ENABLE": 5, "FS_GCS_TIMEOUT": 5.0, "GUID_TIMEOUT": 3.0, "EK3_SRC1_POSXY": 6,
        "EK3_SRC1_POSZ": 6, "EK3_SRC1_YAW": 6, "VISO_TYPE": 1, "SYSID_THISMAV": 1,
        "SYSID_MYGCS": 255, "DISARM_DELAY": 10.0,
    },
    "px4": {
        "COM_OBL_RC_ACT": 4, "COM_OF_LOSS_T": 1.0, "EKF2_EV_CTRL": 11, "EKF2_HGT_REF": 3,
        "MIS_TAKEOFF_ALT": 1.0, "MAV_SYS_ID": 1, "COM_DISARM_PRFLT": 10.0, "SYS_AUTOSTART": 4019,
    },
}  # fmt: skip
"""As docs/drones/mavlink.md says that they are to be set: whole numbers are counts."""


class Parameters:
    """The parameters of one autopilot.

    Args:
        model: which.
        autopilot: how it sends whole numbers.
    """

    def __init__(self, model: str, autopilot: Autopilot) -> None:
        self._values: dict[str, float] = dict(_SET[model])
        self._counts = {name for name, value in _SET[model].items() if isinstance(value, int)}
        self._by_bits = autopilot.counts_by_bits

    def __getitem__(self, name: str) -> float:
        return self._values[name]

    def number(self, name: str, otherwise: float) -> float:
        """Return a parameter, or something else where the autopilot has none of that name."""
        return self._values.get(name, otherwise)

    def told(self, name: str | None = None) -> list[Any]:
        """Return the messages of one parameter, or of all; none for a name that is not known."""
        names = list(self._values)
        wanted = names if name is None else [name] if name in self._values else []
        return [self._message(one, names.index(one), len(names)) for one in wanted]

    def name_at(self, index: int) -> str:
        """Return the name at a place in the list, "" beyond its end."""
        names = list(self._values)
        return names[index] if 0 <= index < len(names) else ""

    def set(self, name: str, value: float) -> None:
        """Set a parameter, as a message brings it."""
        if name not in self._values or value != value:
            return
        if name in self._counts and self._by_bits:
            value = float(struct.unpack("<i", struct.pack("<f", value))[0])
        self._values[name] = value

    def _message(self, name: str, index: int, count: int) -> Any:
        value, kind = self._values[name], _COUNT if name in self._counts else _REAL
        if kind == _COUNT and self._by_bits:
            value = struct.unpack("<f", struct.pack("<i", int(value)))[0]
        return dialect().MAVLink_param_value_message(name.encode(), value, kind, count, index)
