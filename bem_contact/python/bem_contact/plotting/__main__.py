"""`python3 -m bem_contact.plotting FILE [-o PICTURE]`: what the program runs for `bem_contact plot`."""

from .command import main

main()
