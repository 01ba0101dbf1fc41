"""What nodes of the scene graph promise: they never change, and are values."""

from __future__ import annotations

import copy
import dataclasses
import pickle

import pytest
from minipov.tracer.finish import Finish
from minipov.tracer.node import node, replace
from minipov.tracer.objects import Object
from minipov.tracer.shapes import Sphere


@node
class Glaze(Finish):
    """A node that has the fields of another and one more."""

    depth: float = 2.0


BALL = Object(Sphere((0.0, 0.0, 0.0), 1.0), source="a.pov:1")


def test_fields_cannot_be_assigned():
    with pytest.raises(dataclasses.FrozenInstanceError):
        BALL.source = ""
    with pytest.raises(dataclasses.FrozenInstanceError):
        replace(BALL, source="b").source = ""


def test_unknown_and_missing_fields_are_refused():
    with pytest.raises(TypeError):
        replace(BALL, colour=1.0)
    with pytest.raises(TypeError):
        Sphere((0.0, 0.0, 0.0))


def test_replaced_fields_and_kept_ones():
    moved = replace(BALL, source="b.pov:2")
    assert moved == Object(BALL.shape, source="b.pov:2") != BALL
    assert moved.shape is BALL.shape and type(moved) is Object
    assert dataclasses.replace(BALL, source="b.pov:2") == moved


@pytest.mark.parametrize("twin", [copy.copy, copy.deepcopy, lambda thing: pickle.loads(pickle.dumps(thing))])
def test_twins_are_equal(twin):
    assert twin(BALL) == BALL
    assert hash(twin(BALL)) == hash(BALL)
    assert repr(twin(BALL)) == repr(BALL)


def test_inherited_fields():
    glaze = Glaze(phong=0.5, depth=3.0)
    assert (glaze.phong, glaze.depth, glaze.diffuse) == (0.5, 3.0, 0.6)
    assert replace(glaze, phong=0.0) == Glaze(depth=3.0)
    assert isinstance(glaze, Finish) and [field.name for field in dataclasses.fields(Glaze)][-1] == "depth"
