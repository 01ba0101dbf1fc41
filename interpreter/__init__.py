"""SDL to scene: ``load`` reads a scene file, runs it, and gives the scene graph.

>>> from minipov.interpreter import load_text
>>> scene = load_text("sphere { 0, 1 }")
>>> len(scene.objects)
1
"""

from minipov.interpreter.context import Options
from minipov.interpreter.errors import Message, Messages, SdlError, format_error
from minipov.interpreter.run import load, load_text, mistakes

__all__ = ["Message", "Messages", "Options", "SdlError", "format_error", "load", "load_text", "mistakes"]
