"""The other things that the room feels (paper: TMS_SS)."""
