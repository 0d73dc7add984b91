"""AR.Drone 2.0 driver; ``driver.ArDrone`` is what others use.

``settings``          what is written into the drone's configuration, and what a full stick means
``link``              UDP 5556, commands with their sequence numbers
``telemetry``         UDP 5554, reports
``handshake``         the acknowledged configuration, and TCP 5559
``limits_keeper``     writes our settings, and knows whether they are there
``video``             TCP 5555, pictures
``driver``            all of it as a ``drones.contract.DroneDriver``

``drones.failsafe`` decides what the drone is told, ``wires.ardrone.command_encoder`` how.
"""
