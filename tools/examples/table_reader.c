/* Looks forces up in a table of bem_contact: as table_reader.py, with the same arguments.
       cc table_reader.c -o table_reader $(pkg-config --cflags --libs conformal_contact) */
#include <conformal_contact.h>
#include <stdio.h>
#include <stdlib.h>

int main(int count, char** words) {
  conformal_table* table;
  const char* name;
  char message[1000];
  double at[10] = {0}, values[100], errors[100];
  int axes, columns, i, code;
  for (i = 2; i < count && i < 12; ++i)
    at[i - 2] = atof(words[i]);
  if (conformal_table_open(count > 1 ? words[1] : "", &table, message, sizeof message) != CONFORMAL_OK)
    return puts(message), 2;
  conformal_table_size(table, &axes, &columns);
  if (count - 2 == CONFORMAL_ELLIPSE_VALUES) /* a table of creep forces: its columns are Fx, Fy and Mz */
    code = conformal_table_creep_forces(table, at, values, errors, message, sizeof message);
  else
    code = conformal_table_look_up(table, at, count - 2, values, errors, columns, message, sizeof message);
  for (i = 0; code == CONFORMAL_OK && i < columns; ++i)
    if (conformal_table_column(table, i, &name, NULL, NULL) == CONFORMAL_OK)
      printf("%s %.12g +- %.2g\n", name, values[i], errors[i]);
  conformal_table_close(table);
  return code == CONFORMAL_OK ? 0 : (puts(message), code);
}
