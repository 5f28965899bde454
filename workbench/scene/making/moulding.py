"""Casting and moulding."""

from typing import Literal

from pydantic import ConfigDict

from workbench.scene.making.process import Process, Shrinkage


class Moulding(Process):
    """Casting or moulding: the element shrinks as it cures or cools."""

    model_config = ConfigDict(title="Casting or moulding")

    kind: Literal["moulding"] = "moulding"
    shrinkage: Shrinkage = 0.0

    @property
    def shrunk(self) -> float:
        """Its shrinkage."""
        return self.shrinkage
