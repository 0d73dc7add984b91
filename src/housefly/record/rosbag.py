"""A recording as a rosbag2 folder, for ``ros2 bag play`` and everything that reads one."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from typing import Any, Literal

from rosbags.interfaces import (
    Qos,
    QosDurability,
    QosHistory,
    QosLiveliness,
    QosReliability,
    QosTime,
)
from rosbags.rosbag2 import StoragePlugin, Writer, WriterError

from housefly.bus.interfaces import recorded_store
from housefly.errors import RecordingError
from housefly.record.mcap_reader import RecordedMessage, flight_file, read_messages

_VERSION: Literal[9] = 9
"""Of ``metadata.yaml``: that of ROS 2 Jazzy."""
_OWN_PACKAGE = "housefly_msgs/"
_DEFAULT_TIME = QosTime(0, 0)
_LATCHED = (
    Qos(
        QosHistory.KEEP_LAST, 1, QosReliability.RELIABLE, QosDurability.TRANSIENT_LOCAL,
        _DEFAULT_TIME, _DEFAULT_TIME, QosLiveliness.AUTOMATIC, _DEFAULT_TIME, False,
    ),
)  # fmt: skip
"""Who subscribes late still gets the map: RViz and Nav2 ask for it so."""
_QOS: Mapping[str, tuple[Qos, ...]] = {"/map": _LATCHED}


@dataclass(frozen=True, slots=True)
class BagCounts:
    """How many messages of each topic were written, and which topics were left out."""

    messages: Mapping[str, int]
    left_out: frozenset[str]


def write_rosbag(recording: Path, folder: Path, *, with_own: bool = False) -> BagCounts:
    """Write the standard topics of a recording as a rosbag2 folder in MCAP.

    Args:
        recording: ``flight.mcap``, or the folder that holds it.
        folder: to be made.
        with_own: whether the topics of our own types go in; ``ros2 bag play`` needs these types.

    Raises:
        RecordingError: the recording cannot be read, or the folder exists or cannot be written.
    """
    source = flight_file(recording)
    counts, left_out = Counter[str](), set[str]()
    connections: dict[tuple[str, str], Any] = {}
    messages = read_messages(source)
    first = next(messages, None)
    if first is None:
        raise RecordingError(f"{source} holds no message")
    try:
        with Writer(folder, version=_VERSION, storage_plugin=StoragePlugin.MCAP) as bag:
            for message in chain((first,), messages):
                _write(bag, message, connections, counts, left_out, with_own)
    except WriterError as error:
        raise RecordingError(f"{folder} cannot be written: {error}") from error
    except OSError as error:
        raise RecordingError(f"{folder} cannot be written: {error.strerror}") from error
    return BagCounts(dict(counts), frozenset(left_out))


def _write(
    bag: Any,
    message: RecordedMessage,
    connections: dict[tuple[str, str], Any],
    counts: Counter[str],
    left_out: set[str],
    with_own: bool,
) -> None:
    if message.encoding != "cdr" or (message.type_name.startswith(_OWN_PACKAGE) and not with_own):
        left_out.add(message.topic)
        return
    key = message.topic, message.schema
    if key not in connections:
        connections[key] = bag.add_connection(
            message.topic,
            message.type_name,
            typestore=recorded_store(message.type_name, message.schema),
            offered_qos_profiles=_QOS.get(message.topic, ()),
        )
    bag.write(connections[key], message.stamp, message.data)
    counts[message.topic] += 1
