"""A Kite: a drone that nobody sells. It takes lines of text over UDP, and flies to places."""
