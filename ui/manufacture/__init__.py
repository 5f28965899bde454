"""Manufacture: docks Manufacture and Tolerances, dialog of the ball cutter."""
