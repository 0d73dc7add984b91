"""The fault matrix: its 52 rows, what injects each, where, and the safe outcome that it demands.

A row that is no fault of the simulated room names the test or command that covers it, or says that
nothing does. ``docs/faults.md`` is made from this table.
"""

from __future__ import annotations

from math import inf

from housefly.errors import ConfigError
from housefly.twin.faults.fault import Fault
from housefly.twin.faults.fault_row import FaultRow, FaultVariant
from housefly.twin.faults.onboard_rows import ONBOARD_ROWS
from housefly.twin.faults.vocabulary import LOCKSTEP, WIRES, FaultComponent, FaultKind, Injection


def row_of(number: str) -> FaultRow:
    """Return a row by its number; raises ConfigError for one that the matrix does not have."""
    for row in FAULT_CATALOGUE:
        if row.number == number:
            return row
    raise ConfigError("fault", f"{number} is no row; there are F01 to F{len(FAULT_CATALOGUE)}")


_C, _K = FaultComponent, FaultKind
_TWIN = LOCKSTEP | WIRES
_PROCESS, _USER = frozenset({Injection.PROCESS}), frozenset({Injection.USER})


def _mocap(
    aspect: str,
    kind: FaultKind = _K.WRONG,
    size: float | None = None,
    lasting: float = inf,
    start: float = 0.0,
) -> Fault:
    return Fault(_C.MOCAP, kind, aspect, start, lasting, size)


def _gap_then_offset(gap: float, offset: float, aspect: str = "position") -> FaultVariant:
    """Return the loss of tracking for a while, after which it has the drone elsewhere."""
    towards = "_up" if aspect == "z" else ""
    return FaultVariant(
        f"gap{gap:g}s_{offset:g}m{towards}",
        (_mocap("", _K.OFF, lasting=gap), _mocap(aspect, size=offset, start=gap)),
    )


def _jumps(size: float, apart: float, count: int) -> FaultVariant:
    """Return jumps that are each too small to be refused and add up, all in one direction."""
    return FaultVariant(
        f"jumps_{100 * size:g}cm",
        tuple(_mocap("position", size=size, start=apart * n) for n in range(count)),
    )


def _one(
    component: FaultComponent,
    kind: FaultKind,
    aspect: str = "",
    size: float | None = None,
    *,
    lasting: float = inf,
    name: str = "",
    wires_only: bool = False,
    cannot_hover: bool = False,
    is_extreme: bool = False,
    unscanned: bool = False,
) -> FaultVariant:
    fault = Fault(component, kind, aspect, 0.0, lasting, size)
    return FaultVariant(
        name or kind.value,
        (fault,),
        wires_only=wires_only,
        cannot_hover=cannot_hover,
        is_extreme=is_extreme,
        unscanned=unscanned,
    )


def _lost_above(aspect: str, name: str) -> FaultVariant:
    """Return the loss of tracking for good above somebody whom only the sonar shows."""
    somebody = Fault(_C.PEOPLE, _K.WRONG, aspect)
    return FaultVariant(name, (somebody, _mocap("", _K.OFF, start=1.0)), unscanned=True)


