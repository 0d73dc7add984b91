"""The wire of a DJI Tello, SDK 1.3 to 3.0: values to bytes and back, pure.

``lines``         commands, UDP 8889 there
``answers``       what it answers, UDP 8889 back
``state``         its state, ten times a second, to UDP 8890
``pieces``        its pictures, H.264 in pieces of a datagram, to UDP 11111
``conversions``   the one place where its signs and units are converted to ours and back
"""
