/*
 * Look-ups in a packed table of contact forces: values, derivatives and stated errors in one call. C89, no library, no
 * memory of its own, no state: any number of threads may look up at the same time. `bem_contact table T.h5 --pack T.c`
 * writes a table and this text as one source.
 *
 * A packed table is an array of doubles:
 *     mark, layout, length of the array, axes, columns, the number of points of each axis,
 *     the points of the first axis (rising), of the second ...,
 *     the stated error of each column, then [first axis][second axis]...[column] the values.
 *
 * Between its points a table is cubic in each coordinate, with the slopes there of parabolas through three
 * neighbours: values and first derivatives are continuous.
 */
#ifndef CONFORMAL_PACKED_TABLE_H
#define CONFORMAL_PACKED_TABLE_H

#define CONFORMAL_PACKED_MARK 720190.0
#define CONFORMAL_PACKED_LAYOUT 1.0
#define CONFORMAL_PACKED_MOST_AXES 8
#define CONFORMAL_PACKED_MOST_COLUMNS 32

/* What conformal_packed_force() returns. */
#define CONFORMAL_PACKED_OK 0
#define CONFORMAL_PACKED_WRONG 2  /* no packed table, or more columns than it has */
#define CONFORMAL_PACKED_BEYOND 5 /* the point is outside the axes */

/* The points of one axis that make the value at a coordinate, and their weights in it and in its derivative. */
struct conformal_packed_axis {
  long points, first;
  int count;
  double weight[4], slope[4];
};

/* 1, of the length of an axis: a coordinate so little beyond its end is the end. */
#define CONFORMAL_PACKED_SLACK 1e-12

/* Returns 0 inside the axis, 1 above its upper end (and for nan), -1 below its lower one. */
static int conformal_packed_find(const double* x, struct conformal_packed_axis* out, double at)
{
  const long n = out->points;
  const double slack = CONFORMAL_PACKED_SLACK * (x[n - 1] - x[0]);
  long low = 0, high = n - 1;
  double h, s, first, last, first_slope, last_slope;
  int before, after, k;
  if (at < x[0] - slack)
    return -1;
  if (!(at <= x[n - 1] + slack))
    return 1;
  for (k = 0; k < 4; ++k)
    out->weight[k] = out->slope[k] = 0;
  out->first = 0;
  out->count = 1;
  out->weight[0] = 1;
  if (n == 1)
    return 0;
  while (high - low > 1) {
    const long middle = (low + high) / 2;
    if (x[middle] <= at)
      low = middle;
    else
      high = middle;
  }
  h = x[low + 1] - x[low];
  s = (at - x[low]) / h;
  s = s < 0 ? 0 : s > 1 ? 1 : s;
  before = low > 0;
  after = low + 2 < n;
  /* The chord + first (slope at the lower end - chord's) - last (slope at the upper end - chord's). At an end of the
   * axis the parabola of the other side goes on: there both differences are opposite numbers. */
  first = h * s * (1 - s) * (1 - s);
  last = h * s * s * (1 - s);
  first_slope = (1 - s) * (1 - 3 * s);
  last_slope = s * (2 - 3 * s);
  if (!before) {
    last += first;
    last_slope += first_slope;
  }
  if (!after) {
    first += last;
    first_slope += last_slope;
  }
  out->first = before ? low - 1 : low;
  out->count = 2 + before + after;
  out->weight[0] = 0;
  out->weight[before] = 1 - s;
  out->weight[before + 1] = s;
  out->slope[before] = -1 / h;
  out->slope[before + 1] = 1 / h;
  if (before) {
    const double d = x[low] - x[low - 1], a = h / (h + d);
    out->weight[0] -= first * a / d;
    out->weight[1] += first * a * (1 / d + 1 / h);
    out->weight[2] -= first * a / h;
    out->slope[0] -= first_slope * a / d;
    out->slope[1] += first_slope * a * (1 / d + 1 / h);
    out->slope[2] -= first_slope * a / h;
  }
  if (after) {
    const double d = x[low + 2] - x[low + 1], a = h / (h + d);
    double *w = out->weight + before, *v = out->slope + before;
    w[0] -= last * a / h;
    w[1] += last * a * (1 / h + 1 / d);
    w[2] -= last * a / d;
    v[0] -= last_slope * a / h;
    v[1] += last_slope * a * (1 / h + 1 / d);
    v[2] -= last_slope * a / d;
  }
  return 0;
}

