"""SDL: surfaces given by a polynomial: ``quadric``, ``cubic``, ``quartic``, ``poly``, ``polynomial``."""

from __future__ import annotations

from minipov.interpreter.constructs.common import long_vector
from minipov.interpreter.constructs.shape import shape
from minipov.interpreter.context import Context
from minipov.interpreter.items import Punctuation
from minipov.interpreter.reader import ItemReader
from minipov.tracer.objects import Shape
from minipov.tracer.shapes import Poly, Quadric

LARGEST_ORDER = 35


def term_count(order: int) -> int:
    """How many terms a polynomial of this order in x, y, z has."""
    return (order + 1) * (order + 2) * (order + 3) // 6


def term_index(order: int, x: int, y: int, z: int) -> int:
    """The place of the term x^x y^y z^z among the coefficients: by falling power of x, then y, then z."""
    rest = order - x
    before = rest * (rest + 1) * (rest + 2) // 6
    rest -= y
    return before + rest * (rest + 1) // 2 + rest - z


@shape("quadric", signature="<A,B,C>, <D,E,F>, <G,H,I>, J", doc="Ax²+By²+Cz²+Dxy+Exz+Fyz+Gx+Hy+Iz+J = 0.")
def quadric(reader: ItemReader, context: Context) -> Shape:
    return Quadric(reader.vector(), reader.vector(), reader.vector(), reader.float())


@shape("cubic", signature="<20 numbers> [sturm]", doc="A surface of third order.", accepts=("sturm",))
def cubic(reader: ItemReader, context: Context) -> Shape:
    return Poly(3, long_vector(reader, term_count(3), "coefficients"))


@shape("quartic", signature="<35 numbers> [sturm]", doc="A surface of fourth order.", accepts=("sturm",))
def quartic(reader: ItemReader, context: Context) -> Shape:
    return Poly(4, long_vector(reader, term_count(4), "coefficients"))


@shape("poly", signature="order, <coefficients> [sturm]", doc="A surface of order 2 to 35.", accepts=("sturm",))
def poly(reader: ItemReader, context: Context) -> Shape:
    order = _order(reader)
    return Poly(order, long_vector(reader, term_count(order), "coefficients"))


@shape(
    "polynomial",
    signature="order, xyz(i,j,k): F, ... [sturm]",
    doc="A surface of order 2 to 35, given by its terms; those not named are 0.",
    accepts=("sturm", "xyz"),
)
def polynomial(reader: ItemReader, context: Context) -> Shape:
    order = _order(reader)
    terms = [0.0] * term_count(order)
    reader.comma()
    while reader.word("xyz"):
        powers = _powers(reader)
        if min(powers) < 0 or sum(powers) > order:
            reader.refuse(f"powers that add up to at most {order}")
        reader.node(Punctuation)
        terms[term_index(order, *powers)] = reader.float()
        reader.comma()
    return Poly(order, tuple(terms))


def _powers(reader: ItemReader) -> tuple[int, int, int]:
    return (reader.integer(), reader.integer(), reader.integer())


def _order(reader: ItemReader) -> int:
    order = reader.integer()
    if not 2 <= order <= LARGEST_ORDER:
        reader.refuse(f"an order from 2 to {LARGEST_ORDER}")
    return order
