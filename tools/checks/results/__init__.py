"""The parts of tools/checks/same_results: what is solved, what is kept of a result, and when two results are the same."""
