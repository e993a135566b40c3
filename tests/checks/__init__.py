"""Tests of catopt.checks."""
