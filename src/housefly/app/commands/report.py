"""``housefly report``: a report of a recording, also of one that others made."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from housefly.app.commands.subcommand import Subcommand
from housefly.app.terminal import console
from housefly.errors import ConfigError

if TYPE_CHECKING:
    from housefly.record.flight_log import FlightLog


def _add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument(
        "log",
        metavar="LOG",
        help="a recorded flight; rosbag, rosbag2, PX4 .ulg, dataflash .bin or Crazyflie CSV",
    )
    parser.add_argument(
        "--out", metavar="FILE.html", help="default: report.html in the folder, LOG.html beside it"
    )


def _run(options: Namespace) -> int:
    from housefly.app.flight_logs.read_log import is_own_recording, read_flight_log
    from housefly.app.flight_logs.rewritten_report import rewrite_report
    from housefly.record.log_report import write_log_report
    from housefly.record.mcap_reader import flight_file

    path = Path(options.log)
    if is_own_recording(path):
        file = flight_file(path)
        out = Path(options.out) if options.out else file.with_name("report.html")
        with _writing(out):
            rewrite_report(file, out)
    else:
        log, named = read_flight_log(path), path.resolve()
        out = Path(options.out) if options.out else named.with_name(f"{named.name}.html")
        with _writing(out):
            write_log_report(out, log, named.name)
        _tell(log)
    console.print(f"report: {out}", markup=False)
    return 0


def _tell(log: FlightLog) -> None:
    """Print what a log lacks, what is wrong with it, and its numbers."""
    from housefly.record.log_report import log_numbers

    for problem in log.problems:
        console.print(problem, markup=False)
    if log.lacks:
        console.print(f"this file holds no {', no '.join(log.lacks)}", markup=False)
    for name, value, digits, unit in log_numbers(log):
        if value is not None:
            console.print(f"{name}: {value:.{digits}f} {unit}".rstrip(), markup=False)


@contextmanager
def _writing(out: Path) -> Iterator[None]:
    """Raise ConfigError where the report cannot be written."""
    try:
        yield
    except OSError as error:
        raise ConfigError("--out", f"cannot be written ({error.strerror})", str(out)) from error


REPORT_COMMAND = Subcommand(
    name="report",
    help="a flight in pictures: a recording of ours, or a log of others",
    description=(
        "Write the report of a flight as one HTML file. A recording of Housefly gets the report"
        " that its flight had. Of others are read: rosbag 1 and 2, single MCAP files of ROS 2, PX4"
        " ulog, ArduPilot dataflash, and CSV of a Crazyflie's log variables. What a file lacks, and"
        " where it is cut, is said."
    ),
    add_arguments=_add_arguments,
    run=_run,
    epilog=(
        "examples:\n"
        "  housefly report mine\n"
        "  housefly report 12_30_05.ulg\n"
        "  housefly report hover.bag --out hover.html\n"
    ),
)
