"""The closed form beside the truss model, quantity by quantity and mesh by mesh."""
