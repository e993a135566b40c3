"""What catopt is measured by: `python -m benchmarks --list`."""
