"""SDL: objects in space: a shape with its place, texture and modifiers; ``union``, ``intersection``, ``light_group``.

Spaces: an `Object`'s ``transform`` carries its shape (and, for a union or CSG, its children with all that they wear)
into the parent's space. Its own texture, interior and clipping objects are already given in the parent's space.
"""

from __future__ import annotations

from typing import TypeAlias

from minipov.tracer import shapes
from minipov.tracer.interior import Interior
from minipov.tracer.lights import LightSource
from minipov.tracer.node import node, replace
from minipov.tracer.texture import Texture
from minipov.tracer.transform import IDENTITY, Transform


@node
class Union:
    """``union { ... }``: all the surfaces of all children."""

    children: tuple[Object, ...]
    lights: tuple[LightSource, ...] = ()
    split_union: bool = True


@node
class Merge:
    """``merge { ... }``: a union without its inner surfaces."""

    children: tuple[Object, ...]
    lights: tuple[LightSource, ...] = ()


@node
class Intersection:
    """``intersection { ... }``; ``difference`` is one whose later children are inverse."""

    children: tuple[Object, ...]
    lights: tuple[LightSource, ...] = ()
    cutaway_textures: bool = False


@node
class LightGroup:
    """``light_group { ... global_lights B }``: lights that shine only on the group's objects."""

    children: tuple[Object, ...]
    lights: tuple[LightSource, ...] = ()
    global_lights: bool = False


Shape: TypeAlias = (
    shapes.Sphere
    | shapes.Box
    | shapes.Cylinder
    | shapes.Cone
    | shapes.Plane
    | shapes.Disc
    | shapes.Torus
    | shapes.Quadric
    | shapes.Poly
    | shapes.Polygon
    | shapes.Triangle
    | shapes.SmoothTriangle
    | shapes.Mesh
    | shapes.BicubicPatch
    | shapes.Blob
    | shapes.HeightField
    | shapes.Isosurface
    | shapes.Parametric
    | shapes.JuliaFractal
    | shapes.Lathe
    | shapes.Lemon
    | shapes.Ovus
    | shapes.Prism
    | shapes.SphereSweep
    | shapes.Superellipsoid
    | shapes.Sor
    | shapes.Text
    | Union
    | Merge
    | Intersection
    | LightGroup
)


@node
class PhotonBehaviour:
    """``photons { target F reflection B refraction B collect B pass_through B }``; None where not said."""

    target: float | None = None
    reflection: bool | None = None
    refraction: bool | None = None
    collect: bool = True
    pass_through: bool = False


@node
class Modifiers:
    """The rarer object modifiers; ``hollow`` and the like are None where not said, so that CSG parents can decide.

    ``clipped_by`` and ``bounded_by`` stand in the space of the object's parent.
    """

    inverse: bool = False
    hollow: bool | None = None
    no_shadow: bool = False
    no_image: bool = False
    no_reflection: bool = False
    no_radiosity: bool = False
    double_illuminate: bool | None = None
    uv_mapping: bool = False
    photons: PhotonBehaviour | None = None
    radiosity_importance: float | None = None
    clipped_by: tuple[Object, ...] = ()
    bounded_by: tuple[Object, ...] = ()

    def transformed(self, transform: Transform) -> Modifiers:
        """The same, with clipping and bounding objects moved."""
        if not self.clipped_by and not self.bounded_by:
            return self
        return replace(
            self,
            clipped_by=tuple(o.transformed(transform) for o in self.clipped_by),
            bounded_by=tuple(o.transformed(transform) for o in self.bounded_by),
        )


NO_MODIFIERS = Modifiers()


@node
class Object:
    """A shape with its place and looks. Without a ``texture`` it wears its parent's.

    ``source`` is where the scene made it ("file:line"), for messages.
    """

    shape: Shape
    transform: Transform = IDENTITY
    texture: Texture | None = None
    interior_texture: Texture | None = None
    interior: Interior | None = None
    modifiers: Modifiers = NO_MODIFIERS
    source: str = ""

    def transformed(self, transform: Transform) -> Object:
        """The same object with everything that it wears, moved. Textures that lie on surface coordinates stay there."""
        if transform is IDENTITY:
            return self
        worn = IDENTITY if self.modifiers.uv_mapping else transform
        return Object(
            self.shape,
            self.transform.then(transform),
            self.texture and self.texture.transformed(worn),
            self.interior_texture and self.interior_texture.transformed(worn),
            self.interior and self.interior.transformed(transform),
            self.modifiers.transformed(transform),
            self.source,
        )
