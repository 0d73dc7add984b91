"""What may be asked of the room, and what it answers."""
