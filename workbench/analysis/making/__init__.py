"""The lens as made: errors by process, and plans for a shop."""
