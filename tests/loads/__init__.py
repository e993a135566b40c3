"""Environmental forces, anchors and sinkers."""
