"""What happened in the room, told as people would tell it."""
