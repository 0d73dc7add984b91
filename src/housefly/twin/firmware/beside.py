"""Betaflight's program beside the room, over UDP: it runs by its own clock, at about our pace.

It answers no step: it is told every state, and what it told its motors last is what they do.
"""

from __future__ import annotations

import socket

from housefly.errors import LinkError, WireError
from housefly.twin.disturbance import MotorGains
from housefly.twin.firmware.betaflight_fdm import (
    MOTOR_PORT,
    STATE_PORT,
    motor_output_in,
    state_packet,
)
from housefly.twin.simulated_body import BodyState

_READ_MAX = 1000
"""So many datagrams are read at once; the newest counts."""
_FORGOTTEN_AFTER = 0.5
"""What it told longer ago moves nothing [s of the room]."""
_STOPPED: MotorGains = (0.0, 0.0, 0.0, 0.0)


class Beside:
    """The simulator's end of Betaflight's wire.

    Args:
        host: where the program and we reach each other.
        state_port, motor_port: the program's, and ours.

    Attributes:
        heard: how many motor packets came.
        broken: datagrams that were none.

    Raises:
        LinkError: our port cannot be had.
    """

    def __init__(
        self, host: str = "127.0.0.1", state_port: int = STATE_PORT, motor_port: int = MOTOR_PORT
    ) -> None:
        self.heard = self.broken = 0
        self._program = host, state_port
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.setblocking(False)
        try:
            self._socket.bind((host, motor_port))
        except OSError as error:
            self._socket.close()
            raise LinkError(
                f"cannot hear motors at {host}:{motor_port}: {error.strerror or error}"
            ) from error
        self.port: int = self._socket.getsockname()[1]
        self._told, self._told_at = _STOPPED, 0.0

    def exchange(self, at: float, body: BodyState) -> MotorGains:
        """Tell the state of the step that begins now [s]; return what the motors are told."""
        self._hear(at)
        self._socket.sendto(state_packet(at, body), self._program)
        return self._told if at - self._told_at <= _FORGOTTEN_AFTER else _STOPPED

    def close(self) -> None:
        """Release the port."""
        self._socket.close()

    def _hear(self, at: float) -> None:
        for _ in range(_READ_MAX):
            try:
                datagram = self._socket.recv(64)
            except (BlockingIOError, ConnectionRefusedError):
                return
            try:
                self._told = motor_output_in(datagram).gains
            except WireError:
                self.broken += 1
                continue
            self.heard, self._told_at = self.heard + 1, at
