"""Flies whatever Tello answers at an address with PyPI djitellopy; prints what it saw as JSON.

``python fly_tello.py ADDRESS PORT``: it takes UDP 8889, 8890 and 11111 of this machine itself.
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable

from djitellopy import Tello


def wait_until(holds: Callable[[], bool], patience: float = 20.0) -> bool:
    """Return whether something holds in time."""
    end = time.monotonic() + patience
    while not holds():
        if time.monotonic() > end:
            return False
        time.sleep(0.05)
    return True


def main() -> None:
    """Connect, ask, take off, step, turn, steer by sticks, watch, land."""
    address, port = sys.argv[1], int(sys.argv[2])
    seen: dict[str, object] = {}
    drone = Tello(address)
    drone.address = (address, port)
    drone.connect()
    seen["battery"], seen["sdk"] = drone.query_battery(), drone.query_sdk_version()
    seen["state"] = sorted(drone.get_current_state())
    drone.streamon()
    frames = drone.get_frame_read()
    drone.takeoff()
    seen["height"], seen["tof"] = drone.get_height(), drone.get_distance_tof()
    drone.move_forward(60)
    drone.rotate_clockwise(90)
    drone.move_up(30)
    seen["risen"] = drone.get_distance_tof()
    seen["yaw"] = drone.get_yaw()
    for _ in range(20):
        drone.send_rc_control(0, 40, 0, 0)
        time.sleep(0.1)
    drone.send_rc_control(0, 0, 0, 0)
    seen["filmed"] = wait_until(lambda: frames.frame.shape == (720, 960, 3))
    seen["picture"] = [int(frames.frame[:, :100].mean()), int(frames.frame[:, -100:].mean())]
    drone.land()
    seen["landed"] = wait_until(lambda: drone.get_distance_tof() <= 10)
    seen["motors_s"] = drone.get_flight_time()
    print(json.dumps(seen), flush=True)


if __name__ == "__main__":
    main()
