"""SDL: ``mesh { triangle {...} smooth_triangle {...} }`` and ``mesh2 { vertex_vectors {...} face_indices {...} }``."""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from minipov.interpreter.constructs.common import unexpected
from minipov.interpreter.constructs.patches import is_degenerate
from minipov.interpreter.constructs.shape import shape
from minipov.interpreter.constructs.texture import TEXTURE_TYPES
from minipov.interpreter.context import Context
from minipov.interpreter.items import Block, Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.node import node, replace
from minipov.tracer.objects import Shape
from minipov.tracer.shapes import Mesh
from minipov.tracer.texture import Texture
from minipov.tracer.values import Vec2, Vec3
from numpy.typing import NDArray


@node
class Facet:
    """A triangle of a mesh; one texture for all corners, or three, or none."""

    corners: tuple[Vec3, Vec3, Vec3]
    normals: tuple[Vec3, Vec3, Vec3] | None
    uvs: tuple[Vec2, Vec2, Vec2] | None
    textures: tuple[Texture, ...]


class _Textures:
    """The textures of a mesh, each once."""

    def __init__(self) -> None:
        self.all: list[Texture] = []
        self._index: dict[int, int] = {}

    def index(self, texture: Texture) -> int:
        """The number of a texture; a new one is entered."""
        number = self._index.setdefault(id(texture), len(self.all))
        if number == len(self.all):
            self.all.append(texture)
        return number

    def corners(self, textures: tuple[Texture, ...]) -> tuple[int, int, int]:
        """The numbers for the three corners."""
        if not textures:
            return (-1, -1, -1)
        numbers = [self.index(texture) for texture in textures]
        return (numbers[0], numbers[0], numbers[0]) if len(numbers) == 1 else (numbers[0], numbers[1], numbers[2])


@shape(
    "mesh",
    signature="triangle {} smooth_triangle {} ... [inside_vector V] [hierarchy B]",
    doc="Many triangles as one object.",
    accepts=("triangle", "smooth_triangle", "inside_vector", "hierarchy"),
)
def mesh(reader: ItemReader, context: Context) -> Shape:
    facets: list[Facet] = []
    while isinstance(block := reader.peek(), Block) and block.name == "facet":
        reader.take()
        if block.value is not None:
            facets.append(block.value)
    if not facets:
        reader.refuse("at least one triangle")
    return replace(_mesh_of(facets), inside_vector=inside_vector(reader))


def inside_vector(reader: ItemReader) -> Vec3 | None:
    """``inside_vector V``: what makes a mesh solid."""
    if not reader.word("inside_vector"):
        return None
    vector = reader.vector()
    return None if vector == (0.0, 0.0, 0.0) else vector


def _mesh_of(facets: list[Facet]) -> Mesh:
    count = len(facets)
    textures = _Textures()
    own = np.arange(3 * count, dtype=np.int32).reshape(count, 3)
    smooth = [facet.normals for facet in facets]
    mapped = [facet.uvs for facet in facets]
    normals, normal_faces = _corner_table(smooth, 3)
    uvs, uv_faces = _corner_table(mapped, 2)
    numbers = [textures.corners(facet.textures) for facet in facets]
    return Mesh(
        np.array([facet.corners for facet in facets], dtype=np.float64).reshape(3 * count, 3),
        own,
        normals,
        normal_faces,
        uvs,
        uv_faces,
        tuple(textures.all),
        np.array(numbers, dtype=np.int32).reshape(count, 3) if textures.all else None,
    )


def _corner_table(rows: list[Any], size: int) -> tuple[NDArray[np.float64] | None, NDArray[np.int32] | None]:
    """Vectors at the corners of those faces that have them, and the faces' indices (-1 for the others)."""
    given = [row for row in rows if row is not None]
    if not given:
        return None, None
    faces = np.full((len(rows), 3), -1, dtype=np.int32)
    at = np.array([row is not None for row in rows])
    faces[at] = np.arange(3 * len(given), dtype=np.int32).reshape(-1, 3)
    return np.array(given, dtype=np.float64).reshape(-1, size), faces


TRIANGLE_ACCEPTS: Final = ("uv_vectors", "texture", "texture_list")


@construct(
    "triangle",
    within=("mesh",),
    signature="corner, corner, corner [uv_vectors V2, V2, V2] [texture {} | texture_list {}]",
    doc="A flat face of a mesh.",
    accepts=TRIANGLE_ACCEPTS,
)
def mesh_triangle(reader: ItemReader, context: Context, sink: Sink) -> Block:
    corners = (reader.vector(), reader.vector(), reader.vector())
    return _facet(reader, context, corners, None)


@construct(
    "smooth_triangle",
    within=("mesh",),
    signature="corner, normal, corner, normal, corner, normal [uv_vectors ...] [texture {} | texture_list {}]",
    doc="A face of a mesh, shaded as if it were curved.",
    accepts=TRIANGLE_ACCEPTS,
)
def mesh_smooth_triangle(reader: ItemReader, context: Context, sink: Sink) -> Block:
    a, na, b, nb, c, nc = (reader.vector() for _ in range(6))
    return _facet(reader, context, (a, b, c), (_usable(na), _usable(nb), _usable(nc)))


def _usable(normal: Vec3) -> Vec3:
    """A normal of no length becomes x, as in POV-Ray."""
    return normal if any(normal) else (1.0, 0.0, 0.0)


def _facet(
    reader: ItemReader, context: Context, corners: tuple[Vec3, Vec3, Vec3], normals: tuple[Vec3, Vec3, Vec3] | None
) -> Block:
    place = reader.place
    uvs: tuple[Vec2, Vec2, Vec2] | None = None
    textures: tuple[Texture, ...] = ()
    while not reader.at_end:
        if reader.word("uv_vectors"):
            uvs = (reader.vector2(), reader.vector2(), reader.vector2())
            continue
        texture = reader.node(TEXTURE_TYPES)
        if texture is not None:
            textures = (texture,)
            continue
        several = reader.block("texture_list")
        if several is None:
            unexpected(reader, TRIANGLE_ACCEPTS)
        textures = several
    if is_degenerate(*corners):
        context.messages.warn_once("degenerate", "degenerate triangles in a mesh are left out", place)
        return Block("facet", None)
    return Block("facet", Facet(corners, normals, uvs, textures))


@construct(
    "texture_list",
    within=("triangle", "smooth_triangle"),
    signature="texture texture texture",
    doc="A texture for each corner of a triangle.",
    accepts=("texture",),
)
def corner_textures(reader: ItemReader, context: Context, sink: Sink) -> Block:
    textures = all_textures(reader)
    if len(textures) != 3:
        reader.refuse("three textures")
    return Block("texture_list", textures)


def all_textures(reader: ItemReader) -> tuple[Texture, ...]:
    """The textures to the end of the block."""
    textures: list[Texture] = []
    while not reader.at_end:
        reader.comma()
        texture = reader.node(TEXTURE_TYPES)
        if texture is None:
            if reader.at_end:
                break
            reader.fail("a texture")
        textures.append(texture)
    return tuple(textures)
