"""SDL: ``mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0,1,2> } }``."""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from minipov.interpreter.constructs.common import bulk
from minipov.interpreter.constructs.meshes import all_textures, inside_vector
from minipov.interpreter.constructs.shape import shape
from minipov.interpreter.context import Context
from minipov.interpreter.errors import SdlError
from minipov.interpreter.items import COMMA, Block, Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.objects import Shape
from minipov.tracer.shapes import Mesh
from numpy.typing import NDArray

SECTIONS: Final = (
    "vertex_vectors",
    "normal_vectors",
    "uv_vectors",
    "texture_list",
    "face_indices",
    "normal_indices",
    "uv_indices",
)
"""In the order in which they must stand."""


@shape(
    "mesh2",
    signature="vertex_vectors {} [normal_vectors {}] [uv_vectors {}] [texture_list {}] face_indices {} ...",
    doc="Many triangles as one object, their corners listed once.",
    accepts=(*SECTIONS, "inside_vector", "hierarchy"),
)
def mesh2(reader: ItemReader, context: Context) -> Shape:
    place = reader.place
    found: dict[str, Any] = {}
    last = -1
    while isinstance(block := reader.peek(), Block) and block.name in SECTIONS:
        at = SECTIONS.index(block.name)
        if at <= last:
            reader.fail(f"the sections in this order: {', '.join(SECTIONS)}")
        last = at
        found[block.name] = block.value
        reader.take()
    for needed in ("vertex_vectors", "face_indices"):
        if needed not in found:
            raise SdlError(f"mesh2: there is no {needed} section", place)
    faces, numbers = found["face_indices"]
    vertices = found["vertex_vectors"]
    _check(faces, len(vertices), "face_indices", reader)
    normals, normal_faces = _indexed(found, "normal", faces, len(vertices), reader)
    uvs, uv_faces = _indexed(found, "uv", faces, len(vertices), reader)
    textures = found.get("texture_list", ())
    if numbers is not None:
        if not textures:
            raise SdlError("mesh2: texture numbers in face_indices, but no texture_list", place)
        _check(numbers, len(textures), "texture numbers", reader, least=-1)
    return Mesh(vertices, faces, normals, normal_faces, uvs, uv_faces, textures, numbers, inside_vector(reader))


def _indexed(
    found: dict[str, Any], what: str, faces: NDArray[np.int32], vertices: int, reader: ItemReader
) -> tuple[NDArray[np.float64] | None, NDArray[np.int32] | None]:
    """Normals or uv vectors and their faces; without a section of indices they go with the vertices."""
    vectors, indices = found.get(f"{what}_vectors"), found.get(f"{what}_indices")
    if vectors is None:
        if indices is not None:
            reader.refuse(f"a section {what}_vectors for the {what}_indices")
        return None, None
    if indices is None:
        if len(vectors) != vertices:
            reader.refuse(f"{what}_indices, or as many {what}_vectors as vertices")
        return vectors, faces
    _check(indices, len(vectors), f"{what}_indices", reader)
    table = np.full((len(faces), 3), -1, dtype=np.int32)
    table[: len(indices)] = indices[: len(faces)]
    return vectors, table


def _check(indices: NDArray[np.int32], count: int, what: str, reader: ItemReader, least: int = 0) -> None:
    wrong = indices[(indices < least) | (indices >= count)]
    if wrong.size:
        raise SdlError(f"mesh2: {what} must be {least} to {count - 1}, found {wrong.flat[0]}", reader.place)


def _vectors(name: str, size: int, doc: str, within: tuple[str, ...] = ("mesh2",)) -> None:
    @construct(name, within=within, signature="count, vector, vector, ...", doc=doc)
    def read(reader: ItemReader, context: Context, sink: Sink) -> Block:
        count = reader.integer()
        vectors = bulk(reader, count, size, "vectors")
        _end(reader, name, count)
        return Block(name, vectors)


_vectors("vertex_vectors", 3, "The corners.")
_vectors("normal_vectors", 3, "Normals for smooth shading.")
_vectors("uv_vectors", 2, "Places on the unit square, for uv_mapping.")


def _indices(name: str, doc: str) -> None:
    @construct(name, within=("mesh2",), signature="count, <i, j, k>, ...", doc=doc)
    def read(reader: ItemReader, context: Context, sink: Sink) -> Block:
        count = reader.integer()
        indices = bulk(reader, count, 3, "triples of indices")
        _end(reader, name, count)
        return Block(name, indices.astype(np.int32))


_indices("normal_indices", "Which normals the corners of each face have.")
_indices("uv_indices", "Which uv vectors the corners of each face have.")


@construct(
    "face_indices",
    within=("mesh2",),
    signature="count, <i, j, k> [, texture number [, number, number]], ...",
    doc="The corners of each face, counted from 0, and its textures.",
)
def face_indices(reader: ItemReader, context: Context, sink: Sink) -> Block:
    count = reader.integer()
    faces: list[NDArray[np.float64]] = []
    numbers: dict[int, tuple[int, ...]] = {}
    have = 0
    while have < count:
        found = reader.rows(count - have, 3)
        if found:
            faces.append(np.array(found))
        else:
            reader.comma()
            item = reader.peek()
            rows = len(item.reshape(-1, item.shape[-1])) if isinstance(item, np.ndarray) else 1
            faces.append(bulk(reader, rows, 3, "triples of indices"))
        have += len(faces[-1])
        given = _texture_numbers(reader)
        if given:
            numbers[have - 1] = given
    _end(reader, "face_indices", count)
    table = _whole(np.concatenate(faces)) if faces else np.zeros((0, 3), dtype=np.int32)
    return Block("face_indices", (table, _texture_table(numbers, len(table))))


def _whole(numbers: NDArray[np.float64]) -> NDArray[np.int32]:
    """Indices; what can be none becomes one that no list has."""
    largest = np.iinfo(np.int32).max
    return np.nan_to_num(numbers, nan=-1).clip(-1, largest).astype(np.int32)


def _texture_numbers(reader: ItemReader) -> tuple[int, ...]:
    """Up to three numbers after a face."""
    numbers: list[int] = []
    while len(numbers) < 3 and reader.is_float():
        numbers.append(reader.integer())
    return (numbers[0],) * 3 if 0 < len(numbers) < 3 else tuple(numbers)


def _texture_table(numbers: dict[int, tuple[int, ...]], count: int) -> NDArray[np.int32] | None:
    if not numbers:
        return None
    table = np.full((count, 3), -1, dtype=np.int32)
    table[list(numbers)] = list(numbers.values())
    return table


@construct(
    "texture_list",
    within=("mesh2",),
    signature="count, texture {}, texture {} ...",
    doc="The textures that face_indices numbers.",
    accepts=("texture",),
)
def texture_list(reader: ItemReader, context: Context, sink: Sink) -> Block:
    count = reader.integer()
    textures = all_textures(reader)
    if len(textures) != count:
        reader.refuse(f"{count} textures", f"there are {len(textures)}")
    return Block("texture_list", textures)


def _end(reader: ItemReader, name: str, count: int) -> None:
    if reader.peek() is COMMA:
        reader.take()
    if not reader.at_end:
        reader.fail(f"the closing brace after {count} items", "is the count right?")
