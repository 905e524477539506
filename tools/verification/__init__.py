"""Measures towform against exact and published answers and writes docs/verification.md (scripts/verify)."""
