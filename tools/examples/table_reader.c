/* Reads a table of bem_contact (HDF5) and interpolates in it: as table_reader.py, with the same arguments.

       cc table_reader.c -o table_reader $(pkg-config --cflags --libs hdf5-serial) -lhdf5_hl -lm            */
#include <hdf5.h>
#include <hdf5_hl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { most_axes = 8, name_length = 100 };
typedef struct {
  int axes, points[most_axes];
  double *axis[most_axes], *values; /* values: the last axis runs fastest */
} Table;

static double* array(hid_t file, const char* group, const char* name, size_t* count) {
  char path[2 * name_length];
  hsize_t size[most_axes] = {0};
  int rank = 0;
  double* out;
  snprintf(path, sizeof path, "%s/%s", group, name);
  if (H5LTget_dataset_ndims(file, path, &rank) < 0 || H5LTget_dataset_info(file, path, size, NULL, NULL) < 0)
    exit(fprintf(stderr, "the table has no %s\n", path));
  for (*count = 1; rank > 0; --rank)
    *count *= size[rank - 1];
  out = malloc(*count * sizeof *out);
  H5LTread_dataset_double(file, path, out);
  return out;
}

static Table read_table(hid_t file, const char* column) {
  Table t = {0, {0}, {0}, 0};
  char names[most_axes * name_length], *name;
  size_t count;
  H5LTget_attribute_string(file, "/", "axes", names);
  for (name = strtok(names, " "); name; name = strtok(NULL, " ")) {
    t.axis[t.axes] = array(file, "axes", name, &count);
    t.points[t.axes++] = (int)count;
  }
  t.values = array(file, "values", column, &count);
  return t;
}

/* Cubic in each coordinate, by the slopes of parabolas through three points; constant beyond the ends.
   Begin with axis 0 and index 0. */
static double value(const Table* t, const double* at, int axis, size_t index) {
  const double* x = t->axis[axis];
  int n = t->points[axis], i = 0;
  double h, k, share, low, high, chord, first, last;
  if (axis == t->axes)
    return t->values[index];
  while (i < n - 2 && at[axis] >= x[i + 1])
    ++i;
  h = x[i + 1] - x[i];
  share = fmin(fmax((at[axis] - x[i]) / h, 0), 1);
  index = index * n + i;
  low = value(t, at, axis + 1, index), high = value(t, at, axis + 1, index + 1);
  first = last = chord = (high - low) / h;
  if (i > 0)
    k = x[i] - x[i - 1], first = (h * (low - value(t, at, axis + 1, index - 1)) / k + k * chord) / (h + k);
  if (i < n - 2)
    k = x[i + 2] - x[i + 1], last = (k * chord + h * (value(t, at, axis + 1, index + 2) - high) / k) / (h + k);
  if (i == 0)
    first = 2 * chord - last;
  if (i == n - 2)
    last = 2 * chord - first;
  return low + share * h * (chord + (1 - share) * ((first - chord) * (1 - share) - (last - chord) * share));
}

/* Kalker's coefficient: linear between the points. */
static double coefficient(hid_t file, const char* name, double at) {
  size_t n, i = 0;
  double *x = array(file, "creep_scale", "log10_a_over_b", &n), *y = array(file, "creep_scale", name, &n);
  while (i + 2 < n && at >= x[i + 1])
    ++i;
  return y[i] + (y[i + 1] - y[i]) * fmin(fmax((at - x[i]) / (x[i + 1] - x[i]), 0), 1);
}

/* Fx, Fy (N) and Mz (N mm) on the rail; q: a, b (mm), G (MPa), mu N (N), xi, eta, phi (1/mm). */
static void creep_forces(hid_t file, const double* q, double* forces) {
  static const char *columns[] = {"Fx", "Fy", "Mz"}, *names[] = {"C11", "C22", "C23"};
  double log_ratio = log10(q[0] / q[1]), c = sqrt(q[0] * q[1]), unit = q[2] * c * c / q[3], k[3], at[4], x, y, z, w;
  double sign = q[5] < 0 ? -1 : 1, factor[3];
  int i;
  for (i = 0; i < 3; ++i)
    k[i] = coefficient(file, names[i], log_ratio);
  x = unit * k[0] / 3 * fabs(q[4]), y = sign * unit * k[1] / 3 * q[5], z = sign * unit * c * k[2] * q[6];
  w = sqrt(x * x + y * y + z * z);
  at[0] = log_ratio, at[1] = atan2(hypot(y, z), x), at[2] = atan2(z, y), at[3] = w / (1 + w);
  factor[0] = copysign(q[3], q[4]), factor[1] = sign * q[3], factor[2] = sign * q[3] * c;
  for (i = 0; i < 3; ++i) {
    Table t = read_table(file, columns[i]); /* your program reads each once */
    forces[i] = factor[i] * value(&t, at, 0, 0);
  }
}

int main(int count, char** words) {
  static const char* columns[] = {"Fx", "Fy", "Mz"};
  hid_t file = H5Fopen(count > 1 ? words[1] : "", H5F_ACC_RDONLY, H5P_DEFAULT);
  double numbers[most_axes] = {0}, forces[3];
  int i;
  if (file < 0)
    return 1;
  for (i = 2; i < count && i < most_axes + 2; ++i)
    numbers[i - 2] = atof(words[i]);
  if (H5Lexists(file, "creep_scale", H5P_DEFAULT) > 0)
    creep_forces(file, numbers, forces);
  else
    for (i = 0; i < 3; ++i) {
      Table t = read_table(file, columns[i]);
      forces[i] = value(&t, numbers, 0, 0);
    }
  printf("%.12g %.12g %.12g\n", forces[0], forces[1], forces[2]);
  return 0;
}
