/* The bogie of bogie.py through a curve, in C99 without a library: its forces come from a packed table with derivatives.

       bem_contact table s1002_bogie.toml -o s1002_bogie.h5 --tolerance 0.05
       bem_contact table s1002_bogie.h5 --columns Fx,Fy,Mz,reference_y,T_gamma --pack bogie_table.c
       cc -O2 bogie.c -o bogie -lm && ./bogie

   bogie.py explains model and signs. Units mm, N, s, rad. ./bogie RADIUS SPEED SECONDS TRANSITION STEP has other values of these five.
   Exit codes: 0, 2 for wrong arguments or a table of something else, 3 where the motion leaves the table. */
#include "bogie_table.c"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COORDINATES = 6, STATE = 14, WHEELS = 4, INPUTS = 3, COLUMNS = 5, STAGES = 2, UNKNOWNS = STAGES * STATE };

static const double wheelset_mass = 1.5, wheelset_yaw = 8e5, wheelset_pitch = 1e5, frame_mass = 2.5, frame_yaw = 2.5e6;
static const double half_base = 1250, primary_lateral = 6e3, primary_yaw = 6e9, secondary_lateral = 400, secondary_damper = 40;
static const double secondary_yaw = 3e8, pivots = 9500, radius = 460, half_gauge = 750;

/* state' = matrix state + constant + the wheels; each wheel is given of_state state + of_curve, and acts by `into`. */
typedef struct {
  double matrix[STATE][STATE], constant[STATE];
  double of_state[WHEELS][INPUTS][STATE], of_curve[WHEELS][INPUTS], into[WHEELS][STATE][3];
  long look_ups;
} Bogie;

/* A spring of energy stiffness (stretch q + offset)^2 / 2, and a damper beside it. */
static void add_spring(Bogie* b, double stiffness, const double* stretch, double offset, double damper) {
  const double mass[COORDINATES] = {wheelset_mass, wheelset_yaw, wheelset_mass, wheelset_yaw, frame_mass, frame_yaw};
  int i, j;
  for (i = 0; i < COORDINATES; ++i) {
    for (j = 0; j < COORDINATES; ++j) {
      b->matrix[6 + i][j] -= stiffness * stretch[i] * stretch[j] / mass[i];
      b->matrix[6 + i][6 + j] -= damper * stretch[i] * stretch[j] / mass[i];
    }
    b->constant[6 + i] -= stiffness * offset * stretch[i] / mass[i];
  }
}

/* `curvature`: 1/mm, above 0 to the right. */
static Bogie make_bogie(double speed, double curvature) {
  static const double stretches[6][COORDINATES] = {{1, 0, 0, 0, -1, -1250}, {0, 0, 1, 0, -1, 1250}, {0, 1, 0, 0, 0, -1},
                                                   {0, 0, 0, 1, 0, -1},     {0, 0, 0, 0, 1, 0},     {0, 0, 0, 0, 0, 1}};
  const double lateral = half_base * half_base * curvature / 2, turn = half_base * curvature;
  Bogie b;
  int i, wheel;
  memset(&b, 0, sizeof b);
  for (i = 0; i < COORDINATES; ++i)
    b.matrix[i][6 + i] = 1;
  add_spring(&b, primary_lateral, stretches[0], lateral, 0);
  add_spring(&b, primary_lateral, stretches[1], lateral, 0);
  add_spring(&b, primary_yaw, stretches[2], turn, 0);
  add_spring(&b, primary_yaw, stretches[3], -turn, 0);
  add_spring(&b, secondary_lateral, stretches[4], 0, secondary_damper);
  add_spring(&b, secondary_yaw, stretches[5], pivots * curvature, 0);
  for (wheel = 0; wheel < WHEELS; ++wheel) { /* 1R, 1L, 2R, 2L; a left one is a mirror image */
    const int axle = wheel / 2, side = wheel % 2 ? -1 : 1;
    b.of_state[wheel][0][2 * axle] = side;
    b.of_state[wheel][1][2 * axle + 1] = side;
    b.of_state[wheel][1][6 + 2 * axle] = -side / speed;
    b.of_state[wheel][2][7 + 2 * axle] = -side * half_gauge / speed;
    b.of_state[wheel][2][12 + axle] = -1 / speed;
    b.of_curve[wheel][2] = -side * half_gauge * curvature;
    b.into[wheel][6 + 2 * axle][1] = -side / wheelset_mass;
    b.into[wheel][7 + 2 * axle][2] = -side / wheelset_yaw;
    b.into[wheel][12 + axle][0] = radius * radius / wheelset_pitch;
  }
  return b;
}

