"""``housefly gains``: control gains and filter for one drone and one tracking system, with their
margins.
"""

from __future__ import annotations

import argparse
from math import degrees
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from rich.console import Console

from housefly.errors import ConfigError

if TYPE_CHECKING:
    from housefly.lab.tuning.advice import Advice, Judgement, Question
    from housefly.lab.tuning.rate_loop import RateLoop

console = Console(highlight=False)

DESCRIPTION = """Choose alpha, beta, K1, K2 and the Kalman filter's Q and R for a drone and a tracking system, or judge a pair.
Margins are of the loop as it is sampled: tracking rate and latency, command delay, attitude lag, zero-order hold and filter.
Exit code 0 only when every promise is kept; a pair with beta >= lambda * alpha is refused."""
EPILOG = """examples:
  housefly gains                                          # the shipped site's drone and tracking
  housefly gains --profile drone.toml --rate 30 --latency 0.05
  housefly gains --c 7 --lambda 7 --delay 0.06 --rate 10 --latency 0.1
  housefly gains --alpha 3.6 --beta 3.24 --rate 10 --latency 0.1    # judge a pair
"""


class Option(NamedTuple):
    """A number on the command line."""

    flag: str
    unit: str
    low: float
    high: float
    meaning: str


OPTIONS: tuple[Option, ...] = (
    Option("--c", "1/s", 0.05, 100.0, "c of paper eq. (22); the static gain is c / lambda"),
    Option("--lambda", "1/s", 0.5, 50.0, "lambda of paper eq. (22)"),
    Option("--delay", "s", 0.0, 0.5, "from command to first reaction"),
    Option("--drag", "1/s", 0.0, 5.0, "linear drag over mass"),
    Option("--rate", "Hz", 5.0, 400.0, "tracking frames per second"),
    Option("--latency", "s", 0.0, 0.5, "from exposure to arrival of a frame"),
    Option(
        "--jitter", "s", 0.0, 0.2, "largest extra latency; margins are those of the latest frames"
    ),
    Option("--noise", "m", 0.0, 0.1, "one sigma of a tracked coordinate"),
    Option("--alpha", "1/s", 0.01, 60.0, "damping gain to judge"),
    Option("--beta", "1/s^2", 0.01, 500.0, "stiffness gain to judge"),
    Option(
        "--step",
        "m",
        0.01,
        10.0,
        "largest jump of the reference (default: 0.5, a cell of the paper)",
    ),
    Option("--tilt-max", "rad", 0.02, 0.5, "largest pitch or roll"),
)


