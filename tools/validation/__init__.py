"""The chapters of tests/VALIDATION.md: what was measured, beside what bem_contact computes."""
