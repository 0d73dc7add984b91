"""A program that speaks ArduPilot's simulator wire as ArduCopter does, and hovers one metre up.

``python fake_arducopter.py --sim-port-out PORT --serial0 udpclient:HOST:PORT`` is its process: it
answers each of our datagrams on the wire of serial 0 with the same, backwards. Standard library
only: it knows nothing of ours.
"""

from __future__ import annotations

import json
import socket
import struct
import sys
from typing import Any

HOVER = 0.648
"""Throttle that carries the airframe of ``arducopter.toml`` on rotors with a bend of 0.65."""


def pulses(state: dict[str, Any], height: float = 1.0) -> list[int]:
    """Return pulses for a state: front right, rear left, front left, rear right."""
    _north, _east, down = state["position"]
    _, _, sink = state["velocity"]
    (p, q, _r), (w, x, y, z) = state["imu"]["gyro"], state["quaternion"]
    lift = HOVER + 0.25 * max(-0.5, min(0.5, height + down)) + 0.2 * sink
    roll = -0.25 * 2.0 * (w * x + y * z) - 0.06 * p
    pitch = -0.25 * 2.0 * (w * y - z * x) - 0.06 * q
    told = (lift - roll + pitch, lift + roll - pitch, lift + roll + pitch, lift - roll - pitch)
    return [round(1000 + 1000 * max(0.0, min(1.0, throttle))) for throttle in told]


def packet(frame: int, told: list[int], rate_hz: int = 400) -> bytes:
    """Return a servo packet of sixteen outputs."""
    return struct.pack("<HHI16H", 18458, rate_hz, frame, *told, *(0,) * (16 - len(told)))


def fly(simulator: tuple[str, int], ground: tuple[str, int]) -> None:
    """Answer every state with pulses, and every datagram from the ground; for ever."""
    steps, radio = (socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(2))
    steps.settimeout(0.2)
    radio.setblocking(False)
    frame, told = 0, [1000] * 4
    radio.sendto(b"here", ground)
    while True:
        steps.sendto(packet(frame, told), simulator)
        try:
            lines = steps.recv(65536).splitlines()
        except TimeoutError:
            continue
        told, frame = pulses(json.loads(next(filter(None, lines)))), frame + 1
        try:
            radio.sendto(radio.recv(2048)[::-1], ground)
        except BlockingIOError:
            continue


def main() -> None:
    given = dict(zip(sys.argv[1:], sys.argv[2:], strict=False))
    _, host, port = given["--serial0"].split(":")
    fly(("127.0.0.1", int(given["--sim-port-out"])), (host, int(port)))


if __name__ == "__main__":
    main()
