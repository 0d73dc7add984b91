"""The drone's pictures, passed on to browsers."""
