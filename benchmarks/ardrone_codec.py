"""What reading and writing the AR.Drone's wire costs, beside pyardrone in the same run."""

from __future__ import annotations

import timeit
from collections.abc import Callable

import pyardrone.navdata as theirs
from pyardrone.at import PCMD

from housefly.wires.ardrone import at, conversions, pave
from housefly.wires.ardrone.navdata import StateBits, decode_navdata, encode_navdata
from housefly.wires.ardrone.navdata_options import OPTION_TYPES, Demo, MajorState, VisionDetect

DEMO = Demo(
    ctrl_state=MajorState.FLYING << 16,
    battery_percent=76,
    theta=-92.0,
    phi=-440.0,
    psi=14668.0,
    altitude=534,
    vx=268.5,
)
SHORT = encode_navdata(StateBits.FLYING, 1, (DEMO, VisionDetect()))
FULL = encode_navdata(StateBits.FLYING, 1, (DEMO, *(kind() for kind in OPTION_TYPES[1:])))
OUR_PCMD = at.Pcmd(at.PcmdFlag.PROGRESSIVE, 0.1, -0.2, 0.05, 1.0)
THEIR_PCMD = PCMD(1, 0.1, -0.2, 0.05, 1.0)
KEY_PICTURE = (
    b"\0\0\0\1\x67" + bytes(9) + b"\0\0\0\1\x68" + bytes(5) + b"\0\0\0\1\x65" + b"\x55" * 12_000
)
STREAM = b"".join(
    pave.encode_frame(pave.PaveHeader(len(KEY_PICTURE), number), KEY_PICTURE)
    for number in range(30)
)

PCMD_DATAGRAM = b"AT*PCMD=7,1,1036831949,-1102263091,1028443341,1065353216\r"


def microseconds(work: Callable[[], object], number: int = 500) -> float:
    """Return the best time of one call [us]."""
    return min(timeit.repeat(work, number=number, repeat=7)) / number * 1e6


def cut_stream() -> int:
    """Cut a second of video as it comes from TCP."""
    cutter = pave.VideoReassembler()
    return sum(len(cutter.feed(STREAM[at : at + 65_536])) for at in range(0, len(STREAM), 65_536))


def main() -> None:
    """Print the section."""
    assert at.encode_command(7, OUR_PCMD) == THEIR_PCMD._pack(7)
    demo = decode_navdata(FULL).option(Demo)
    assert demo and theirs.NavData(FULL).demo.altitude == demo.altitude == 534
    assert cut_stream() == 30
    rows = [
        (
            "full packet: check, state, attitude",
            lambda: decode_navdata(FULL).option(Demo),
            lambda: theirs.NavData(FULL).demo,
        ),
        (
            "full packet: all 27 options",
            lambda: decode_navdata(FULL).decoded(),
            lambda: theirs.NavData(FULL),
        ),
        (
            "demo packet: check, state, attitude",
            lambda: decode_navdata(SHORT).option(Demo),
            lambda: theirs.NavData(SHORT).demo,
        ),
        (
            "demo packet to Telemetry",
            lambda: conversions.telemetry_from_navdata(decode_navdata(SHORT), 0.0),
            None,
        ),
        ("write a demo packet", lambda: encode_navdata(1, 1, (DEMO, VisionDetect())), None),
        ("write PCMD", lambda: at.encode_command(7, OUR_PCMD), lambda: THEIR_PCMD._pack(7)),
        (
            "read PCMD",
            lambda: at.parse_datagram(PCMD_DATAGRAM),
            None,
        ),
    ]
    print(
        "### AR.Drone codec\n\n| work | Housefly [us] | pyardrone [us] | ratio |\n| --- | --- | ---"
        " | --- |"
    )
    for name, ours, other in rows:
        mine = microseconds(ours)
        compared = microseconds(other) if other else None
        against = f"{compared:.1f} | {compared / mine:.1f}x" if compared else "- | -"
        print(f"| {name} | {mine:.1f} | {against} |")
    print(
        f"| a second of video (30 key pictures of 12 kB) | {microseconds(cut_stream, 50):.0f} | -"
        " | - |"
    )
    share = 200e-4 * microseconds(
        lambda: conversions.telemetry_from_navdata(decode_navdata(FULL), 0.0)
    )
    print(
        f"\nThe same bytes through both; 200 full packets a second, each read, take {share:.2f} %"
        " of one core here."
    )


if __name__ == "__main__":
    main()
