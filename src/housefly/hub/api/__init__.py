"""Questions to the room, its answers, and their JSON."""
