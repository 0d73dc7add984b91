"""``housefly gains``: control gains and filter for a drone and a tracking system."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from housefly.app.commands.subcommand import Subcommand
from housefly.app.terminal import console
from housefly.errors import ConfigError

if TYPE_CHECKING:
    from housefly.config.site import Site
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
    _GainOption(
        "--delay", "s", 0.0, 0.5, "from command to first reaction, sending and inner loops included"
    ),
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
    alpha, beta = options.alpha, options.beta
    if (alpha is None) != (beta is None):
        raise ConfigError("--alpha", "and --beta are judged together: give both or none")
    console.print("loading drone, tracking and the model of the loop")
    from housefly.app.gains_report import print_judgement, print_question
    from housefly.lab.tuning.advice import judge, routh_objection

    site, question, gain = _question(options)
    print_question(question, gain)
    if alpha is None:
        return _advise(options, site, question)
    refusal = routh_objection(alpha, beta, question.loop.lag)
    if refusal:
        console.print(f"[bold]refused[/bold]: {refusal}")
        return 1
    with console.status("the margins of this pair"):
        judgement = judge(question, alpha, beta)
    print_judgement(judgement, question)
    return _finish(judgement, question, options.out)


def _advise(options: Namespace, site: Site, question: GainQuestion) -> int:
    from housefly.app.gains_report import print_advice
    from housefly.lab.tuning.advice import advise
    from housefly.lab.tuning.site_lines import site_lines

    with console.status("the fastest pair that keeps its margins") as status:
        advice = advise(question, status.update)
    if advice is None:
        console.print(
            "[bold]no pair keeps every promise[/bold]: track faster, or with less latency; or"
            " make the step smaller"
        )
        return 1
    print_advice(advice, question, site_lines(advice, question, site, _drone_lines(options)))
    return _finish(advice.judgement, question, options.out)


def _finish(judgement: Judgement, question: GainQuestion, out: str | None) -> int:
    if out:
        from housefly.app.compiling import CompiledPart, compile_once
        from housefly.lab.tuning.plots import draw_judgement

        compile_once(CompiledPart.ENGINE, console.print)
        folder = Path(out)
        folder.mkdir(parents=True, exist_ok=True)
        with console.status("drawing the step response and the margins"):
            png, _ = draw_judgement(judgement, question, folder / "gains")
        console.print(f"drawn: {png}", markup=False, soft_wrap=True)
    return 1 if judgement.objections else 0


def _question(options: Namespace) -> tuple[Site, GainQuestion, float]:
    """Return the site that was named, what is asked, and the static gain c / lambda."""
    from housefly.config.profile import load_profile
    from housefly.config.site import changed
    from housefly.lab.tuning.question import DEFAULT_STEP, question_of
    from housefly.sites.loaded_site import read_site

    given = _given(options)
    site = read_site(options.site, **({"mode": options.mode} if options.mode else {}))
    constants: dict[str, Any] = {}
    if options.profile:
        constants = {**load_profile(Path(options.profile)), "profile": options.profile}
    measured = changed(site, **{f"drone__{key}": value for key, value in constants.items()})
    question = question_of(measured, given.get("--step", DEFAULT_STEP))
    own = question.loop
    delay = given.get("--delay")
    loop = replace(
        own,
        lag=given.get("--lambda", own.lag),
        delay=own.delay if delay is None else delay,
        model_delay=own.model_delay if delay is None else delay,
        drag=given.get("--drag", own.drag),
        tracking_hz=given.get("--rate", own.tracking_hz),
        latency=given.get("--latency", own.latency) + given.get("--jitter", 0.0),
    )
    asked = replace(
        question,
        loop=loop,
        noise=given.get("--noise", question.noise),
        tilt_max=given.get("--tilt-max", question.tilt_max),
    )
    return site, asked, given.get("--c", measured.drone.attitude_gain * loop.lag) / loop.lag


def _given(options: Namespace) -> dict[str, float]:
    """Return the numbers of the command line that were given, by flag."""
    values = {
        option.flag: _checked(option, getattr(options, option.flag[2:].replace("-", "_")))
        for option in _GAIN_OPTIONS
    }
    return {flag: value for flag, value in values.items() if value is not None}


def _drone_lines(options: Namespace) -> dict[str, float | str]:
    """Return what a site's ``[drone]`` must say of the drone that was described."""
    given, lines = _given(options), dict[str, float | str]()
    if options.profile:
        lines["profile"] = options.profile
    for flag, key in (
        ("--lambda", "attitude_lag"),
        ("--delay", "command_delay"),
        ("--drag", "drag"),
    ):
        if flag in given:
            lines[key] = given[flag]
    if "--c" in given and "--lambda" in given:
        lines["attitude_gain"] = given["--c"] / given["--lambda"]
    return lines


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