/* One look-up: Fx, Fy and the moment about the vertical through the middle of the track; slopes may be null. */
static void look_up(Bogie* b, int wheel, const double* state, double* all, double* errors, double* forces,
                    double slopes[3][INPUTS]) {
  static const char* const axes[INPUTS] = {"lateral", "yaw", "xi"};
  double at[INPUTS], derivatives[COLUMNS * INPUTS];
  const double *by_x = derivatives, *by_moment = derivatives + 2 * INPUTS, *by_arm = derivatives + 3 * INPUTS;
  int i, j, beyond;
  for (i = 0; i < INPUTS; ++i) {
    at[i] = b->of_curve[wheel][i];
    for (j = 0; j < STATE; ++j)
      at[i] += b->of_state[wheel][i][j] * state[j];
  }
  ++b->look_ups;
  if (conformal_packed_force(conformal_packed, at, COLUMNS, all, derivatives, errors, &beyond) != CONFORMAL_PACKED_OK) {
    if (beyond == 0)
      fprintf(stderr, "bogie_table.c is no table of Fx, Fy, Mz, reference_y and T_gamma\n"), exit(2);
    fprintf(stderr, "wheel %d leaves the table (%s is %g)\n", wheel, axes[abs(beyond) - 1], at[abs(beyond) - 1]), exit(3);
  }
  forces[0] = all[0];
  forces[1] = all[1];
  forces[2] = all[2] - all[3] * all[0];
  for (i = 0; slopes && i < INPUTS; ++i) {
    slopes[0][i] = by_x[i];
    slopes[1][i] = derivatives[INPUTS + i];
    slopes[2][i] = by_moment[i] - all[3] * by_x[i] - all[0] * by_arm[i];
  }
}

/* rate = state'; jacobian[i][j]: what rate i changes by with state j, from the table's derivatives; may be null. */
static void motion(Bogie* b, const double* state, double* rate, double jacobian[STATE][STATE]) {
  double all[COLUMNS], errors[COLUMNS], forces[3], slopes[3][INPUTS];
  int i, j, k, m, wheel;
  for (i = 0; i < STATE; ++i) {
    rate[i] = b->constant[i];
    for (j = 0; j < STATE; ++j)
      rate[i] += b->matrix[i][j] * state[j];
  }
  if (jacobian)
    memcpy(jacobian, b->matrix, sizeof b->matrix);
  for (wheel = 0; wheel < WHEELS; ++wheel) {
    look_up(b, wheel, state, all, errors, forces, jacobian ? slopes : NULL);
    for (i = 0; i < STATE; ++i)
      for (k = 0; k < 3; ++k) {
        const double share = b->into[wheel][i][k];
        if (share == 0)
          continue;
        rate[i] += share * forces[k];
        for (m = 0; jacobian && m < INPUTS; ++m)
          for (j = 0; j < STATE; ++j)
            jacobian[i][j] += share * slopes[k][m] * b->of_state[wheel][m][j];
      }
  }
}

/* LU factors in place, with the rows that were exchanged. */
static void factor(double a[UNKNOWNS][UNKNOWNS], int* pivot) {
  int i, j, k;
  for (k = 0; k < UNKNOWNS; ++k) {
    pivot[k] = k;
    for (i = k + 1; i < UNKNOWNS; ++i)
      if (fabs(a[i][k]) > fabs(a[pivot[k]][k]))
        pivot[k] = i;
    for (j = 0; j < UNKNOWNS; ++j) {
      const double kept = a[k][j];
      a[k][j] = a[pivot[k]][j];
      a[pivot[k]][j] = kept;
    }
    for (i = k + 1; i < UNKNOWNS; ++i) {
      a[i][k] /= a[k][k];
      for (j = k + 1; j < UNKNOWNS; ++j)
        a[i][j] -= a[i][k] * a[k][j];
    }
  }
}

static void solve(double a[UNKNOWNS][UNKNOWNS], const int* pivot, double* x) {
  int i, j;
  for (i = 0; i < UNKNOWNS; ++i) {
    const double kept = x[i];
    x[i] = x[pivot[i]];
    x[pivot[i]] = kept;
  }
  for (i = 0; i < UNKNOWNS; ++i)
    for (j = 0; j < i; ++j)
      x[i] -= a[i][j] * x[j];
  for (i = UNKNOWNS - 1; i >= 0; --i) {
    for (j = i + 1; j < UNKNOWNS; ++j)
      x[i] -= a[i][j] * x[j];
    x[i] /= a[i][i];
  }
}

