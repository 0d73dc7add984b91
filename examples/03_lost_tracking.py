"""Take the motion capture away for three seconds in mid-flight.

Needs: MuJoCo: the extra `twin`, which `make setup` brings.
Learns: the last gate watches the age of the pose. Older than 0.25 s: the drone holds itself. Older
    than 2 s: it lands, and a landing once begun is kept although the tracking comes back.
Prints: each change of the gate's verdict with its reason, and every event that people are told.
"""

from dataclasses import replace

import housefly

LOST_FROM, LOST_TO = 15.0, 18.0

GO = housefly.Order(housefly.OrderKind.GO, place="entrance")
simulation = housefly.Simulation(housefly.load_site("bsen"))
mode, phase = housefly.SafetyMode.NOMINAL, housefly.Phase.IDLE

while simulation.now < LOST_TO or phase is not housefly.Phase.IDLE:
    simulation.advance()
    is_waiting = phase is housefly.Phase.IDLE and simulation.now > 0.5
    inputs = simulation.inputs(GO) if is_waiting else simulation.inputs()
    if LOST_FROM <= simulation.now < LOST_TO:
        inputs = replace(inputs, sightings=())
    outputs = simulation.step(inputs).outputs
    for event in outputs.events:
        print(f"{simulation.now:6.2f} s  event     {event.text}")
    if outputs.safety is not mode:
        words = f"{outputs.command.action.value}; {outputs.reason or 'all is well'}"
        print(f"{simulation.now:6.2f} s  verdict   {outputs.safety.value}: {words}")
    mode, phase = outputs.safety, outputs.phase
