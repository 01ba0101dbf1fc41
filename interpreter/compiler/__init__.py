"""SDL tree to Python ``ast`` to code object: never by way of source text.

Every node of the Python tree carries the line and column of the SDL it comes from, so that a Python traceback tells
where in the scene an error is. A file becomes a module: a function for its own items, and one for each macro.
"""
