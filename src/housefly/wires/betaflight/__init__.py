"""Betaflight's own wire, MSP: what a flight controller is asked, told, and answers. Pure.

``framing``      bytes of a stream to frames of MSP v1 and v2, and back
``commands``     numbers of the commands that are spoken here
``payloads``     fields of a payload, checked
``reports``      state, attitude, battery, channels
``settings``     how the controller is set: modes by switch, rates, receiver, failsafe
``arming``       why it does not arm, in its own words
``switches``     which switch positions arm it, and hold it level
``sticks``       tilt, turn and throttle as channels, its curves inverted
``endpoint``     where it answers: TCP, UDP, a serial port
"""
