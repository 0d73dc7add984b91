"""The room's other senses: devices that tell where things are and what happened, one driver for
each way of speaking.
"""
