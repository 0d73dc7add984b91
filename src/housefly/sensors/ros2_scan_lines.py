"""Converts the lines of the ROS 2 scan child to scans; holds the state that spans lines."""

from __future__ import annotations

import base64
import binascii
import json
from dataclasses import dataclass
from math import inf
from typing import Any

from housefly.config.laser import LaserConfig
from housefly.errors import LinkError, WireError
from housefly.messages import Scan
from housefly.messages.words import UNSAID, Words, figure, literal
from housefly.sensors.ros2_scan import LASER_SCAN, laser_scan_message
from housefly.sensors.scan_clock import ROS_STAMPS, ScanClock

SCAN_RATE_MAX = 100.0
"""More scans a second than any scanner measures are dropped [Hz]."""
REFUSAL_SHOWN_FOR = 5.0
"""A refused scan is reported for this long [s]."""
_CLOCK_SET = 1_000_000_000
"""Stamps that go back by more mean that the sender's clock was set; by less, that it is late [ns].
"""
_NAMES_MAX = 4


@dataclass(frozen=True, slots=True)
class TopicPublishers:
    """Who publishes on a topic, as the child saw it last.

    Attributes:
        nodes: names of those that publish scans.
        other_types: that others publish there.
    """

    nodes: tuple[str, ...] = ()
    other_types: tuple[str, ...] = ()


class Ros2ScanLines:
    """Converts lines to scans.

    The age of a scan is by its stamp: the sender's clock is mapped to ours by what arrived soonest,
    as a scanner's own (``ScanClock``). One without a stamp was captured when it arrived, less the
    configured latency.

    Args:
        config: name and latency of the scanner.

    Attributes:
        publishers: on the topic.
        stale: scans dropped because they were not newer than the last.
    """

    def __init__(self, config: LaserConfig) -> None:
        self.publishers = TopicPublishers()
        self.stale = 0
        self._config, self._clock = config, ScanClock(ROS_STAMPS)
        self._stamp, self._flooded = -1, 0
        self._refusal, self._refused_at = UNSAID, -inf

    def read(self, line: bytes, received_at: float) -> Scan | None:
        """Return the scan of a line, None where there is none that counts.

        Raises:
            LinkError: the child reports a failure.
            WireError: the line makes no sense.
        """
        tree = _tree(line)
        try:
            if "nodes" in tree:
                self._look_at(tree, received_at)
                return None
            if "too_large" in tree:
                words = f"a message of {int(tree['too_large'])} bytes, which is no scan"
                self._refuse(literal(f"{self._name}: {words}"), received_at)
                return None
            data = base64.b64decode(tree["scan"], validate=True)
            told_at = float(tree["at"])
        except (KeyError, TypeError, ValueError, OverflowError, binascii.Error) as error:
            raise WireError(f"ROS 2 line: {line[:40]!r} is no scan") from error
        return self._scan(data, told_at if 0.0 <= told_at <= received_at else received_at)

    def refusal(self, now: float) -> Words:
        """Return why scans were refused lately, in words; UNSAID where none was."""
        return self._refusal if now - self._refused_at < REFUSAL_SHOWN_FOR else UNSAID

    @property
    def _name(self) -> str:
        return self._config.name

    def _look_at(self, tree: dict[str, Any], now: float) -> None:
        nodes, types = (tuple(map(str, tree[key]))[:_NAMES_MAX] for key in ("nodes", "types"))
        others = tuple(kind for kind in types if kind != LASER_SCAN)
        self.publishers = TopicPublishers(nodes, others)
        flooded, self._flooded = int(tree["flooded"]), self._flooded
        if flooded > self._flooded:
            rate = figure(SCAN_RATE_MAX, "g")
            words = Words("sends more than {n} messages a second; the rest is dropped", n=rate)
            self._refuse(words, now)
        self._flooded = flooded

    def _scan(self, data: bytes, at: float) -> Scan | None:
        if len(self.publishers.nodes) > 1:
            words = Words(
                "{n} nodes publish on {topic} ({names}): none is believed; give each scanner a"
                " topic of its own",
                n=figure(len(self.publishers.nodes)),
                topic=self._config.ros_topic,
                names=", ".join(self.publishers.nodes),
            )
            self._refuse(words, at)
            return None
        try:
            told = laser_scan_message(data)
        except WireError as error:
            self._refuse(literal(f"{self._name}: {error}"), at)
            return None
        if told.stamp and -_CLOCK_SET < told.stamp - self._stamp <= 0:
            self.stale += 1
            return None
        taken_at = at
        if told.stamp:
            self._stamp = told.stamp
            taken_at = self._clock.taken_at(told.stamp, at)
        captured_at = taken_at - self._config.latency
        ranges = tuple(told.ranges.tolist())
        return Scan(self._name, captured_at, at, told.first_angle, told.step, ranges)

    def _refuse(self, words: Words, now: float) -> None:
        self._refusal, self._refused_at = words, now


def _tree(line: bytes) -> dict[str, Any]:
    try:
        tree = json.loads(line)
    except (ValueError, RecursionError) as error:
        raise WireError(f"ROS 2 line: {line[:40]!r} is no JSON") from error
    if not isinstance(tree, dict):
        raise WireError(f"ROS 2 line: {line[:40]!r} is no object")
    if "problem" in tree:
        raise LinkError(f"ROS 2 says: {tree['problem']}")
    return tree
