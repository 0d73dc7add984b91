"""Logs of flights that anybody can look at again."""
