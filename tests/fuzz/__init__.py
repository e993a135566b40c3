"""Files of every kind that catopt reads, broken at random: each is answered or refused in order."""
