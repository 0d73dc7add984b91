"""Control gains and their margins, printed to the terminal."""

from __future__ import annotations

from math import degrees

from housefly.app.terminal import console, new_table
from housefly.lab.tuning.advice import Advice, GainQuestion, Judgement, stiffness_bound
from housefly.lab.tuning.rate_loop import RateLoop


def print_question(question: GainQuestion, gain: float) -> None:
    """Print drone and tracking system; ``gain`` is the static gain c / lambda."""
    loop = question.loop
    console.print(
        f"drone: lambda {loop.lag:.3g} 1/s, c/lambda {gain:.3g}, delay {1000 * loop.delay:.0f} ms,"
        f" drag {loop.drag:.2g} 1/s\ntracking: {loop.tracking_hz:g} Hz, {1000 * loop.latency:.0f}"
        f" ms late, noise {1000 * question.noise:.2g} mm; filter of mode"
        f" {'paper' if loop.paper else 'default'}, loop at {loop.rate_hz:g} Hz"
    )


def print_advice(advice: Advice, question: GainQuestion) -> None:
    """Print the chosen gains, their margins, and their lines for a site file."""
    print_judgement(advice.judgement, question)
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
