"""Light accounts of given figures."""

from workbench.optics.account import Account


def account_of(
    emitted: float,
    on_screen: float,
    off_screen: float,
    missed_lens: float,
    left_side: float,
    total_reflection: float,
    fresnel_entrance: float,
    fresnel_exit: float,
) -> Account:
    """The account of a lens."""
    lost = {
        "off_screen": off_screen,
        "missed_lens": missed_lens,
        "left_side": left_side,
        "total_reflection": total_reflection,
        "fresnel_entrance": fresnel_entrance,
        "fresnel_exit": fresnel_exit,
    }
    return Account(on_screen, lost, emitted)
