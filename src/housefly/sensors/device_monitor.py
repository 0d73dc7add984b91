"""Counts the messages of one device and judges its health; pure, times are passed in."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable

from housefly.messages.words import UNSAID, Words, figure, literal
from housefly.sensors.contracts import SensorHealth
from housefly.sensors.message_rate import MessageRate, TokenBucket
from housefly.wires.devices import Channel, DeviceAddress, DeviceKind, Reading

MAX_THINGS = 128
"""A device may speak of this many things; further ones are dropped ..."""
_THINGS_KEPT = 3600.0
"""... until it has not spoken of others for this long [s]."""
_RECENT = 5.0
"""How long a flood or a wrong clock counts as a problem after it occurred [s]."""


_OFFLINE = Words("offline: its last will says so; is it switched on and in reach of the network?")


class DeviceMonitor:
    """Counts and judges the messages of one device.

    Attributes:
        counts: messages by outcome: heard, malformed, not understood, without a value, flooded,
            clock refused, unknown keys, past events, too many things.
    """

    def __init__(self, address: DeviceAddress, kind: DeviceKind, rate_max_hz: float) -> None:
        self.counts: Counter[str] = Counter()
        self._address, self._kind, self._rate_max = address, kind, rate_max_hz
        self._rate, self._bucket = MessageRate(), TokenBucket(rate_max_hz)
        self._things: dict[str, float] = {}
        self._online: bool | None = None
        self._complaints: dict[str, tuple[float, Words]] = {}
        self._last_state = b""
        self._refusals: dict[Channel, Words] = {}
        self._partial = UNSAID

    @property
    def kind(self) -> DeviceKind:
        """The kind of the device."""
        return self._kind

    def admit(self, now: float) -> bool:
        """Return whether to read the next message; those beyond the device's rate are dropped."""
        if self._bucket.consume(now):
            return True
        self._note(
            "flooded",
            now,
            Words(
                "sends more than {n} messages a second; the rest is dropped",
                n=figure(self._rate_max, "g"),
            ),
        )
        return False

    def admit_thing(self, thing: str, now: float) -> bool:
        """Return whether to believe in a thing; one device knows a limited number of them."""
        if thing not in self._things:
            self._things = {
                known: at for known, at in self._things.items() if now - at < _THINGS_KEPT
            }
            if len(self._things) >= MAX_THINGS:
                words = Words("speaks of more than {n} things", n=figure(MAX_THINGS))
                self._note("too many things", now, words)
                return False
        self._things[thing] = now
        return True

    def repeats(self, state: bytes, retained: bool) -> bool:
        """Return whether the broker only repeats the state that was heard last, after a break."""
        if retained:
            return state == self._last_state
        self._last_state = state
        return False

    def record(
        self, reading: Reading, now: float, retained: bool, channel: Channel = Channel.STATE
    ) -> None:
        """Record a decoded message; one that the broker retained is no sign of life."""
        if reading.absent:
            self.counts["without a value"] += 1
            if not self.counts["heard"]:  # a topic may carry other messages between the values
                self._refusals[channel] = literal(reading.absent)
            return
        self.counts["unknown keys"] += len(reading.unknown)
        if reading.refused:
            self.counts["not understood"] += 1
        if not reading.is_understood:
            self._refusals[channel] = literal(reading.refused[0])
            return
        if channel is Channel.STATE:
            self._partial = literal(next(iter(reading.refused), ""))
        self.counts["heard"] += 1
        self._refusals.pop(channel, None)
        if reading.online is not None:
            self._online = reading.online
        elif not retained:
            self._online = True
            self._rate.add(now)
        if reading.clock_error is not None:
            off = figure(abs(reading.clock_error), ".0f")
            words = (
                Words("its clock is {n} s ahead; times of arrival are taken instead", n=off)
                if reading.clock_error > 0
                else Words("its clock is {n} s behind; times of arrival are taken instead", n=off)
            )
            self._note("clock refused", now, words)

    def record_past_event(self) -> None:
        """Record an event that the broker retained: it is over."""
        self.counts["past events"] += 1

    def record_malformed(self, complaint: Words, channel: Channel = Channel.STATE) -> None:
        """Record a message that could not be decoded; it stays a problem until a good one comes."""
        self.counts["malformed"] += 1
        self._refusals[channel] = complaint

    def health(self, now: float, link_problem: Words) -> SensorHealth:
        """Return the health of the device; it cannot be healthy without the broker."""
        problem = link_problem or self._problem(now)
        quiet = self._is_silent(now) or self._online is False or Channel.STATE in self._refusals
        return SensorHealth(
            id=self._address.id,
            kind=self._kind.name,
            title=titled(self._kind.title, self._address.id),
            connected=not link_problem and not quiet,
            rate_hz=self._rate.rate_hz(now),
            age=self._rate.age(now),
            problem=problem,
            counts=tuple(sorted((name, count) for name, count in self.counts.items() if count)),
            is_offline=self._online is False,
        )

    def _problem(self, now: float) -> Words:
        """Return the most serious problem."""
        checks: tuple[Callable[[float], Words], ...] = (
            self._absence,
            self._refusal,
            self._latest_complaint,
            self._silence,
        )
        return next((words for check in checks if (words := check(now))), UNSAID)

    def _absence(self, now: float) -> Words:
        return _OFFLINE if self._online is False else UNSAID

    def _refusal(self, now: float) -> Words:
        """Return what of the last messages was refused; it stays until a good one comes."""
        return next(iter(self._refusals.values()), self._partial)

    def _latest_complaint(self, now: float) -> Words:
        recent = [(at, text) for at, text in self._complaints.values() if now - at <= _RECENT]
        return max(recent)[1] if recent else UNSAID

    def _silence(self, now: float) -> Words:
        if not self._is_silent(now):
            return UNSAID
        age, every = self._rate.age(now), figure(self._kind.heartbeat, "g")
        if age == float("inf"):
            return Words("not heard yet; it sends its state at least every {k} s", k=every)
        return Words(
            "silent for {n} s; it sends its state at least every {k} s",
            n=figure(age, ".0f"),
            k=every,
        )

    def _is_silent(self, now: float) -> bool:
        return self._rate.age(now) > 2 * self._kind.heartbeat

    def _note(self, count: str, now: float, text: Words) -> None:
        self.counts[count] += 1
        self._complaints[count] = (now, text)


def titled(kind: str, device: str) -> str:
    """Return a readable title, without "Intelligent cabinet cabinet" for a lone "cabinet"."""
    return kind if device in kind.lower().split() else f"{kind} {device}"
