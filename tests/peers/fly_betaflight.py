"""Flies whatever Betaflight answers at a serial port with PyPI yamspy; prints what it saw as JSON.

``python fly_betaflight.py DEVICE HOVER``: HOVER is the throttle that carries it [us].
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable

from yamspy import MSPy

LEVEL, LOW, HIGH = 1500, 1000, 1800


def main() -> None:
    """Ask, arm, rise, lean, sink, disarm."""
    device, hover = sys.argv[1], int(sys.argv[2])
    seen: dict[str, object] = {}
    with MSPy(device=device, loglevel="WARNING", baudrate=115200) as board:

        def ask(name: str) -> None:
            if board.send_RAW_msg(MSPy.MSPCodes[name], data=[]):
                board.process_recv_data(board.receive_msg())

        def fly(seconds: float, pitch: int, throttle: int, arm: int) -> None:
            end = time.monotonic() + seconds
            while time.monotonic() < end:
                # in the order of the wire: roll, pitch, throttle, yaw, switches
                board.fast_msp_rc_cmd([LEVEL, pitch, throttle, LEVEL, arm, HIGH, LOW, LOW])
                time.sleep(0.02)

        def until(holds: Callable[[], bool], *sticks: int) -> bool:
            end = time.monotonic() + 8.0
            while not holds():
                if time.monotonic() > end:
                    return False
                fly(0.1, *sticks)
                ask("MSP_STATUS_EX")
            return True

        ask("MSP_API_VERSION")
        ask("MSP_FC_VARIANT")
        seen["variant"] = board.CONFIG["flightControllerIdentifier"]
        ask("MSP_BOXIDS")
        ask("MSP_BATTERY_STATE")
        seen["cells"] = board.BATTERY_STATE["cellCount"]
        # of BATTERY_STATE it leaves out a byte before the voltage
        ask("MSP_ANALOG")
        seen["voltage"] = board.ANALOG["voltage"]
        ask("MSP_STATUS_EX")
        seen["blocked"] = board.process_armingDisableFlags(board.CONFIG["armingDisableFlags"])
        fly(1.0, LEVEL, LOW, LOW)
        seen["armed"] = until(lambda: bool(board.CONFIG["mode"] & 1), LEVEL, LOW, HIGH)
        fly(1.2, LEVEL, hover + 20, HIGH)
        fly(0.6, LEVEL, hover, HIGH)
        fly(0.5, 1650, hover + 10, HIGH)
        ask("MSP_ATTITUDE")
        seen["pitch"] = board.SENSOR_DATA["kinematics"][1]
        ask("MSP_RC")
        seen["channels"] = board.RC["channels"][:6]
        fly(4.0, LEVEL, hover - 25, HIGH)
        seen["disarmed"] = until(lambda: not board.CONFIG["mode"] & 1, LEVEL, LOW, LOW)
    print(json.dumps(seen), flush=True)


if __name__ == "__main__":
    main()
