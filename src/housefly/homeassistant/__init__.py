"""Home Assistant: the room and its drones as entities over MQTT, and what is asked for there."""
