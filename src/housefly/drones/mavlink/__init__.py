"""Driver of drones that speak MAVLink; ``driver.MavlinkDrone`` is what others use.

``link``         UDP or TCP, heartbeats, and who is heard
``vehicle``      what the vehicle has told, as one report
``refusals``     what it refused, in its own words
``orders``       what it is told in which order: modes, arming, take-off, setpoints
``checks``       what must be set on it, asked for until it is told
``driver``       all of it as a ``drones.contract.DroneDriver``

``drones.failsafe`` decides what the drone is told, ``wires.mavlink`` how.
"""