FAULT_CATALOGUE: tuple[FaultRow, ...] = (
    FaultRow(
        "F01", "no tracking for 0.2 s",
        "flies on by its model: no change of state, under 5 cm off", _TWIN,
        (FaultVariant("0.2s", (_mocap("", _K.OFF, lasting=0.2),)),),
    ),
    FaultRow(
        "F02", "no tracking for 1 s",
        "hovers at once, told; goes on by itself when the place fits", _TWIN,
        (FaultVariant("1s", (_mocap("", _K.OFF, lasting=1.0),)),),
    ),
    FaultRow(
        "F03", "no tracking for 5 s, or for good",
        "hovers, then lands where it is, or beside somebody below; never returns",
        _TWIN,
        (
            FaultVariant("5s", (_mocap("", _K.OFF, lasting=5.0),)),
            FaultVariant("for_good", (_mocap("", _K.OFF),)),
            _lost_above("below", "above_child"),
            _lost_above("lying", "above_lying"),
        ), True,
    ),
    FaultRow(
        "F04", "tracking jumps a metre and back",
        "the samples are refused; nothing is seen of it", _TWIN,
        (
            FaultVariant("1m", (_mocap("position", size=1.0, lasting=0.03),)),
            FaultVariant("3m", (_mocap("position", size=3.0, lasting=0.03),)),
        ),
    ),
    FaultRow(
        "F05", "tracking jumps and stays, at once or behind a gap",
        "hovers, then lands; the new place is never believed in the air", _TWIN,
        (
            FaultVariant("1m", (_mocap("position", size=1.0),)),
            FaultVariant("0.5m", (_mocap("position", size=0.5),)),
            *(
                _gap_then_offset(gap, offset)
                for gap, offset in (
                    (0.3, 0.3), (0.8, 0.4), (1.2, 0.5), (1.5, 0.6), (1.9, 0.8), (1.9, 1.0),
                )
            ),
            FaultVariant("0.7m_up", (_mocap("z", size=0.7),)),
            FaultVariant("0.7m_down", (_mocap("z", size=-0.7),)),
            _gap_then_offset(0.8, 0.7, "z"),
        ), True,
    ),
    FaultRow(
        "F06", "the drone and another body are exchanged",
        "hovers, then lands; says that tracking and the drone's own motion disagree", _TWIN,
        (FaultVariant("exchanged", (_mocap("bodies"),)),), True,
    ),
    FaultRow(
        "F07", "the drone's body is turned, or its axes are wrong",
        "hovers, then lands within 0.3 m of travel; told before take-off where it can be", _TWIN,
        (
            FaultVariant("180deg", (_mocap("yaw", size=3.1415926),)),
            FaultVariant("90deg", (_mocap("yaw", size=1.5707963),)),
            FaultVariant("60deg", (_mocap("yaw", size=1.0471976),)),
            FaultVariant("30deg", (_mocap("yaw", size=0.5235988),)),
            FaultVariant("axes", (_mocap("axes"),), from_start=True),
        ), True,
    ),
    FaultRow(
        "F08", "frozen poses under fresh stamps",
        "counts as no tracking: hovers, then lands", _TWIN,
        (_one(_C.MOCAP, _K.STUCK),), True,
    ),
    FaultRow(
        "F09", "stamps backward, doubled, or of the future",
        "dropped and counted; if nothing better comes, as no tracking", _TWIN,
        (
            FaultVariant("backward", (_mocap("stamp", size=-0.3),)),
            FaultVariant("doubled", (_mocap("stamp", _K.STUCK),)),
            FaultVariant("future", (_mocap("stamp", size=0.5),)),
            FaultVariant("mixed", (_mocap("stamp", _K.GARBAGE),)),
        ),
    ),
    FaultRow(
        "F10", "poses that are not numbers, or no rotations",
        "dropped and counted; as no tracking when they go on", _TWIN,
        (
            FaultVariant("nan", (_mocap("", _K.GARBAGE),)),
            FaultVariant("no_rotation", (_mocap("orientation", _K.GARBAGE),)),
        ),
    ),
    FaultRow(
        "F11", "tracking falls to 10 Hz", "flies on within the bound for 10 Hz", _TWIN,
        (_one(_C.MOCAP, _K.SLOW, size=10.0, name="10hz"),),
    ),
    FaultRow(
        "F12", "tracking is late, with or without saying so",
        "predicts ahead and flies slower; above 0.3 s holds; 0.3 s that it does not say are found"
        " within 5 s", _TWIN,
        (
            _one(_C.MOCAP, _K.DELAYED, size=0.2, name="0.2s"),
            _one(_C.MOCAP, _K.DELAYED, size=0.3, name="0.3s"),
            FaultVariant("unstamped_0.3s", (_mocap("latency", size=0.3),)),
            FaultVariant("unstamped_0.15s", (_mocap("latency", size=0.15),)),
        ), True,
    ),
    FaultRow(
        "F13", "the tracked place drifts, or steps once a second",
        "told at 0.1 m, landed before 0.3 m", _TWIN,
        (
            FaultVariant("2cm", (_mocap("drift", size=0.02),)),
            FaultVariant("5cm", (_mocap("drift", size=0.05),)),
            FaultVariant("steps", (_mocap("steps", size=0.14),)),
            _jumps(0.05, 8.0, 5),
            FaultVariant("up_5cm", (_mocap("drift_z", size=0.05),)),
        ), True,
    ),
    FaultRow(
        "F14", "30 % of the datagrams to and from the drone are lost",
        "flies on; landing and stopping are repeated until they are seen", _TWIN,
        (
            FaultVariant("30percent", (
                Fault(_C.COMMANDS, _K.INTERMITTENT, magnitude=0.3, seed=1),
                Fault(_C.TELEMETRY, _K.INTERMITTENT, magnitude=0.3, seed=2),
            )),
        ),
    ),
    FaultRow(
        "F15", "datagrams overtake each other or come twice",
        "old commands are dropped; taking off twice is taking off", _TWIN,
        (
            FaultVariant("both", (
                Fault(_C.COMMANDS, _K.WRONG, "order", magnitude=0.3, seed=1),
                Fault(_C.COMMANDS, _K.WRONG, "copies", magnitude=0.3, seed=2),
                Fault(_C.TELEMETRY, _K.WRONG, "order", magnitude=0.3, seed=3),
            )),
        ),
    ),
    FaultRow(
        "F16", "the link to or from the drone lags for a while",
        "holds after 0.3 s without commands and 1 s longer; late ones move it below 0.3 m", _TWIN,
        (
            _one(_C.COMMANDS, _K.DELAYED, size=1.0, lasting=2.0, name="up_1s"),
            _one(_C.TELEMETRY, _K.DELAYED, size=1.0, lasting=2.0, name="down_1s"),
            _one(_C.COMMANDS, _K.DELAYED, size=0.5, lasting=2.0, name="up_0.5s"),
            _one(_C.COMMANDS, _K.DELAYED, size=2.0, lasting=2.0, name="up_2s"),
        ),
    ),
    FaultRow(
        "F17", "the link to the drone is lost for good",
        "its own watchdog lands it; the user is told that it is on its own", _TWIN,
        (FaultVariant("off", (Fault(_C.COMMANDS, _K.OFF), Fault(_C.TELEMETRY, _K.OFF))),),
    ),
    FaultRow(
        "F18", "the drone falls silent and still obeys",
        "lands by tracking", _TWIN, (_one(_C.TELEMETRY, _K.OFF),),
    ),
    FaultRow(
        "F19", "the pictures stop, are damaged or stand still",
        "the flight does not notice; the picture is greyed with its age", WIRES,
        (
            _one(_C.VIDEO, _K.OFF, wires_only=True),
            _one(_C.VIDEO, _K.STUCK, wires_only=True),
            _one(_C.VIDEO, _K.GARBAGE, wires_only=True),
        ),
    ),
    FaultRow(
        "F20", "the charge falls off a cliff",
        "lands at once, where it is; after a smaller fall it comes home while the charge is enough",
        _TWIN,
        (
            _one(_C.BATTERY, _K.WRONG, size=0.08, name="8percent"),
            _one(_C.BATTERY, _K.WRONG, size=0.18, name="18percent"),
        ),
    ),
    FaultRow(
        "F21", "the battery's gauge stands still or shows no number",
        "told after a minute, then flies by time; without a number it lands; no next take-off"
        " before it shows another number", _TWIN,
        (_one(_C.BATTERY, _K.STUCK), _one(_C.BATTERY, _K.GARBAGE)),
    ),
    FaultRow(
        "F22", "a weak motor, a damaged propeller, a sagging battery",
        "what costs less than 0.25 m of height is flown with; else told, and lands; tumbling cuts"
        " the motors", _TWIN,
        (
            _one(_C.MOTOR, _K.WRONG, "front_left", 0.6, name="60percent"),
            _one(_C.MOTOR, _K.WRONG, "front_left", 0.8, name="80percent"),
            _one(_C.MOTOR, _K.OFF, "front_left", name="off", cannot_hover=True),
            _one(_C.MOTOR, _K.WRONG, "propeller", 0.8, name="propeller"),
            _one(_C.MOTOR, _K.WRONG, "all", 0.8, name="all_80percent"),
            _one(_C.BATTERY, _K.WRONG, "voltage", 1.5, name="sag"),
        ), True,
    ),
    FaultRow(
        "F23", "held by something: tether, load, fan, wind",
        "what costs less than 0.25 m of height is flown with; else told, and lands", _TWIN,
        (
            _one(_C.TETHER, _K.WRONG, size=1.2, name="tether"),
            _one(_C.PAYLOAD, _K.WRONG, size=0.02, name="20g"),
            _one(_C.PAYLOAD, _K.WRONG, size=0.05, name="50g"),
            _one(_C.FAN, _K.WRONG, size=2.0, name="fan"),
            _one(_C.WIND, _K.WRONG, size=1.0, name="wind"),
            _one(_C.WIND, _K.WRONG, "gust", 0.5, name="gusts"),
            _one(_C.WIND, _K.WRONG, "gust", 1.0, name="storm", is_extreme=True),
        ), True,
    ),
    FaultRow(
        "F24", "the pilot is killed",
        "hovers after 0.25 s, lands after 2 s; a fresh pilot does not fly on",
        LOCKSTEP | _PROCESS, (_one(_C.PILOT, _K.OFF, name="silent"),), True,
        covered_by="tests/drones/ardrone/test_commands.py"
        "::test_a_pilot_that_comes_back_after_the_watchdog_landed_does_not_fly_on",
    ),
    FaultRow(
        "F25", "the driver is killed",
        "the drone's own watchdog brakes and lands it; a fresh driver offers landing only",
        LOCKSTEP | _PROCESS,
        (FaultVariant("gone", (Fault(_C.COMMANDS, _K.OFF), Fault(_C.TELEMETRY, _K.OFF))),),
        covered_by="tests/twin/test_world.py"
        "::test_a_drone_without_its_client_flies_on_for_two_seconds_then_brakes_and_lands",
    ),
    FaultRow(
        "F26", "the browser of the pilot goes away in flight",
        "the errand is finished, then it hovers and lands", _USER,
        covered_by="tests/web/sockets/test_console.py"
        "::test_control_is_lost_three_seconds_after_its_holder_left"
        " tests/pilot/test_faults.py::test_a_drone_without_orders_comes_home_and_lands",
    ),
    FaultRow(
        "F27", "two people command at once",
        "the second is refused with the holder's name; STOP and Land from anyone", _USER,
        covered_by="tests/web/sockets/test_console.py::"
        "test_a_watcher_may_stop_and_land_and_nothing_else",
    ),
    FaultRow(
        "F28", "the web server is flooded, or a client reads slowly",
        "nobody else notices; STOP under 50 ms; the offender is cut off", _USER,
        covered_by="tests/web/sockets/test_console.py::"
        "test_a_flood_is_cut_down_but_stop_still_passes",
    ),
    FaultRow(
        "F29", "the disk is full or read-only, the database locked",
        "the flight goes on, and what is not written is said; no new take-off while a disk is full,"
        " or cannot be written to where flights are remembered or recorded", _PROCESS,
        covered_by="tests/app/test_hub_faults.py"
        "::test_a_memory_whose_disk_takes_no_more_says_so_and_the_flight_completes"
        " tests/app/test_disk_space.py"
        "::test_with_a_full_disk_nothing_takes_off_and_a_flight_goes_on"
        " tests/app/test_disk_space.py"
        "::test_where_nothing_can_be_written_nothing_takes_off_and_a_flight_goes_on",
    ),
    FaultRow(
        "F30", "power is lost while it writes",
        "the store opens and lost at most 1 s", _PROCESS,
        covered_by="tests/app/test_hub_faults.py::"
        "test_a_killed_hub_comes_back_with_all_but_the_last_second_and_the_flight_completes"
        " tests/hub/store/test_power_cut.py tests/app/test_killed_stores.py",
    ),
    FaultRow(
        "F31", "the wall clock is set", "nothing happens but a line in the log", _USER,
        covered_by="tests/hub/test_wall_clock.py"
        "::test_a_clock_set_back_does_not_freeze_where_things_are"
        " (the memory; pilot, driver and tokens use monotonic time only)",
    ),
    FaultRow(
        "F32", "the machine stalls for 0.3 to 1 s",
        "it was level before; hovers, goes on or lands, and says why", LOCKSTEP | _PROCESS,
        (
            _one(_C.PILOT, _K.OFF, lasting=0.3, name="0.3s"),
            _one(_C.PILOT, _K.OFF, lasting=1.0, name="1s"),
            _one(_C.PILOT, _K.INTERMITTENT, size=0.8, name="starved"),
        ),
    ),
    FaultRow(
        "F33", "a chair is put on the way",
        "stops before it; a new way within 0.3 s, or holds and tells", _TWIN,
        (
            _one(_C.OBSTACLES, _K.WRONG, size=1.0, name="1m"),
            _one(_C.OBSTACLES, _K.WRONG, size=1.5, name="1.5m"),
        ), True,
    ),
    FaultRow(
        "F34", "somebody steps in front, walks up to it, or crosses",
        "slower from 1.5 m on, three tenths at 1 m; keeps its distance, gives way when approached;"
        " never over people", _TWIN,
        (
            _one(_C.PEOPLE, _K.WRONG, size=1.5, name="stands"),
            _one(_C.PEOPLE, _K.WRONG, "walking", 1.0, name="walks_up"),
            _one(_C.PEOPLE, _K.WRONG, "walking", 1.5, name="head_on"),
            _one(_C.PEOPLE, _K.WRONG, "crossing", 1.0, name="crosses"),
            FaultVariant(
                "wrong_scanners",
                (
                    Fault(_C.LASER, _K.WRONG, magnitude=0.5),
                    Fault(_C.PEOPLE, _K.WRONG, start=14.0, magnitude=1.5),
                ),
                from_start=True,
            ),
        ), True,
    ),
    FaultRow(
        "F35", "a chair is put right beside the drone",
        "creeps to the nearest free place, or lands; never fails in silence", _TWIN,
        (_one(_C.OBSTACLES, _K.WRONG, size=0.65, name="0.65m"),),
    ),
    FaultRow(
        "F36", "the goal is in an obstacle, outside, or cannot be reached",
        "refused before anything moves, with the nearest free place", _USER,
        covered_by="tests/pilot/test_orders.py"
        "::test_an_order_that_cannot_be_done_is_refused_in_words_and_nothing_moves",
    ),
    FaultRow(
        "F37", "a second drone crosses", "it holds or makes way, 1 m apart", _USER,
        covered_by="tests/pilot/test_second_drone.py"
        "::test_a_second_drone_that_is_tracked_is_kept_clear_of",
    ),
    FaultRow(
        "F38", "the drone is exchanged or starts anew in a session",
        "not ready; the old goal is gone; its settings are read again", _TWIN | _PROCESS,
        (
            FaultVariant("silent_3s", (
                Fault(_C.COMMANDS, _K.OFF, duration=3.0),
                Fault(_C.TELEMETRY, _K.OFF, duration=3.0),
            )),
        ),
    ),
    FaultRow(
        "F39", "malformed packets on a wire",
        "nothing escapes the parser; counted; strangers are dropped", _USER,
        covered_by="tests/wires (properties of every parser) and tests/fuzz/test_corpus.py",
    ),
    FaultRow(
        "F40", "a publisher floods the bus", "the loop stays on time; the publisher is named",
        _USER,
        covered_by="tests/app/test_obstacle_inbox.py::test_a_flood_is_cut_down,"
        " tests/app/test_pilot_shell.py"
        "::test_a_flood_of_orders_is_named_and_stop_passes_it_at_once",
    ),
    FaultRow(
        "F41", "a bad configuration", "refused with the key and its range", _USER,
        covered_by="tests/config and tests/pilot/test_configurations.py",
    ),
    FaultRow(
        "F42", "the map is mirrored, turned or shifted",
        "no take-off until it is confirmed; else found, and landed", _TWIN,
        (
            FaultVariant("mirrored", (_mocap("map"),), from_start=True),
            FaultVariant("shifted_0.5m", (_mocap("origin_x", size=0.5),), from_start=True),
            FaultVariant("shifted_y_0.5m", (_mocap("origin_y", size=0.5),), from_start=True),
            FaultVariant("higher_0.6m", (_mocap("origin_z", size=0.6),), from_start=True),
            FaultVariant("lower_0.6m", (_mocap("origin_z", size=-0.6),), from_start=True),
            FaultVariant("turned", (_mocap("map_yaw", size=0.5),), from_start=True),
        ), True,
    ),
    FaultRow(
        "F43", "orders at the worst moment, and many of them",
        "defined for every state and event", _USER,
        covered_by="tests/pilot/test_orders.py"
        "::test_every_order_in_every_phase_leaves_the_pilot_sane"
        " tests/pilot/test_orders_and_faults.py",
    ),
    FaultRow(
        "F44", "somebody or something is on the pad",
        "shifts to a clear spot, or climbs and holds; told", _TWIN,
        (
            _one(_C.OBSTACLES, _K.WRONG, "pad", name="stool"),
            _one(_C.PEOPLE, _K.WRONG, "pad", name="child"),
            _one(_C.PEOPLE, _K.WRONG, "pad", name="unscanned_child", unscanned=True),
            _one(_C.OBSTACLES, _K.WRONG, "flat", name="flat_box", unscanned=True),
            _one(_C.OBSTACLES, _K.WRONG, "pole", name="pole", unscanned=True),
        ), True,
    ),
    FaultRow(
        "F45", "a hostile page or machine", "refused and logged; no command reaches the drone",
        _USER,
        covered_by="tests/web/test_server.py::test_a_page_of_another_site_cannot_open_a_socket,"
        " tests/bus/test_stop.py::test_a_replayed_datagram_does_nothing",
    ),
    *ONBOARD_ROWS,
)  # fmt: skip
"""The rows, in order."""
