"""Choose gains for a slow tracking system, and see what the shipped ones would do there.

Needs: nothing beside Housefly itself.
Learns: margins are those of the loop as it is sampled; what a promise is; why mode paper must fly
    more cautiously.
Prints: for each tracking system the recommended pair with its margins, then what is said of the
    shipped pair.
"""

from math import degrees

import housefly

for rate, latency in ((100.0, 0.02), (30.0, 0.05), (10.0, 0.1)):
    tracking = {"twin__mocap_rate_hz": rate, "twin__mocap_latency": latency}
    for mode in ("default", "paper"):
        advice = housefly.choose_gains(housefly.load_site("bsen", mode=mode, **tracking))
        assert advice is not None
        loop, margins = advice.judgement.loop, advice.judgement.margins
        where = f"{rate:3.0f} Hz, {1000 * latency:3.0f} ms late, mode {mode}"
        pair = f"alpha {loop.alpha:.1f}, beta {loop.beta:.2f}"
        phase = f"phase {degrees(margins.phase):.0f} deg"
        print(f"{where}: {pair}; gain {margins.gain:.1f}, {phase}, {1000 * margins.delay:.0f} ms")

slow = housefly.load_site("bsen", mode="paper", **tracking)
pair = f"alpha {slow.site.control.alpha}, beta {slow.site.control.beta}"
objections = housefly.judge_gains(slow).objections
print(f"{pair} at 10 Hz in mode paper:", "; ".join(objections) or "keeps every promise")
