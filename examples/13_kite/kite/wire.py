"""The lines of text that a Kite takes and sends: values to bytes and back, pure."""

from math import isfinite

from housefly import Action, Command, DroneStatus, PositionSetpoint, Sighting, Telemetry, WireError

PORT = 7001


def command_line(command: Command) -> bytes:
    """Return ``ACTION``, or ``FLY x y z yaw_rate`` [m, rad/s]."""
    place = command.position
    if command.action is not Action.FLY or place is None:
        return command.action.name.encode()
    return f"FLY {place.x:.4f} {place.y:.4f} {place.z:.4f} {place.yaw_rate:.4f}".encode()


def command_of(line: bytes) -> Command:
    """Read it; raises WireError for anything else."""
    word, *numbers = _words(line)
    if word not in Action.__members__ or len(numbers) != (4 if word == "FLY" else 0):
        raise WireError(f"no command of a Kite: {line[:60]!r}")
    return Command(
        Action[word], position=PositionSetpoint(*map(_number, numbers)) if numbers else None
    )


def pose_line(seen: Sighting, now: float) -> bytes:
    """Return ``POSE x y z w x y z age``: where it was so long ago [m, s]."""
    numbers = (*seen.pose.position, *seen.pose.orientation, now - seen.captured_at)
    return " ".join(["POSE", *(f"{number:.5f}" for number in numbers)]).encode()


def pose_of(line: bytes) -> tuple[float, ...]:
    """Read its eight numbers; raises WireError for anything else."""
    word, *numbers = _words(line)
    if word != "POSE" or len(numbers) != 8:
        raise WireError(f"no pose for a Kite: {line[:60]!r}")
    return tuple(map(_number, numbers))


def report_line(report: Telemetry) -> bytes:
    """Return ``STATUS battery height forward left theta phi psi time`` [m, m/s, rad, s]."""
    numbers = (report.battery, report.height, *report.velocity[:2])
    turned = (report.theta, report.phi, report.psi, report.drone_time or 0.0)
    return " ".join([report.status.name, *(f"{n:.5f}" for n in (*numbers, *turned))]).encode()


def report_of(line: bytes, now: float) -> Telemetry:
    """Read a report that arrives now [s]; raises WireError for anything else."""
    word, *words = _words(line)
    if word not in DroneStatus.__members__ or len(words) != 8:
        raise WireError(f"no report of a Kite: {line[:60]!r}")
    battery, height, forward, left, theta, phi, psi, time = map(_number, words)
    return Telemetry(
        received_at=now,
        status=DroneStatus[word],
        battery=battery,
        theta=theta,
        phi=phi,
        psi=psi,
        height=height,
        velocity=(forward, left, 0.0),
        drone_time=time,
    )


def _words(line: bytes) -> list[str]:
    return line.decode(errors="replace").split() or [""]


def _number(word: str) -> float:
    try:
        number = float(word)
    except ValueError as error:
        raise WireError(f"{word!r} is no number") from error
    if not isfinite(number):
        raise WireError(f"{word!r} is not finite")
    return number
