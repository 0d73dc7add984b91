"""The sticks that a simulated Betaflight flies by: from MSP, from a radio, or what stands in.

As in the firmware (rx/rx.c, rx/msp.c, rx/msp_override.c): with MSP as the receiver all channels are
those of SET_RAW_RC. With a radio they are the radio's, but for those of the override mask while the
mode MSP OVERRIDE is on, each only while SET_RAW_RC brought it no more than 0.3 s ago. Without a
frame for 0.15 s sticks count as lost, for 0.3 s they are held, then each says what RXFAIL_CONFIG
has for it.
"""

from __future__ import annotations

from math import inf

from housefly.wires.betaflight.settings import Box, FcSettings, SilentChannel
from housefly.wires.betaflight.switches import boxes_at

FRESH_FOR = 0.3
"""A channel counts for so long, and is held for so long without a frame [s]."""
LOST_AFTER = 0.15
"""RadioSticks count as lost after this [s]."""
CHANNELS = 18
_RX_MIN = 885
_STICKS = 4
_THROTTLE = 3


class Receiver:
    """The channels of one drone, in the firmware's order: roll, pitch, yaw, throttle, switches.

    Args:
        settings: how it is set.

    Attributes:
        settings: as given; may be replaced.
        override_mask: bit n lets channel n of SET_RAW_RC override a radio.
        radio: what a person's radio sends, in the order of its channels; None for none.
        channels: what it flies by [us].
    """

    def __init__(self, settings: FcSettings) -> None:
        self.settings, self.override_mask = settings, 0
        self.radio: tuple[int, ...] | None = None
        self.channels = (1500, 1500, 1500, _RX_MIN, *(1000,) * (CHANNELS - _STICKS))
        self._heard: tuple[int, ...] = ()
        self._heard_at = -inf
        self._good_at = -inf

    def hear(self, channels: tuple[int, ...], now: float) -> None:
        """Take in SET_RAW_RC at a time [s]."""
        self._heard, self._heard_at = channels, now

    def is_lost(self, now: float) -> bool:
        """Return whether sticks count as lost."""
        return self.silence(now) > LOST_AFTER

    def silence(self, now: float) -> float:
        """Return how long ago sticks last came [s]."""
        if self.radio is not None and not self.settings.receiver_is_msp:
            return 0.0
        return now - self._heard_at if self.settings.receiver_is_msp else inf

    def update(self, now: float) -> None:
        """Renew the channels; to be called once a control period [s]."""
        silence = self.silence(now)
        if silence <= LOST_AFTER:
            self._good_at = now
            raw = self._raw(now)
            order = (*self.settings.order, *range(_STICKS, CHANNELS))
            self.channels = tuple(
                raw[channel] if channel < len(raw) else before
                for channel, before in zip(order, self.channels, strict=True)
            )
        elif silence > FRESH_FOR:
            self.channels = tuple(
                self._in_silence(channel, before) for channel, before in enumerate(self.channels)
            )

    def _raw(self, now: float) -> tuple[int, ...]:
        if self.settings.receiver_is_msp or self.radio is None:
            return self._heard
        positions = self.radio[_STICKS:]
        is_on = Box.MSP_OVERRIDE in boxes_at(self.settings.ranges, positions)
        if not is_on or now - self._heard_at > FRESH_FOR:
            return self.radio
        return tuple(
            self._heard[number]
            if self.override_mask >> number & 1 and number < len(self._heard)
            else own
            for number, own in enumerate(self.radio)
        )

    def _in_silence(self, channel: int, before: int) -> int:
        kind, value = self.settings.silent[channel]
        if kind is SilentChannel.HOLD:
            return before
        if kind is SilentChannel.SET:
            return value
        if channel >= _STICKS:
            return before
        return _RX_MIN if channel == _THROTTLE else self.settings.middle
