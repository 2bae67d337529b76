/* Compiled by a C89 compiler that takes nothing beyond the standard: the header must be as plain. */
#include "bem_contact/c/conformal_contact.h"

int c89_solve(conformal_contact* contact, double* totals);

int c89_solve(conformal_contact* contact, double* totals) {
  int code = conformal_solve(contact);
  return code == CONFORMAL_OK ? conformal_totals(contact, totals, CONFORMAL_TOTALS) : code;
}
