"""AR.Drone 2.0: AT commands, navdata, PaVE video, configuration.

Pure bytes to values and back, for the driver and the twin. Every parser of outside bytes raises
only ``WireError``, or never.

- ``at``: UDP 5556; ``encode_datagram`` writes the values of ``at_commands``, ``parse_datagram``
  reads them.
- ``command_encoder``: which commands say what the drone is to do, by its state.
- ``navdata``: UDP 5554; ``decode_navdata``, ``encode_navdata``, ``StateBits``; a packet without
  options is the bootstrap packet.
- ``navdata_options``: a dataclass for each tag 0..26, zero-filled, in ``OPTION_TYPES``.
- ``config``: TCP 5559 and CONFIG; values, dumps and ids of the keys in ``config_keys``.
- ``pave``: TCP 5555; ``encode_frame``, ``VideoReassembler``, ``KeyframeGate``.
- ``conversions``: the only place that knows both sign conventions.
"""
