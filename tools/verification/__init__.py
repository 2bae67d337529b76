"""What tools/verify and tools/stability share: calling the program, exact solutions, a dense solver, pages."""
