"""Where to hover to see a place, a thing or a person."""
