"""The start page: jobs in real units, what they lead to, and their first scene."""
