"""Why a Betaflight does not arm: its flags, and the words for them.

Source: betaflight/betaflight, src/main/fc/runtime_config.h and .c (2026). Older firmware has fewer,
and the last one is always the arm switch.
"""

from __future__ import annotations

from enum import IntFlag


class ArmingFlag(IntFlag):
    """Bits of STATUS_EX: each keeps it on the floor."""

    NO_GYRO = 1 << 0
    FAILSAFE = 1 << 1
    RX_FAILSAFE = 1 << 2
    NOT_DISARMED = 1 << 3
    BOX_FAILSAFE = 1 << 4
    RUNAWAY_TAKEOFF = 1 << 5
    CRASH_DETECTED = 1 << 6
    THROTTLE = 1 << 7
    ANGLE = 1 << 8
    BOOT_GRACE_TIME = 1 << 9
    NO_PREARM = 1 << 10
    LOAD = 1 << 11
    CALIBRATING = 1 << 12
    CLI = 1 << 13
    CMS_MENU = 1 << 14
    BST = 1 << 15
    MSP = 1 << 16
    PARALYZE = 1 << 17
    GPS = 1 << 18
    RESCUE_SWITCH = 1 << 19
    DSHOT_TELEMETRY = 1 << 20
    REBOOT_REQUIRED = 1 << 21
    DSHOT_BITBANG = 1 << 22
    ACC_CALIBRATION = 1 << 23
    MOTOR_PROTOCOL = 1 << 24
    CRASH_FLIP = 1 << 25
    ALT_HOLD = 1 << 26
    POS_HOLD = 1 << 27
    AUTOPILOT = 1 << 28
    ARM_SWITCH = 1 << 29


NOTHING = ArmingFlag(0)
_COUNT = len(ArmingFlag)
OF_THE_SWITCH = ArmingFlag.ARM_SWITCH | ArmingFlag.NOT_DISARMED
"""Set because the arm switch is on, and gone once it was off."""
_MEANING = {
    ArmingFlag.NO_GYRO: "no gyro was found",
    ArmingFlag.FAILSAFE: "its failsafe is active",
    ArmingFlag.RX_FAILSAFE: "it hears no sticks",
    ArmingFlag.NOT_DISARMED: "the arm switch was on before",
    ArmingFlag.BOX_FAILSAFE: "the failsafe switch is on",
    ArmingFlag.RUNAWAY_TAKEOFF: "its last take-off ran away: look at motors and propellers",
    ArmingFlag.CRASH_DETECTED: "it has crashed",
    ArmingFlag.THROTTLE: "the throttle is not low",
    ArmingFlag.ANGLE: "it does not stand level",
    ArmingFlag.BOOT_GRACE_TIME: "it was just switched on",
    ArmingFlag.NO_PREARM: "the prearm switch is off",
    ArmingFlag.LOAD: "its processor is overloaded",
    ArmingFlag.CALIBRATING: "it calibrates itself: do not move it",
    ArmingFlag.CLI: "its command line is open",
    ArmingFlag.CMS_MENU: "its menu is open",
    ArmingFlag.BST: "a black box of its maker forbids it",
    ArmingFlag.MSP: "a configurator forbids it",
    ArmingFlag.PARALYZE: "it is paralyzed until it is switched off and on",
    ArmingFlag.GPS: "it wants GPS for its rescue",
    ArmingFlag.RESCUE_SWITCH: "the rescue switch is on",
    ArmingFlag.DSHOT_TELEMETRY: "a motor tells no speed",
    ArmingFlag.REBOOT_REQUIRED: "switch it off and on: its settings changed",
    ArmingFlag.DSHOT_BITBANG: "its motor outputs do not work",
    ArmingFlag.ACC_CALIBRATION: "calibrate its accelerometer",
    ArmingFlag.MOTOR_PROTOCOL: "no motor protocol is set",
    ArmingFlag.CRASH_FLIP: "the switch that turns it over is on",
    ArmingFlag.ALT_HOLD: "the altitude switch is on",
    ArmingFlag.POS_HOLD: "the position switch is on",
    ArmingFlag.AUTOPILOT: "the autopilot switch is on",
    ArmingFlag.ARM_SWITCH: "the arm switch must go off first",
}


def flags_of(bits: int, count: int) -> ArmingFlag:
    """Return the flags in a word of so many bits; those of firmware newer than this are left out.

    Args:
        bits: as STATUS_EX tells them.
        count: how many flags its firmware has.
    """
    if not 0 < count < _COUNT:
        return ArmingFlag(bits & (1 << _COUNT) - 1)
    switch = 1 << count - 1
    others = ArmingFlag(bits & switch - 1)
    return others | ArmingFlag.ARM_SWITCH if bits & switch else others


def told_flags(flags: ArmingFlag) -> tuple[str, ...]:
    """Return what each flag says: the firmware's name of it, and its meaning."""
    return tuple(f"{flag.name}: {words}" for flag, words in _MEANING.items() if flag in flags)
