"""Times of towform: scripts/bench."""
