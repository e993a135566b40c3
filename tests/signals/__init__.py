"""Signals at random times: no crash, nothing half written, a directory is of one answer."""
