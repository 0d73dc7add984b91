"""The commands of the command line, one file each; heavy parts are imported when a command runs."""
