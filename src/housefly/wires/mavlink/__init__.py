"""MAVLink, as ArduCopter and PX4 speak it: values to bytes and back.

``dialect``      pymavlink's definitions of the common messages, loaded when first asked for
``framing``      bytes to messages and back; what is broken is counted
``frames``       the one place of NED and FRD
``setpoints``    SET_POSITION_TARGET_LOCAL_NED
``poses``        ODOMETRY, as a mocap room sends it
``requests``     heartbeats, commands, parameters, origin: what a ground station asks
``reports``      what a vehicle tells
``autopilots``   the table of what ArduCopter and PX4 do differently
"""
