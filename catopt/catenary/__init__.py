"""One line at rest, in closed form and by particle swarm."""
