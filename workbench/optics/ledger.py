"""The account of all light."""

from dataclasses import asdict, dataclass


@dataclass(frozen=True)
class Ledger:
    """Where the emitted flux went; all parts add up to ``emitted``.

    Attributes
    ----------
    emitted : float
        Flux of the source.
    on_screen, off_screen : float
        Flux of rays that reached the screen plane inside and outside the screen.
    missed_lens : float
        Flux that passed the entrance face by.
    left_side : float
        Flux that left the lens through its side.
    total_reflection : float
        Flux totally reflected at the exit face.
    fresnel_entrance, fresnel_exit : float
        Flux reflected at the faces where the rest was refracted.
    """

    emitted: float
    on_screen: float
    off_screen: float
    missed_lens: float
    left_side: float
    total_reflection: float
    fresnel_entrance: float
    fresnel_exit: float

    @property
    def efficiency(self) -> float:
        """Part of the emitted flux that lands on the screen."""
        return self.on_screen / self.emitted

    def to_data(self) -> dict[str, float]:
        """The parts by name, for JSON."""
        return asdict(self)
