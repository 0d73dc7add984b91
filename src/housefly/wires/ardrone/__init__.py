"""AR.Drone 2.0: AT commands, navdata, PaVE video, configuration.

Pure bytes-to-values and back; drivers and the twin share it. Every parser of outside bytes raises
only ``WireError``, or never.

``at``        UDP 5556. Values ``Ref Pcmd PcmdMag FlatTrim Calibrate Config ConfigIds Control
ComWatchdog Led Animation Pmode Misc
              Other``; ``encode(sequence, command)``, ``encode_datagram(first_sequence, commands)``,
              ``parse(datagram) -> Parsed(commands=(Numbered(sequence, command), ...),
              rejects=(text, ...))``.
``navdata``   UDP 5554. ``decode_navdata(bytes) -> NavdataPacket`` (``state``, ``has(bits)``,
``sequence``, ``option(Demo)``,
              ``decoded()``, ``unknown``), ``encode_navdata(state, sequence, options)``; no options
              = the bootstrap packet. ``DroneState`` names the state bits.
``navdata_options``  a dataclass for each tag 0..26 (``Demo() ... Wifi()`` are zero-filled, of the
right size); ``OPTIONS[tag]``. ``config``    TCP 5559 and CONFIG. ``BY_NAME[key]``,
``default_values()``, ``format_value``, ``parse_value``, ``encode_dump``,
              ``parse_dump``, ``encode_custom_list``, ``config_id(name)``, ``is_id``;
              ``config_keys.ConfigKey.needs_ids``.
``pave``      TCP 5555. ``PaveHeader``, ``encode_frame(header, payload)``,
``VideoReassembler().feed(bytes) -> frames``,
              ``KeyframeGate``.
``signs``     the only place that knows both sign conventions: ``telemetry_from_navdata``,
``pcmd_from_setpoint`` for the driver;
              ``stick_from_pcmd``, ``native_demo``, ``flu_from_frd`` for the twin.
"""
