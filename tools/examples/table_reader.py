#!/usr/bin/python3
"""Looks forces up in a table of bem_contact and prints them with their stated errors.

    table_reader.py creep.h5 6 4 82000 30000 0.001 0 0    # a, b (mm), G (MPa), mu N (N), xi, eta, phi (1/mm)
    table_reader.py forces.h5 0.5 6e4                     # of a scene: one number for each axis
"""

import sys

import bem_contact

table, numbers = bem_contact.read_table(sys.argv[1]), [float(word) for word in sys.argv[2:]]
if table.creep_scale:
    found = table.creep_forces(*numbers)
    errors = found.pop("errors")
else:
    found = table.look_up(numbers)
    errors = {name: error["stated"] for name, error in table.errors.items()}
for name, value in found.items():
    print(f"{name} {value:.12g} +- {errors[name]:.2g}")
