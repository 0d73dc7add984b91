"""Add a drone of your own: one that flies to places, takes lines of text, and has no hover.

Needs: the simulated room (``housefly[twin]``).
Learns: a drone is a folder (``13_kite/kite``: its wire, its driver, its side of the room),
    an airframe file in it, and the one line by which its package says so (``entry_points.txt``,
    which pip makes of ``pyproject.toml``). Nothing in Housefly knows of it.
Prints: what it can do, and how the visitor service went over its own wire, scored on the truth.
"""

import os
import sys
from pathlib import Path

import housefly

# what ``pip install ./13_kite`` would do for good
PACKAGE = str(Path(__file__).with_name("13_kite"))
sys.path.append(PACKAGE)
os.environ["PYTHONPATH"] = os.pathsep.join(filter(None, (PACKAGE, os.environ.get("PYTHONPATH"))))

site = housefly.load_site("bsen", drone__kind="kite", twin__video=False)
able = site.site.drone.airframe.capabilities
print(f"it is steered by {able.form.value}, and told where it is {able.external_pose_rate:g}/s")
print(f"it hovers by itself: {'yes' if able.hovers else 'no'}; camera: {able.camera or 'none'}")

phases: list[str] = []


def on_step(step: housefly.PilotStep) -> None:
    """Print each phase as it begins."""
    if step.outputs.phase.value not in phases[-1:]:
        phases.append(step.outputs.phase.value)
        print(f"{step.outputs.phase.value} (safety: {step.outputs.safety.value})", flush=True)


flight = housefly.fly("entrance", site, lockstep=False, on_step=on_step)
summary = flight.summary
error = f"{summary.rms_error_m:.3f} m" if summary.rms_error_m is not None else "not measured"
print(f"{flight.outcome}: true rms error {error}, {summary.contacts} touched")
replayed = flight.replay()
print(f"replayed: {replayed.difference or 'the same to the last bit'}")
print(f"steps that a busy machine did not record: {replayed.missing}")
flight.close()
