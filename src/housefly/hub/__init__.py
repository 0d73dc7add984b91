"""The room's memory: what every sensor tells goes in, what anybody asks comes out; nothing of the
flight waits for it.
"""
