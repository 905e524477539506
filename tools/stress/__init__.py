"""Tries to break the time integration and writes docs/stability.md (scripts/stress)."""