/* The sum over the axes from this one on, below point number `index` of those before it. out: [1 + axes][columns],
 * values and then derivatives along each of these axes. */
static void conformal_packed_sum(const struct conformal_packed_axis* axis, int axes, const double* values, int stride,
                                 long index, int columns, double* out)
{
  double below[CONFORMAL_PACKED_MOST_AXES * CONFORMAL_PACKED_MOST_COLUMNS];
  const long first = index * axis->points + axis->first;
  const int others = (axes - 1) * columns;
  int k, c;
  if (axes == 1) {
    const double* of = values + first * stride;
    for (c = 0; c < columns; ++c, ++of) {
      double sum = 0, slope = 0;
      const double* one = of;
      for (k = 0; k < axis->count; ++k, one += stride) {
        sum += axis->weight[k] * *one;
        slope += axis->slope[k] * *one;
      }
      out[c] = sum;
      out[columns + c] = slope;
    }
    return;
  }
  for (c = 0; c < (1 + axes) * columns; ++c)
    out[c] = 0;
  for (k = 0; k < axis->count; ++k) {
    const double w = axis->weight[k], v = axis->slope[k];
    conformal_packed_sum(axis + 1, axes - 1, values, stride, first + k, columns, below);
    for (c = 0; c < columns; ++c) {
      out[c] += w * below[c];
      out[columns + c] += v * below[c];
    }
    for (c = 0; c < others; ++c)
      out[2 * columns + c] += w * below[columns + c];
  }
}

/*
 * The first `columns` columns at a point, which has one coordinate for each axis.
 *     values       [columns]
 *     derivatives  [columns][axes]: of each column along each axis; may be null
 *     errors       [columns]: stated, between the points and by the size of the elements; may be null
 *     beyond       0, or k (-k) where the point is beyond the upper (lower) end of axis k, from 1; may be null
 * Where it does not return CONFORMAL_PACKED_OK, nothing is written but `beyond`.
 */
static int conformal_packed_force(const double* packed, const double* at, int columns, double* values,
                                  double* derivatives, double* errors, int* beyond)
{
  struct conformal_packed_axis axis[CONFORMAL_PACKED_MOST_AXES];
  double sums[(1 + CONFORMAL_PACKED_MOST_AXES) * CONFORMAL_PACKED_MOST_COLUMNS];
  const double* x;
  int axes, stride, a, c;
  if (beyond)
    *beyond = 0;
  if (!packed || !at || !values || packed[0] != CONFORMAL_PACKED_MARK || packed[1] != CONFORMAL_PACKED_LAYOUT)
    return CONFORMAL_PACKED_WRONG;
  axes = (int)packed[3];
  stride = (int)packed[4];
  if (columns < 0 || columns > stride)
    return CONFORMAL_PACKED_WRONG;
  x = packed + 5 + axes;
  for (a = 0; a < axes; ++a) {
    int side;
    axis[a].points = (long)packed[5 + a];
    side = conformal_packed_find(x, &axis[a], at[a]);
    if (side != 0) {
      if (beyond)
        *beyond = side * (a + 1);
      return CONFORMAL_PACKED_BEYOND;
    }
    x += axis[a].points;
  }
  conformal_packed_sum(axis, axes, x + stride, stride, 0, columns, sums);
  for (c = 0; c < columns; ++c) {
    values[c] = sums[c];
    if (errors)
      errors[c] = x[c];
    for (a = 0; derivatives && a < axes; ++a)
      derivatives[c * axes + a] = sums[(1 + a) * columns + c];
  }
  return CONFORMAL_PACKED_OK;
}

#endif
