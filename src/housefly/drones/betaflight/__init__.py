"""Betaflight driver; ``driver.Betaflight`` is what others use.

``link``         TCP, UDP or a serial port, and who answers
``controller``   everything that the flight controller has told, as one report
``echo``         whether the channels that it flies by are ours
``checks``       what must be set on it before it takes off with us
``observer``     height and place between two poses, and what pushes
``height``       the height loop: from a climb rate that is wanted to throttle
``manoeuvres``   take-off, flight, standstill, landing: to sticks
``driver``       all of it as a ``drones.contract.DroneDriver``

``drones.failsafe`` decides what the drone is told, ``wires.betaflight`` how.
"""
