"""Byte layouts of other people's protocols: pure encode and decode, used by drivers and by the
twin.
"""
