"""Control gains and their margins, printed to the terminal."""

from __future__ import annotations

from math import degrees

from housefly.app.terminal import console, new_table
from housefly.lab.tuning.advice import Advice, GainQuestion, Judgement, stiffness_bound
from housefly.lab.tuning.loop import Loop
from housefly.lab.tuning.rate_loop import RateLoop
from housefly.lab.tuning.site_lines import SiteLines, as_toml

_SAME_DELAY = 0.0005
"""Delays that differ by less are the same [s]."""


def print_question(question: GainQuestion, gain: float) -> None:
    """Print drone and tracking system; ``gain`` is the static gain c / lambda."""
    loop = question.loop
    console.print(
        f"drone: lambda {loop.lag:.3g} 1/s, c/lambda {gain:.3g}, delay {1000 * loop.delay:.0f} ms"
        f"{_belief(loop)}, drag {loop.drag:.2g} 1/s\ntracking: {loop.tracking_hz:g} Hz,"
        f" {1000 * loop.latency:.0f} ms late, noise {1000 * question.noise:.2g} mm; filter of mode"
        f" {'paper' if loop.paper else 'default'}, loop at {loop.rate_hz:g} Hz"
    )


def _belief(loop: Loop) -> str:
    """Return what the pilot believes of the delay, if that differs."""
    if loop.paper or loop.model_delay is None or abs(loop.model_delay - loop.delay) < _SAME_DELAY:
        return ""
    return f" in all, of which the pilot knows {1000 * loop.model_delay:.0f} ms"


def print_advice(advice: Advice, question: GainQuestion, lines: SiteLines) -> None:
    """Print the chosen gains, their margins, and all that a site file must say for them."""
    print_judgement(advice.judgement, question)
    for name, law in (("K1 (yaw)", advice.yaw), ("K2 (height)", advice.height)):
        console.print(f"{name:<12} {law.gain:.2f} 1/s: {_words(law)}")
    console.print("\nfor the site file:\n")
    console.print(f"{as_toml(lines)}\n", markup=False, soft_wrap=True)
    level = lines.get("limits", {}).get("pose_age_level")
    if level is not None:
        console.print(
            f"tracking this slow needs a longer patience: when it loses the drone, that flies on by"
            f" its model for {level:g} s, not for less\n",
            soft_wrap=True,
        )


def _words(law: RateLoop) -> str:
    return (
        f"phase {degrees(law.phase):.0f} deg, gain {law.factor:.1f}, delay"
        f" {1000 * law.delay:.0f} ms"
    )


def print_judgement(judgement: Judgement, question: GainQuestion) -> None:
    """Print the margins of a pair of gains, and what objections there are."""
    loop = judgement.loop
    console.print(
        f"\n[bold]alpha {loop.alpha:.3g} 1/s, beta {loop.beta:.4g} 1/s^2[/bold] "
        f"(natural frequency {judgement.frequency:.2f} rad/s, damping {judgement.damping:.2f}), "
        f"Q {loop.acceleration_noise:.2g} m/s^2, R {1000 * loop.position_noise:.2g} mm"
    )
    table = new_table(())
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
