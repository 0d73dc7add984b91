"""AR.Drone 2.0 driver; ``driver.ArDrone`` is what others use.

``orders``     pure: what to send next, the emergency toggle, the watchdog over the pilot
``numbering``  pure: sequence numbers and when they start again
``settings``   what is written into the drone's configuration, and what a full stick then means
``link``       UDP 5556, commands
``telemetry``  UDP 5554, reports
``handshake``  the acknowledged configuration, and TCP 5559
``video``      TCP 5555, pictures
``driver``     all of it as a ``drones.contracts.Drone``
"""