def add(actions: Any) -> None:
    """Add the command to the parser."""
    parser = actions.add_parser(
        "gains",
        help="choose control gains and filter for a drone and a tracking system, with margins",
        description=DESCRIPTION,
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "--site",
        default="bsen",
        metavar="SITE",
        help="what is not given comes from this site (default: bsen)",
    )
    parser.add_argument(
        "--profile", metavar="FILE", help="drone profile that housefly identify wrote"
    )
    for option in OPTIONS:
        metavar = option.unit.upper().replace("/", "_PER_") if option.unit.isalpha() else "N"
        parser.add_argument(
            option.flag, type=float, metavar=metavar, help=f"{option.meaning} [{option.unit}]"
        )
    parser.add_argument(
        "--mode", choices=("default", "paper"), help="whose filter (default: the site's)"
    )
    parser.add_argument("--out", metavar="DIR", help="write gains.png and gains.svg there")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Advise, or judge the pair that is given."""
    from housefly.lab.tuning.advice import advise, judge, routh_objection

    question, gain = _question(options)
    alpha, beta = options.alpha, options.beta
    if (alpha is None) != (beta is None):
        raise ConfigError("--alpha", "and --beta are judged together: give both or none")
    _tell_question(question, gain)
    if alpha is None:
        advice = advise(question)
        if advice is None:
            console.print(
                "[bold]no pair keeps every promise[/bold]: track faster, or with less latency; or"
                " make the step smaller"
            )
            return 1
        _tell_advice(advice, question)
        return _finish(advice.judgement, question, options.out)
    refusal = routh_objection(alpha, beta, question.loop.lag)
    if refusal:
        console.print(f"[bold]refused[/bold]: {refusal}")
        return 1
    judgement = judge(question, alpha, beta)
    _tell_judgement(judgement, question)
    return _finish(judgement, question, options.out)


def _finish(judgement: Judgement, question: Question, out: str | None) -> int:
    if out:
        from housefly.app.compiling import Part, compile_once
        from housefly.lab.tuning.picture import draw_judgement

        compile_once(Part.ENGINE, console.print)
        folder = Path(out)
        folder.mkdir(parents=True, exist_ok=True)
        with console.status("drawing the step response and the margins"):
            png, _ = draw_judgement(judgement, question, folder / "gains")
        console.print(f"drawn: {png}", soft_wrap=True)
    return 1 if judgement.objections else 0


def _question(options: argparse.Namespace) -> tuple[Question, float]:
    """Return what is asked and the static gain c / lambda."""
    from housefly.app.premises import read_site
    from housefly.config.profile import load_profile
    from housefly.lab.tuning.advice import Question
    from housefly.lab.tuning.loop import Loop

    constants = load_profile(Path(options.profile)) if options.profile else {}
    site = read_site(options.site, **{f"drone__{key}": value for key, value in constants.items()})
    given = {
        option.flag: _checked(option, getattr(options, option.flag[2:].replace("-", "_")))
        for option in OPTIONS
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
    question = Question(
        loop,
        noise=chosen("--noise", site.twin.mocap_noise),
        step=chosen("--step", 0.5),
        tilt_max=chosen("--tilt-max", site.limits.tilt_max),
        climb_lag=site.drone.climb_lag,
        yaw_lag=site.drone.yaw_lag,
    )
    return question, chosen("--c", site.drone.attitude_gain * lag) / lag


def _checked(option: Option, value: float | None) -> float | None:
    if value is not None and not option.low <= value <= option.high:
        raise ConfigError(
            option.flag,
            f"is {value:g}; allowed: a number from {option.low:g} to {option.high:g} {option.unit}",
        )
    return value


def _tell_question(question: Question, gain: float) -> None:
    loop = question.loop
    console.print(
        f"drone: lambda {loop.lag:.3g} 1/s, c/lambda {gain:.3g}, delay {1000 * loop.delay:.0f} ms,"
        f" drag {loop.drag:.2g} 1/s\ntracking: {loop.tracking_hz:g} Hz, {1000 * loop.latency:.0f}"
        f" ms late, noise {1000 * question.noise:.2g} mm; filter of mode"
        f" {'paper' if loop.paper else 'default'}, loop at {loop.rate_hz:g} Hz"
    )


def _tell_advice(advice: Advice, question: Question) -> None:
    _tell_judgement(advice.judgement, question)
    for name, law in (("K1 (yaw)", advice.yaw), ("K2 (height)", advice.height)):
        console.print(f"{name:<12} {law.gain:.2f} 1/s: {_words(law)}")
    loop = advice.judgement.loop
    console.print("\nfor the site file:\n")
    console.print(
        f"[control]\nalpha = {loop.alpha:.3g}\nbeta = {loop.beta:.4g}\nyaw_gain ="
        f" {advice.yaw.gain:.3g}\nheight_gain = {advice.height.gain:.3g}\nacceleration_noise ="
        f" {loop.acceleration_noise:.3g}\nposition_noise = {loop.position_noise:.3g}\n",
        markup=False,
    )


def _words(law: RateLoop) -> str:
    return (
        f"phase {degrees(law.phase):.0f} deg, gain {law.factor:.1f}, delay"
        f" {1000 * law.delay:.0f} ms"
    )


def _tell_judgement(judgement: Judgement, question: Question) -> None:
    from rich.table import Table

    from housefly.lab.tuning.advice import stiffness_bound

    loop = judgement.loop
    console.print(
        f"\n[bold]alpha {loop.alpha:.3g} 1/s, beta {loop.beta:.4g} 1/s^2[/bold] "
        f"(natural frequency {judgement.frequency:.2f} rad/s, damping {judgement.damping:.2f}), "
        f"Q {loop.acceleration_noise:.2g} m/s^2, R {1000 * loop.position_noise:.2g} mm"
    )
    table = Table(box=None, pad_edge=False)
    for heading in ("margins", "gain", "phase", "delay"):
        table.add_column(heading, justify="left" if heading == "margins" else "right")
    rows = [
        ("as identified", judgement.margins),
        *((f"lambda {100 * s - 100:+.0f} %", m) for s, m in judgement.wrong_lag),
    ]
    for name, margins in rows:
        table.add_row(
            name,
            f"{margins.gain:.2f}",
            f"{degrees(margins.phase):.0f} deg",
            f"{1000 * margins.delay:.0f} ms",
        )
    console.print(table)
    bound = stiffness_bound(question)
    console.print(
        f"a step of {question.step:g} m saturates nothing up to beta {bound:.2f} 1/s^2; Routh: beta"
        f" < {loop.lag * loop.alpha:.3g}"
    )
    console.print(
        f"expected position error in noise and moving air: {1000 * judgement.error:.0f} mm (one"
        " sigma)"
    )
    for objection in judgement.objections:
        console.print(f"  objection: {objection}")
