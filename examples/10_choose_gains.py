"""Choose gains for a slow tracking system, and see what the shipped ones would do there.

Learns: margins are those of the loop as it is sampled; what a promise is; why mode paper must fly
    more cautiously.
Prints: for each tracking system the recommended pair with its margins, then what is said of alpha
    3.6, beta 3.24.
"""

from dataclasses import replace
from math import degrees

from housefly.lab.tuning.advice import GainQuestion, advise, judge
from housefly.lab.tuning.loop import Loop

DRONE = Loop(alpha=3.6, beta=3.24, lag=7.0, delay=0.06)

for rate, latency in ((100.0, 0.02), (30.0, 0.05), (10.0, 0.1)):
    for paper in (False, True):
        question = GainQuestion(replace(DRONE, tracking_hz=rate, latency=latency, paper=paper))
        advice = advise(question)
        assert advice is not None
        loop, margins = advice.judgement.loop, advice.judgement.margins
        where = (
            f"{rate:3.0f} Hz, {1000 * latency:3.0f} ms late, mode {'paper' if paper else 'default'}"
        )
        pair = f"alpha {loop.alpha:.1f}, beta {loop.beta:.2f}"
        print(
            f"{where}: {pair}; gain {margins.gain:.1f}, phase {degrees(margins.phase):.0f} deg,"
            f" {1000 * margins.delay:.0f} ms"
        )

verdict = judge(GainQuestion(replace(DRONE, tracking_hz=10.0, latency=0.1, paper=True)), 3.6, 3.24)
print(
    "alpha 3.6, beta 3.24 at 10 Hz in mode paper:",
    "; ".join(verdict.objections) or "keeps every promise",
)
