"""The simulated motion capture system and the servers that it poses as."""
