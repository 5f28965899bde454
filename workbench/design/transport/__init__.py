"""A first design by optimal transport: where the light should go, and faces for that."""

from workbench.design.transport.first_design import (
    First,
    behind_flat_entrance,
    first_design,
    first_of,
)
from workbench.design.transport.refit import refitted
from workbench.design.transport.start import transport_start

__all__ = [
    "First",
    "behind_flat_entrance",
    "first_design",
    "first_of",
    "refitted",
    "transport_start",
]
