"""Tests of drawings as plain values."""
