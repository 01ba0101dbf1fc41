"""Renders POV-Ray's scenes: ``minipov scene.pov`` on the command line, `render` from Python."""

__version__ = "0.1.0"
