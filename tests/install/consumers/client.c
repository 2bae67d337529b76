/* Solves a scene for some forces and prints the largest pressure of each, in MPa. Standard error gets its stated error
 * (nan: Hertz's closed form has none) and the model. */
#include <conformal_contact.h>

#include <stdio.h>
#include <stdlib.h>

static void require(int code, conformal_contact* contact) {
  if (code != CONFORMAL_OK) {
    fprintf(stderr, "error: %s\n", conformal_message(contact));
    exit(1);
  }
}

int main(int argc, char** argv) {
  conformal_contact* contact = NULL;
  char message[1000];
  const char *model, *reason;
  double totals[CONFORMAL_TOTALS], errors[CONFORMAL_TOTALS];
  int force, i;
  if (argc < 2 || conformal_open_file(argv[1], &contact, message, sizeof message) != CONFORMAL_OK) {
    fprintf(stderr, "error: %s\n", argc < 2 ? "no scene was given" : message);
    return 1;
  }
  require(conformal_key(contact, "load.force", &force), contact);
  for (i = 1; i <= 3; ++i) {
    require(conformal_set_number(contact, force, 1e5 / i), contact);
    require(conformal_solve(contact), contact);
    require(conformal_totals(contact, totals, CONFORMAL_TOTALS), contact);
    require(conformal_total_errors(contact, errors, CONFORMAL_TOTALS), contact);
    require(conformal_model(contact, &model, &reason), contact);
    printf("%.17g\n", totals[CONFORMAL_PMAX]);
    fprintf(stderr, "+- %g MPa by %s (%s)\n", errors[CONFORMAL_PMAX], model, reason);
  }
  if (conformal_set_number(contact, force, -1.0) != CONFORMAL_WRONG_INPUT)
    return 1;
  conformal_close(contact);
  return 0;
}