/* One step of Radau IIA of order 3 (Hairer, Wanner 1996, IV.5), by Newton's method with the Jacobian of its begin. */
static void step(Bogie* b, double h, double* state) {
  static const double weight[STAGES][STAGES] = {{5.0 / 12, -1.0 / 12}, {3.0 / 4, 1.0 / 4}};
  static double slope[STATE][STATE], system[UNKNOWNS][UNKNOWNS];
  double z[UNKNOWNS] = {0}, change[UNKNOWNS], at[STATE], rate[STAGES][STATE], largest = 1;
  int pivot[UNKNOWNS], i, j, p, q, round;
  motion(b, state, rate[0], slope);
  for (p = 0; p < STAGES; ++p)
    for (q = 0; q < STAGES; ++q)
      for (i = 0; i < STATE; ++i)
        for (j = 0; j < STATE; ++j)
          system[p * STATE + i][q * STATE + j] = (p == q && i == j) - h * weight[p][q] * slope[i][j];
  factor(system, pivot);
  for (round = 0; round < 50 && largest > 1e-10; ++round) {
    for (p = 0; p < STAGES; ++p) {
      for (i = 0; i < STATE; ++i)
        at[i] = state[i] + z[p * STATE + i];
      motion(b, at, rate[p], NULL);
    }
    for (p = 0; p < STAGES; ++p)
      for (i = 0; i < STATE; ++i) {
        change[p * STATE + i] = -z[p * STATE + i];
        for (q = 0; q < STAGES; ++q)
          change[p * STATE + i] += h * weight[p][q] * rate[q][i];
      }
    solve(system, pivot, change);
    for (largest = 0, i = 0; i < UNKNOWNS; ++i) {
      z[i] += change[i];
      largest = fmax(largest, fabs(change[i]));
    }
  }
  if (largest > 1e-10)
    fprintf(stderr, "a step is too large for Newton's method (%g s) Give a smaller one.\n", h), exit(3);
  for (i = 0; i < STATE; ++i)
    state[i] += z[STATE + i];
}

int main(int count, char** words) {
  /* radius of the curve, mm; speed, mm/s; s; s in which the curvature grows; s of a step */
  double asked[5] = {3e5, 20e3, 4, 1.5, 1e-3}, state[STATE] = {0};
  const int pieces = 30; /* the curvature in steps: each is small */
  static const char* const names[WHEELS] = {"1R", "1L", "2R", "2L"};
  Bogie bogie;
  long look_ups = 0;
  int k, i;
  for (i = 1; i < count && i < 6; ++i)
    asked[i - 1] = atof(words[i]);
  if (count > 6 || asked[0] == 0 || !(asked[1] > 0 && asked[2] > asked[3] && asked[3] > 0 && asked[4] > 0))
    return fprintf(stderr, "bogie [RADIUS [SPEED [SECONDS [TRANSITION [STEP]]]]] (mm, mm/s, s)\n"), 2;
  for (k = 0; k <= pieces; ++k) {
    const double share = k + 1 < pieces ? (k + 1.0) / pieces : 1, seconds = k < pieces ? asked[3] / pieces : asked[2] - asked[3];
    const long steps = (long)ceil(seconds / asked[4] - 1e-9);
    bogie = make_bogie(asked[1], share / asked[0]);
    for (i = 0; i < steps; ++i)
      step(&bogie, seconds / (double)steps, state);
    look_ups += bogie.look_ups;
  }
  printf("curve of %g m at %g m/s: %g s, %ld look-ups\n", asked[0] / 1000, asked[1] / 1000, asked[2], look_ups);
  for (i = 0; i < WHEELS; ++i) {
    double all[COLUMNS], errors[COLUMNS], forces[3];
    look_up(&bogie, i, state, all, errors, forces, NULL);
    printf("  %s: Fx %6.2f +- %.2f kN, Fy %6.2f +- %.2f kN, T-gamma %5.0f +- %.0f N\n", names[i], all[0] / 1000, errors[0] / 1000,
           (i % 2 ? -1 : 1) * all[1] / 1000, errors[1] / 1000, all[4], errors[4]);
  }
  for (i = 0; i < STATE; ++i)
    printf("%s%.10g", i ? " " : "state ", state[i]);
  puts("");
  return 0;
}
