"""Strangers' firmware on board of a simulated drone: our room is its world, in lock step.

``ardupilot_json``  what ArduPilot and its simulator say to each other, as bytes
``betaflight_fdm``  what Betaflight and its simulator say to each other
``rotors``          what the motors make of what they are told
``boarded``         such firmware as the computer of a simulated drone
``lock_step``       one step of the room for one answer of the program, over UDP
``beside``          the room beside a program that runs by its own clock
``program``         the program as a process, ``leashed`` to ours
``relay``           its wire, on the ports where its drivers look for it
``arducopter``      ArduCopter's own program, set as docs/drones/mavlink.md says
``betaflight``      Betaflight's own program
``programs``        which program flies which model, by the environment

No such program is part of this project: whoever has one names it.
"""
