"""Fields of an MSP payload, one after another, each checked for its range."""

from __future__ import annotations

from housefly.errors import WireError
from housefly.wires.betaflight.commands import Msp


class Fields:
    """Reads the numbers of one payload; a longer payload than is read is that of newer firmware.

    Args:
        command: what the payload answers; named in errors.
        payload: its bytes.
    """

    def __init__(self, command: Msp, payload: bytes) -> None:
        self._command, self._payload, self._at = command, payload, 0

    @property
    def left(self) -> int:
        """Bytes that were not read."""
        return len(self._payload) - self._at

    def unsigned(self, name: str, size: int, most: int | None = None) -> int:
        """Return the next number of so many bytes.

        Raises:
            WireError: the payload ends before, or the number is larger than allowed.
        """
        value = int.from_bytes(self._next(name, size), "little")
        if most is not None and value > most:
            raise WireError(f"{self._command.name}.{name} is {value}; allowed: 0 to {most}")
        return value

    def signed(self, name: str, size: int, most: int) -> int:
        """Return the next number, which may be negative; raises as ``unsigned``."""
        value = int.from_bytes(self._next(name, size), "little", signed=True)
        if abs(value) > most:
            raise WireError(f"{self._command.name}.{name} is {value}; allowed: {-most} to {most}")
        return value

    def several(self, name: str, size: int, count: int, most: int | None = None) -> tuple[int, ...]:
        """Return so many numbers; raises as ``unsigned``."""
        return tuple(self.unsigned(f"{name}[{number}]", size, most) for number in range(count))

    def skip(self, name: str, size: int) -> None:
        """Pass over bytes that say nothing here; raises as ``unsigned``."""
        self._next(name, size)

    def _next(self, name: str, size: int) -> bytes:
        end = self._at + size
        if end > len(self._payload):
            raise WireError(
                f"{self._command.name} ends before {name}: {len(self._payload)} bytes; allowed:"
                f" {end} or more"
            )
        data, self._at = self._payload[self._at : end], end
        return data


def packed(*numbers: tuple[int, int]) -> bytes:
    """Return numbers of so many bytes each, ``(value, size)``; negative ones as two's complement.

    Raises:
        WireError: one that does not fit.
    """
    data = bytearray()
    for value, size in numbers:
        try:
            data += value.to_bytes(size, "little", signed=value < 0)
        except OverflowError as error:
            raise WireError(f"{value} does not fit into {size} bytes") from error
    return bytes(data)
