"""The other simulated sensors: scanners, depth cameras, MQTT devices."""
