"""The lens and its light in the formats of others: one file per format."""
