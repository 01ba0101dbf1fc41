"""All functions of the language: importing this module fills `signature.BUILTINS`."""

from minipov.interpreter.runtime import floats, objects, strings, vectors
from minipov.interpreter.runtime.signature import BUILTINS

__all__ = ["BUILTINS", "floats", "objects", "strings", "vectors"]
