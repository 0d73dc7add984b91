"""What the console knows of the drone, and says in one line."""
