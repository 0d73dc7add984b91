"""The table of navdata options: tag, type, exact size.

Facts: Parrot ARDroneLib SDK 2.0.1, navdata_common.h.
"""

from __future__ import annotations

from housefly.wires.ardrone.layout import Structure
from housefly.wires.ardrone.options_flight import (
    Demo,
    Games,
    MajorState,
    MinorFlying,
    Pwm,
    RcReferences,
    References,
    Time,
    Trims,
    Watchdog,
    Wifi,
)
from housefly.wires.ardrone.options_sensors import (
    AdcDataFrame,
    Altitude,
    EulerAngles,
    GyrosOffsets,
    KalmanPressure,
    Magneto,
    PhysMeasures,
    PressureRaw,
    RawMeasures,
    WindSpeed,
)
from housefly.wires.ardrone.options_vision import (
    HdVideoStream,
    TrackersSend,
    VideoStream,
    Vision,
    VisionDetect,
    VisionOf,
    VisionPerf,
    VisionRaw,
)

__all__ = [
    "OPTION_TYPES",
    "TAGS",
    "AdcDataFrame",
    "Altitude",
    "Demo",
    "EulerAngles",
    "Games",
    "GyrosOffsets",
    "HdVideoStream",
    "KalmanPressure",
    "Magneto",
    "MajorState",
    "MinorFlying",
    "PhysMeasures",
    "PressureRaw",
    "Pwm",
    "RawMeasures",
    "RcReferences",
    "References",
    "Time",
    "TrackersSend",
    "Trims",
    "VideoStream",
    "Vision",
    "VisionDetect",
    "VisionOf",
    "VisionPerf",
    "VisionRaw",
    "Watchdog",
    "Wifi",
    "WindSpeed",
]

OPTION_TYPES: tuple[type[Structure], ...] = (
    Demo,
    Time,
    RawMeasures,
    PhysMeasures,
    GyrosOffsets,
    EulerAngles,
    References,
    Trims,
    RcReferences,
    Pwm,
    Altitude,
    VisionRaw,
    VisionOf,
    Vision,
    VisionPerf,
    TrackersSend,
    VisionDetect,
    Watchdog,
    AdcDataFrame,
    VideoStream,
    Games,
    PressureRaw,
    Magneto,
    WindSpeed,
    KalmanPressure,
    HdVideoStream,
    Wifi,
)
"""All known options; the index is the tag.

Tag 27 is left raw: 12 bytes in old firmware, 216 bytes (GPS) from firmware 2.4 on.
"""

TAGS: dict[type[Structure], int] = {option: tag for tag, option in enumerate(OPTION_TYPES)}
