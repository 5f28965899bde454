"""A first lens by optimal transport: where the light should go, and faces for that."""

from workbench.design.transport.first import (
    First,
    behind_flat_entrance,
    first_of,
    first_of_several,
)
from workbench.design.transport.refit import refitted
from workbench.design.transport.shared import shared_start
from workbench.design.transport.start import transport_start

__all__ = [
    "First",
    "behind_flat_entrance",
    "first_of",
    "first_of_several",
    "refitted",
    "shared_start",
    "transport_start",
]
