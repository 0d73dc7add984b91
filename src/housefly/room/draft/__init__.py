"""A site that somebody is still describing: what is known, what is missing, and its files."""
