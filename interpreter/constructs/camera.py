"""SDL: ``camera { perspective location <0,2,-5> look_at 0 angle 50 aperture 0.1 blur_samples 20 }``."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Final

from minipov.interpreter.constructs.camera_frame import Frame, difference, length
from minipov.interpreter.constructs.common import Field, number, read_fields, unexpected, unread
from minipov.interpreter.constructs.fields import read_function
from minipov.interpreter.constructs.normal import SMOOTH, read_normal
from minipov.interpreter.constructs.pigment import default_pigment, read_pigment
from minipov.interpreter.constructs.transforms import TRANSFORM_WORDS, read_transform, read_transforms
from minipov.interpreter.context import Context
from minipov.interpreter.errors import SdlError
from minipov.interpreter.items import Block, Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.camera import Camera, CameraKind, FocalBlur, MeshCamera, UserDefinedCamera
from minipov.tracer.function import Function
from minipov.tracer.node import replace
from minipov.tracer.normal import Normal
from minipov.tracer.objects import Object
from minipov.tracer.shapes import Mesh
from minipov.tracer.transform import Transform

KINDS: Final[dict[str, CameraKind]] = {
    "perspective": "perspective",
    "orthographic": "orthographic",
    "fisheye": "fisheye",
    "ultra_wide_angle": "ultra_wide_angle",
    "omnimax": "omnimax",
    "panoramic": "panoramic",
    "spherical": "spherical",
    "user_defined": "user_defined",
}
CYLINDERS: Final[tuple[CameraKind, ...]] = ("cylinder1", "cylinder2", "cylinder3", "cylinder4")
VECTORS: Final = ("right", "direction", "angle", "up", "sky", "location", "look_at", "focal_point")
ORDER: Final = (*VECTORS, "transform")
"""The order in which the parts of a camera act since version 3.5."""

BLUR_FIELDS: Final[dict[str, Field]] = {
    "aperture": number("aperture"),
    "confidence": number("confidence"),
    "variance": number("variance"),
}
ACCEPTS: Final = (
    *KINDS,
    *VECTORS,
    *BLUR_FIELDS,
    *TRANSFORM_WORDS,
    *("cylinder", "mesh_camera", "blur_samples", "bokeh", "normal"),
)
ORDERED: Final = 3.5
ASPECT_OF_IMAGE: Final = 3.8


@dataclass(slots=True)
class _Said:
    """What stands in a camera block."""

    steps: list[tuple[str, Any]] = field(default_factory=list)
    blur: dict[str, Any] = field(default_factory=dict)
    rest: dict[str, Any] = field(default_factory=dict)
    vertical_angle: float | None = None
    bare_angle: bool = False


@construct(
    "camera",
    signature="[type] [location V] [look_at V] [angle F] [right V] [up V] [sky V] [aperture F ...] | identifier",
    doc="From where and how the picture is taken.",
    accepts=ACCEPTS,
)
def camera(reader: ItemReader, context: Context, sink: Sink) -> Camera:
    named = reader.node(Camera)
    if named is not None:
        return moved(named, read_transforms(reader, context))
    frame = _start(context)
    said = _Said()
    _read_kind(reader, frame, said)
    if frame.kind == "spherical":
        frame.angle, said.vertical_angle = 360.0, 180.0
    while not reader.at_end:
        if not (_read_vector(reader, context, frame, said) or _read_other(reader, context, frame, said)):
            unexpected(reader, ACCEPTS)
    return _built(frame, said, sink, context)


def moved(camera: Camera, transform: Transform) -> Camera:
    """The camera carried along by a transformation."""
    functions = camera.user_defined
    return replace(
        camera,
        location=transform.point(camera.location),
        direction=transform.direction(camera.direction),
        right=transform.direction(camera.right),
        up=transform.direction(camera.up),
        user_defined=functions and replace(functions, transform=functions.transform.then(transform)),
    )


def plain_camera(context: Context) -> Camera:
    """The camera of a scene that has none, whatever its `#default` says."""
    if context.version >= ASPECT_OF_IMAGE:
        return Camera(right=(context.options.width / context.options.height, 0.0, 0.0))
    return Camera()


def _start(context: Context) -> Frame:
    default = context.default_camera
    if not isinstance(default, Camera):
        default = plain_camera(context)
    return Frame(location=default.location, direction=default.direction, right=default.right, up=default.up)


def _read_kind(reader: ItemReader, frame: Frame, said: _Said) -> None:
    word = reader.word_of(KINDS)
    if word is not None:
        frame.kind = KINDS[word]
        _read_kind(reader, frame, said)
    elif reader.word("cylinder"):
        kind = reader.integer()
        if not 1 <= kind <= len(CYLINDERS):
            reader.refuse("a cylinder camera from 1 to 4")
        frame.kind = CYLINDERS[kind - 1]
        _read_kind(reader, frame, said)
    else:
        mesh = reader.block("mesh_camera")
        if mesh is not None:
            frame.kind = "mesh_camera"
            said.rest["mesh"] = mesh


def _read_vector(reader: ItemReader, context: Context, frame: Frame, said: _Said) -> bool:
    """One of the keywords that act on the frame."""
    word = reader.word_of(VECTORS)
    if word is None:
        return False
    if word == "angle":
        if not reader.is_number() and frame.kind == "orthographic":
            said.bare_angle = True
            return True
        angle = reader.float()
        if frame.kind == "mesh_camera":
            reader.refuse("no angle: that of a mesh_camera lies in its meshes")
        if angle < 0.0:
            reader.refuse("an angle that is not negative")
        if frame.kind in ("perspective", "orthographic"):
            if angle >= 180.0:
                reader.refuse("an angle below 180 degrees")
            if angle == 0.0:
                # The same as none, which takes back one before it.
                said.steps = [step for step in said.steps if step[0] != "angle"]
                said.bare_angle = True
                return True
        if frame.kind == "spherical":
            said.vertical_angle = reader.float() if reader.is_number() else angle / 2.0
        said.steps.append((word, angle))
    else:
        said.steps.append((word, reader.vector()))
    return True


def _read_other(reader: ItemReader, context: Context, frame: Frame, said: _Said) -> bool:
    """Transformations, focal blur, normals and the functions of a user_defined camera."""
    transform = read_transform(reader, context)
    if transform is not None:
        said.steps.append(("transform", transform))
        return True
    blur = read_fields(reader, BLUR_FIELDS)
    if blur is not None:
        said.blur.update(blur)
        return True
    if reader.word("blur_samples"):
        said.blur["blur_samples"] = _blur_samples(reader)
        return True
    items = unread(reader, "normal")
    if items is not None:
        said.rest["normal"] = read_normal(items, context, SMOOTH)
        return True
    normal = reader.node(Normal)
    if normal is not None:
        said.rest["normal"] = normal
        return True
    block = reader.node(Block)
    if block is not None and block.name == "bokeh":
        said.blur["bokeh"] = block.value
    elif block is not None and block.name in ("location", "direction"):
        if frame.kind != "user_defined":
            reader.refuse("the word user_defined in front of functions")
        old = said.rest.get("user_defined", UserDefinedCamera())
        said.rest["user_defined"] = replace(old, **{block.name: block.value})
    return block is not None


MOST_BLUR_SAMPLES: Final = 10_000
MOST_RAYS: Final = 10_000
UNFOCUSED: Final = 1.0
"""At which distance things are sharp if the scene does not say it, whatever the length of ``direction`` (measured)."""


def _blur_samples(reader: ItemReader) -> tuple[int, int]:
    first = reader.count(MOST_BLUR_SAMPLES)
    if not reader.is_number():
        if first == 0:
            reader.refuse("at least one sample")
        return (4 if first < 7 else 7, first)
    second = reader.count(MOST_BLUR_SAMPLES)
    if first > second:
        reader.refuse("a minimum that is not above the maximum")
    return (first, second)


def _built(frame: Frame, said: _Said, sink: Sink, context: Context) -> Camera:
    """The camera that the block describes: before version 3.5 the parts act as they stand, since then in `ORDER`."""
    modern = context.version >= ORDERED
    steps = sorted(said.steps, key=lambda step: ORDER.index(step[0])) if modern else said.steps
    moves = [step for step in steps if step[0] == "transform"] if modern else []
    try:
        for word, value in steps[: len(steps) - len(moves)]:
            frame.act(word, value)
    except ValueError as error:
        raise SdlError(f"camera: {error}", sink.place, "move one of them") from error
    if modern:
        frame.size_orthographic(said.bare_angle)
    for warning in frame.warnings:
        context.messages.warn(warning, sink.place)
    blur = _focal_blur(frame, said.blur)
    for word, value in moves:
        frame.act(word, value)
        if "user_defined" in said.rest:
            old = said.rest["user_defined"]
            said.rest["user_defined"] = replace(old, transform=old.transform.then(value))
    built = Camera(frame.kind, frame.location, frame.direction, frame.right, frame.up, focal_blur=blur, **said.rest)
    if frame.angle is not None:
        built = replace(built, angle=frame.angle)
    if said.vertical_angle is not None:
        built = replace(built, vertical_angle=said.vertical_angle)
    return built


def _focal_blur(frame: Frame, blur: dict[str, Any]) -> FocalBlur | None:
    if blur.get("aperture", 0.0) == 0.0 or "blur_samples" not in blur:
        return None
    point = frame.focal_point
    distance = 0.0 if point is None else length(difference(point, frame.location))
    return FocalBlur(**blur, focal_distance=distance or UNFOCUSED)


@construct("bokeh", signature="pigment {}", doc="The shape of blurred points: a pigment on the unit square.")
def bokeh(reader: ItemReader, context: Context, sink: Sink) -> Block:
    items = unread(reader, "pigment")
    if items is None:
        reader.fail("a pigment")
    return Block("bokeh", read_pigment(items, context, default_pigment(context)))


@construct(
    "mesh_camera",
    within=("camera",),
    signature="rays per pixel, distribution [max distance] mesh {} ... [smooth]",
    doc="A camera whose rays start on the faces of meshes.",
    accepts=("mesh", "smooth"),
)
def mesh_camera(reader: ItemReader, context: Context, sink: Sink) -> Block:
    rays = reader.count(MOST_RAYS)
    if rays == 0:
        reader.refuse("at least one ray per pixel")
    distribution = reader.integer()
    if not 0 <= distribution <= 3:
        reader.refuse("a distribution from 0 to 3")
    if distribution >= 2 and rays != 1:
        reader.refuse("one ray per pixel for the distributions 2 and 3")
    distance = reader.float() if reader.is_number() else None
    meshes: list[Object] = []
    while (mesh := reader.node(Object)) is not None:
        if not isinstance(mesh.shape, Mesh):
            reader.refuse("meshes")
        meshes.append(mesh)
    if not meshes:
        reader.fail("a mesh")
    if distribution == 0 and rays > len(meshes):
        reader.refuse("as many meshes as rays per pixel for the distribution 0")
    smooth = reader.word("smooth") is not None
    if smooth and distribution != 3:
        reader.refuse("the distribution 3 for smooth")
    if not reader.at_end:
        unexpected(reader, ("mesh", "smooth"))
    return Block("mesh_camera", MeshCamera(rays, distribution, tuple(meshes), distance, smooth))


def _three_functions(name: str) -> Callable[[ItemReader, Context, Sink], Block]:
    @construct(
        name,
        within=("camera",),
        signature="function {} function {} function {}",
        doc=f"The {name} of each ray of a user_defined camera (3.8).",
        accepts=("function",),
    )
    def read(reader: ItemReader, context: Context, sink: Sink) -> Block:
        functions: tuple[Function, Function, Function] = (
            read_function(reader),
            read_function(reader),
            read_function(reader),
        )
        return Block(name, functions)

    return read


_three_functions("location")
_three_functions("direction")
