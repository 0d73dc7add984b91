"""``python -m housefly`` is the command line."""

import sys

from housefly.cli import main

if __name__ == "__main__":
    sys.exit(main())
