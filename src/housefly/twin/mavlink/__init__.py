"""A simulated drone with ArduCopter or PX4 on board, on its MAVLink wire.

``parameters``   what is set on it
``vehicle``      modes, arming, take-off, setpoints, and what it does in silence
``tellings``     what it tells, as messages
``server``       UDP and TCP

What it does is what the autopilots' makers document, and what was measured on ArduCopter's own
program; docs/drones/mavlink.md says which is which.
"""
