"""A first lens by optimal transport: where the light should go, and a face for that."""

from workbench.design.transport.start import transport_start

__all__ = ["transport_start"]
