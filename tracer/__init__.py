"""The scene graph and the core that renders it.

A scene can be built by hand from the dataclasses of this package:

>>> from minipov.tracer.scene import Scene
>>> from minipov.tracer.objects import Object
>>> from minipov.tracer.shapes import Sphere
>>> scene = Scene(objects=(Object(Sphere((0, 0, 5), 1)),))
"""
