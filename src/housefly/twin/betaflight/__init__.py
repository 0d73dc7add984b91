"""A simulated drone with Betaflight, on its real wire.

``receiver``   sticks, how old they are, and what stands in for them
``failsafe``   what it does once they stay away
``firmware``   arming, modes, ANGLE and rates: sticks to thrust and torques
``server``     MSP over TCP
"""
