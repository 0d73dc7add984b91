"""The console, server side."""
