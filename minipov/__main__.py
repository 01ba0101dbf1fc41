"""`python -m minipov scene.pov`."""

from minipov.cli import entry

entry()
