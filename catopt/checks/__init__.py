"""Checks: what a line has to withstand and keep, by named codes and by a user's own numbers."""
