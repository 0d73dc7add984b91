"""DJI Tello driver; ``driver.Tello`` is what others use.

``sockets``        its three UDP ports on this machine, by network interface or address
``flight_watch``   whether it flies, which it does not say
``talk``           which lines are due
``pictures``       UDP 11111
``driver``         all of it as a ``drones.contract.DroneDriver``

``drones.failsafe`` decides what the drone is told, ``wires.tello`` how.
"""
