"""Tests of catopt."""
