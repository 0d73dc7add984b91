"""Site files shipped with Housefly."""
