"""One server for all tests of a module."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from client import Client


@pytest.fixture(scope="module")
def client() -> Iterator[Client]:
    with Client() as started:
        yield started
