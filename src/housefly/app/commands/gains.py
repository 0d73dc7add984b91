"""``housefly gains``: control gains and filter for a drone and a tracking system."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from housefly.app.commands.subcommand import Subcommand
from housefly.app.terminal import console
from housefly.errors import ConfigError

if TYPE_CHECKING:
    from housefly.lab.tuning.advice import GainQuestion, Judgement

_DESCRIPTION = """\
Choose alpha, beta, K1, K2 and the Kalman filter's Q and R for a drone and a tracking system, \
or judge a pair.
Margins are of the loop as it is sampled: tracking rate and latency, command delay, attitude lag, \
zero-order hold and filter.
Exit code 0 only when every promise is kept; a pair with beta >= lambda * alpha is refused."""
_EPILOG = """examples:
  housefly gains                                          # the shipped site's drone and tracking
  housefly gains --profile drone.toml --rate 30 --latency 0.05
  housefly gains --c 7 --lambda 7 --delay 0.06 --rate 10 --latency 0.1
  housefly gains --alpha 3.6 --beta 3.24 --rate 10 --latency 0.1    # judge a pair
"""


class _GainOption(NamedTuple):
    """A number on the command line."""

    flag: str
    unit: str
    low: float
    high: float
    meaning: str


_GAIN_OPTIONS: tuple[_GainOption, ...] = (
    _GainOption("--c", "1/s", 0.05, 100.0, "c of paper eq. (22); the static gain is c / lambda"),
    _GainOption("--lambda", "1/s", 0.5, 50.0, "lambda of paper eq. (22)"),
    _GainOption("--delay", "s", 0.0, 0.5, "from command to first reaction"),
    _GainOption("--drag", "1/s", 0.0, 5.0, "linear drag over mass"),
    _GainOption("--rate", "Hz", 5.0, 400.0, "tracking frames per second"),
    _GainOption("--latency", "s", 0.0, 0.5, "from exposure to arrival of a frame"),
    _GainOption(
        "--jitter", "s", 0.0, 0.2, "largest extra latency; margins are those of the latest frames"
    ),
    _GainOption("--noise", "m", 0.0, 0.1, "one sigma of a tracked coordinate"),
    _GainOption("--alpha", "1/s", 0.01, 60.0, "damping gain to judge"),
    _GainOption("--beta", "1/s^2", 0.01, 500.0, "stiffness gain to judge"),
    _GainOption(
        "--step",
        "m",
        0.01,
        10.0,
        "largest jump of the reference (default: 0.5, a cell of the paper)",
    ),
    _GainOption("--tilt-max", "rad", 0.02, 0.5, "largest pitch or roll"),
)


def _add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--site",
        default="bsen",
        metavar="SITE",
        help="what is not given comes from this site (default: bsen)",
    )
    parser.add_argument(
        "--profile", metavar="FILE", help="drone profile that housefly identify wrote"
    )
    for option in _GAIN_OPTIONS:
        metavar = option.unit.upper().replace("/", "_PER_") if option.unit.isalpha() else "N"
        parser.add_argument(
            option.flag, type=float, metavar=metavar, help=f"{option.meaning} [{option.unit}]"
        )
    parser.add_argument(
        "--mode", choices=("default", "paper"), help="whose filter (default: the site's)"
    )
    parser.add_argument("--out", metavar="DIR", help="write gains.png and gains.svg there")


def _run(options: Namespace) -> int:
    """Advise, or judge the pair that is given."""
    from housefly.app.gains_report import print_advice, print_judgement, print_question
    from housefly.lab.tuning.advice import advise, judge, routh_objection

    question, gain = _question(options)
    alpha, beta = options.alpha, options.beta
    if (alpha is None) != (beta is None):
        raise ConfigError("--alpha", "and --beta are judged together: give both or none")
    print_question(question, gain)
    if alpha is None:
        advice = advise(question)
        if advice is None:
            console.print(
                "[bold]no pair keeps every promise[/bold]: track faster, or with less latency; or"
                " make the step smaller"
            )
            return 1
        print_advice(advice, question)
        return _finish(advice.judgement, question, options.out)
    refusal = routh_objection(alpha, beta, question.loop.lag)
    if refusal:
        console.print(f"[bold]refused[/bold]: {refusal}")
        return 1
    judgement = judge(question, alpha, beta)
    print_judgement(judgement, question)
    return _finish(judgement, question, options.out)


def _finish(judgement: Judgement, question: GainQuestion, out: str | None) -> int:
    if out:
        from housefly.app.compiling import CompiledPart, compile_once
        from housefly.lab.tuning.plots import draw_judgement

        compile_once(CompiledPart.ENGINE, console.print)
        folder = Path(out)
        folder.mkdir(parents=True, exist_ok=True)
        with console.status("drawing the step response and the margins"):
            png, _ = draw_judgement(judgement, question, folder / "gains")
        console.print(f"drawn: {png}", soft_wrap=True)
    return 1 if judgement.objections else 0


def _question(options: Namespace) -> tuple[GainQuestion, float]:
    """Return what is asked and the static gain c / lambda."""
    from housefly.app.loaded_site import read_site
    from housefly.config.profile import load_profile
    from housefly.lab.tuning.advice import GainQuestion
    from housefly.lab.tuning.loop import Loop

    constants = load_profile(Path(options.profile)) if options.profile else {}
    site = read_site(options.site, **{f"drone__{key}": value for key, value in constants.items()})
    given = {
        option.flag: _checked(option, getattr(options, option.flag[2:].replace("-", "_")))
        for option in _GAIN_OPTIONS
    }

    def chosen(flag: str, otherwise: float) -> float:
        value = given[flag]
        return otherwise if value is None else value

    lag = chosen("--lambda", site.drone.attitude_lag)
    loop = Loop(
        alpha=site.control.alpha,
        beta=site.control.beta,
        lag=lag,
        delay=chosen("--delay", site.drone.command_delay),
        drag=chosen("--drag", site.drone.drag),
        tracking_hz=chosen("--rate", site.twin.mocap_rate_hz),
        latency=chosen("--latency", site.twin.mocap_latency) + chosen("--jitter", 0.0),
        rate_hz=site.control.rate_hz,
        paper=(options.mode or site.mode) == "paper",
        acceleration_noise=site.control.acceleration_noise,
        position_noise=site.control.position_noise,
    )
    question = GainQuestion(
        loop,
        noise=chosen("--noise", site.twin.mocap_noise),
        step=chosen("--step", 0.5),
        tilt_max=chosen("--tilt-max", site.limits.tilt_max),
        climb_lag=site.drone.climb_lag,
        yaw_lag=site.drone.yaw_lag,
    )
    return question, chosen("--c", site.drone.attitude_gain * lag) / lag


def _checked(option: _GainOption, value: float | None) -> float | None:
    if value is not None and not option.low <= value <= option.high:
        raise ConfigError(
            option.flag,
            f"is {value:g}; allowed: a number from {option.low:g} to {option.high:g} {option.unit}",
        )
    return value


GAINS_COMMAND = Subcommand(
    name="gains",
    help="choose control gains and filter for a drone and a tracking system, with margins",
    description=_DESCRIPTION,
    epilog=_EPILOG,
    add_arguments=_add_arguments,
    run=_run,
)
