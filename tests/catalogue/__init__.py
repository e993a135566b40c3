"""Tests of catopt.catalogue."""
