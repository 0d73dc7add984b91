"""Bitcraze's own library against a Crazyflie on UDP; prints a line of JSON for each thing it did.

Run by ``test_cflib.py`` with the Python of an environment of its own; its library is GPL, and
nothing of Housefly imports it. Poses come in on standard input, one line each: x y z qx qy qz qw.
"""

import json
import os
import sys
import threading
import time

ADDRESS = sys.argv[1]
os.environ["SCAN_ADDRESS"] = ADDRESS

import cflib.crtp  # noqa: E402
from cflib.crazyflie import Crazyflie  # noqa: E402
from cflib.crazyflie.log import LogConfig  # noqa: E402
from cflib.crazyflie.syncCrazyflie import SyncCrazyflie  # noqa: E402
from cflib.crazyflie.syncLogger import SyncLogger  # noqa: E402

SIDE, HEIGHT = 0.6, 0.8


def tell(**values: object) -> None:
    """Print what happened."""
    print(json.dumps(values), flush=True)


class Tracking(threading.Thread):
    """Passes poses on, and keeps the newest."""

    def __init__(self, crazyflie: Crazyflie) -> None:
        super().__init__(daemon=True)
        self.crazyflie, self.place = crazyflie, (0.0, 0.0, 0.0)
        self.count = 0

    def run(self) -> None:
        """Read until the end."""
        for line in sys.stdin:
            x, y, z, *turned = map(float, line.split())
            self.crazyflie.extpos.send_extpose(x, y, z, *turned)
            self.place, self.count = (x, y, z), self.count + 1


def estimate(crazyflie: Crazyflie) -> tuple[float, float, float]:
    """Return where the drone believes to be."""
    config = LogConfig("place", period_in_ms=20)
    for axis in "xyz":
        config.add_variable(f"stateEstimate.{axis}", "float")
    with SyncLogger(crazyflie, config) as log:
        for _, data, _ in log:
            return tuple(data[f"stateEstimate.{axis}"] for axis in "xyz")
    raise RuntimeError("no log")


def main() -> None:
    """Scan, connect, read, arm, fly a square, land."""
    cflib.crtp.init_drivers(enable_debug_driver=False)
    tell(scanned=[uri for uri, _ in cflib.crtp.scan_interfaces() if uri.startswith("udp")])
    with SyncCrazyflie(f"udp://{ADDRESS}:19850", cf=Crazyflie()) as connected:
        crazyflie = connected.cf
        tracking = Tracking(crazyflie)
        connected.wait_for_params()
        tell(
            protocol=crazyflie.platform.get_protocol_version(),
            logged=sorted(
                f"{group}.{name}"
                for group, names in crazyflie.log.toc.toc.items()
                for name in names
            ),
            parameters={
                f"{group}.{name}": float(value)
                for group, names in crazyflie.param.values.items()
                for name, value in names.items()
            },
        )
        crazyflie.param.set_value("stabilizer.estimator", 2)
        tracking.start()
        crazyflie.param.set_value("kalman.resetEstimation", 1)
        crazyflie.param.set_value("kalman.resetEstimation", 0)
        time.sleep(1.0)
        start = tracking.place
        tell(believes=estimate(crazyflie), stands=start, poses=tracking.count)
        crazyflie.supervisor.send_arming_request(True)
        time.sleep(0.3)
        tell(states=crazyflie.supervisor.read_state_list())
        commander, setpoints = crazyflie.high_level_commander, crazyflie.commander
        commander.takeoff(HEIGHT, 2.0, yaw=None)
        time.sleep(2.5)
        tell(states=crazyflie.supervisor.read_state_list(), height=tracking.place[2])
        x, y, _ = start
        corners = [(x + SIDE, y), (x + SIDE, y + SIDE), (x, y + SIDE), (x, y)]
        for corner in corners[:2]:
            commander.go_to(*corner, HEIGHT, 0.0, 1.5)
            time.sleep(2.2)
            tell(corner=corner, reached=tracking.place[:2])
        rest, ahead = [0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]
        sent = (
            lambda x, y: setpoints.send_position_setpoint(x, y, HEIGHT, 0.0),
            lambda x, y: setpoints.send_full_state_setpoint(
                [x, y, HEIGHT], rest, rest, ahead, 0.0, 0.0, 0.0
            ),
        )
        for send, corner in zip(sent, corners[2:], strict=True):
            end = time.monotonic() + 2.2
            while time.monotonic() < end:
                send(*corner)
                time.sleep(0.05)
            tell(corner=corner, reached=tracking.place[:2])
        setpoints.send_notify_setpoint_stop()
        commander.land(0.0, 2.0, yaw=None)
        time.sleep(2.5)
        commander.stop()
        time.sleep(2.2)
        tell(states=crazyflie.supervisor.read_state_list(), height=tracking.place[2])


main()
