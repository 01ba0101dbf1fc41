"""`python -m minipov scene.pov`."""

import sys

from minipov.cli import main

sys.exit(main())
