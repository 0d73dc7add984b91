"""Who may use the console, and what is written down of it."""
