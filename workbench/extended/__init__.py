"""Extended sources: their blur on a receiver, and the lower bound that it sets."""
