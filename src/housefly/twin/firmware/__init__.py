"""Strangers' firmware on board of a simulated drone: our room is its world, in lock step.

``ardupilot_json``  what ArduPilot and its simulator say to each other, as bytes
``betaflight_fdm``  what Betaflight and its simulator say to each other
``boarded``         such firmware as the computer of a simulated drone, and its rotors
``lock_step``       one step of the room for one answer of the program, over UDP
``beside``          the room beside a program that runs by its own clock
``program``         the program as a process, ``leashed`` to ours
``relay``           its wire, on the ports where its drivers look for it
``arducopter``      ArduCopter's own program, set as docs/drones/mavlink.md says
``betaflight``      Betaflight's own program

Which of them flies which model stands in ``twin.drone_servers``. No such program is part of this
project: whoever has one names it.
"""
