"""The lens under a person's hands."""
