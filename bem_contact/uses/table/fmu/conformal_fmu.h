/*
 * The element inside of an FMU: inputs go to a packed table (above), and forces come back. C99 and its standard library.
 * Nothing is shared between instances, so each thread may have its own.
 *
 * Value references: 0 time, then the inputs, then the columns of the table, then the margin, then the stated errors.
 * Before this text stand CONFORMAL_FMU_AXES, _COLUMNS and _TOKEN, and the arrays conformal_fmu_start [axes],
 * conformal_fmu_input_unit [axes] and conformal_fmu_output_unit [columns]: what one unit of the table is in that of the FMU.
 */
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CONFORMAL_FMU_TIME 0u
#define CONFORMAL_FMU_FIRST_INPUT 1u
#define CONFORMAL_FMU_FIRST_OUTPUT (CONFORMAL_FMU_FIRST_INPUT + CONFORMAL_FMU_AXES)
#define CONFORMAL_FMU_MARGIN (CONFORMAL_FMU_FIRST_OUTPUT + CONFORMAL_FMU_COLUMNS)
#define CONFORMAL_FMU_FIRST_ERROR (CONFORMAL_FMU_MARGIN + 1u)
#define CONFORMAL_FMU_LAST (CONFORMAL_FMU_FIRST_ERROR + CONFORMAL_FMU_COLUMNS - 1u)

/* The importer compiles this file into a program of its own with a prefix, or it is a shared library without one. */
#if defined(FMI3_FUNCTION_PREFIX)
#define CONFORMAL_FMU_PREFIX FMI3_FUNCTION_PREFIX
#elif defined(FMI2_FUNCTION_PREFIX)
#define CONFORMAL_FMU_PREFIX FMI2_FUNCTION_PREFIX
#endif
#ifdef CONFORMAL_FMU_PREFIX
#define CONFORMAL_FMU_JOIN_(a, b) a##b
#define CONFORMAL_FMU_JOIN(a, b) CONFORMAL_FMU_JOIN_(a, b)
#define CONFORMAL_FMU_NAME(name) CONFORMAL_FMU_JOIN(CONFORMAL_FMU_PREFIX, name)
#define CONFORMAL_FMU_EXPORT
#else
#define CONFORMAL_FMU_NAME(name) name
#if defined(_WIN32) || defined(__CYGWIN__)
#define CONFORMAL_FMU_EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define CONFORMAL_FMU_EXPORT __attribute__((visibility("default")))
#else
#define CONFORMAL_FMU_EXPORT
#endif
#endif

/* The same numbers in both versions of FMI. */
typedef enum { CONFORMAL_FMU_OK, CONFORMAL_FMU_WARNING, CONFORMAL_FMU_DISCARD, CONFORMAL_FMU_ERROR } conformal_fmu_status;

/* Where an instance stands. */
#define CONFORMAL_FMU_NEW 1
#define CONFORMAL_FMU_INITIAL 2
#define CONFORMAL_FMU_RUNNING 4
#define CONFORMAL_FMU_ENDED 8
#define CONFORMAL_FMU_ANY (CONFORMAL_FMU_NEW | CONFORMAL_FMU_INITIAL | CONFORMAL_FMU_RUNNING | CONFORMAL_FMU_ENDED)

typedef void (*conformal_fmu_logger2)(void* environment, const char* name, conformal_fmu_status, const char* category,
                                      const char* message, ...);
typedef void (*conformal_fmu_logger3)(void* environment, conformal_fmu_status, const char* category,
                                      const char* message);

/* All that an importer may get, keep and set again. */
typedef struct {
  double time, input[CONFORMAL_FMU_AXES];
  int32_t mode, padding;
} conformal_fmu_state;

typedef struct {
  conformal_fmu_state state;
  bool looked_up; /* value and slope belong to the inputs */
  double value[CONFORMAL_FMU_COLUMNS], slope[CONFORMAL_FMU_COLUMNS * CONFORMAL_FMU_AXES]; /* in units of the FMU */
  bool co_simulation, logging;
  char* name;
  void* environment;
  conformal_fmu_logger2 logger2;
  conformal_fmu_logger3 logger3;
} conformal_fmu;

/* Errors are told always, all else where logging is on. */
static conformal_fmu_status conformal_fmu_say(const conformal_fmu* fmu, conformal_fmu_status status, const char* text)
{
  const char* category = status == CONFORMAL_FMU_ERROR ? "logStatusError" : "logStatusDiscard";
  if (status != CONFORMAL_FMU_ERROR && !fmu->logging)
    return status;
  if (fmu->logger2)
    fmu->logger2(fmu->environment, fmu->name, status, category, "%s", text);
  if (fmu->logger3)
    fmu->logger3(fmu->environment, status, category, text);
  return status;
}

static conformal_fmu_status conformal_fmu_wrong(const conformal_fmu* fmu, const char* text)
{
  return conformal_fmu_say(fmu, CONFORMAL_FMU_ERROR, text);
}

static void conformal_fmu_begin(conformal_fmu* fmu)
{
  fmu->state.time = 0;
  memcpy(fmu->state.input, conformal_fmu_start, sizeof fmu->state.input);
  fmu->state.mode = CONFORMAL_FMU_NEW;
  fmu->looked_up = false;
}

static conformal_fmu* conformal_fmu_make(const conformal_fmu* like, const char* name, const char* token)
{
  conformal_fmu* fmu;
  size_t length;
  if (!token || strcmp(token, CONFORMAL_FMU_TOKEN) != 0) {
    conformal_fmu_wrong(like, "This FMU has another instantiation token (GUID): its modelDescription.xml is not the one "
                              "of this binary.");
    return NULL;
  }
  fmu = malloc(sizeof *fmu);
  if (!fmu)
    return NULL;
  *fmu = *like;
  length = name ? strlen(name) : 0;
  fmu->name = malloc(length + 1);
  if (!fmu->name) {
    free(fmu);
    return NULL;
  }
  if (length > 0)
    memcpy(fmu->name, name, length);
  fmu->name[length] = 0;
  conformal_fmu_begin(fmu);
  return fmu;
}

static void conformal_fmu_free(conformal_fmu* fmu)
{
  if (fmu)
    free(fmu->name);
  free(fmu);
}

/* Whether a call is allowed now. */
static bool conformal_fmu_in(const conformal_fmu* fmu, int modes)
{
  if (!fmu)
    return false;
  if ((fmu->state.mode & modes) != 0)
    return true;
  conformal_fmu_wrong(fmu, "The function must not be called in this state of the instance.");
  return false;
}

static conformal_fmu_status conformal_fmu_go(conformal_fmu* fmu, int from, int to)
{
  if (!conformal_fmu_in(fmu, from))
    return CONFORMAL_FMU_ERROR;
  fmu->state.mode = to;
  return CONFORMAL_FMU_OK;
}

/* The points of an axis; after the last axis, the stated errors. */
static const double* conformal_fmu_points(int axis)
{
  const double* points = conformal_packed + 5 + CONFORMAL_FMU_AXES;
  int a;
  for (a = 0; a < axis; ++a)
    points += (long)conformal_packed[5 + a];
  return points;
}

static double conformal_fmu_end(int axis) { return conformal_fmu_points(axis + 1)[-1]; }

static conformal_fmu_status conformal_fmu_beyond(const conformal_fmu* fmu, int beyond)
{
  char text[400];
  const int axis = (beyond < 0 ? -beyond : beyond) - 1;
  snprintf(text, sizeof text, "%s: %.9g is outside of the table (from %.9g to %.9g), where no force is known",
           conformal_packed_axes[axis], fmu->state.input[axis] / conformal_fmu_input_unit[axis],
           conformal_fmu_points(axis)[0], conformal_fmu_end(axis));
  return conformal_fmu_say(fmu, CONFORMAL_FMU_DISCARD, text);
}

/* Values and derivatives for the inputs as they are. */
static conformal_fmu_status conformal_fmu_look_up(conformal_fmu* fmu)
{
  double at[CONFORMAL_FMU_AXES];
  int a, c, beyond, code;
  if (fmu->looked_up)
    return CONFORMAL_FMU_OK;
  for (a = 0; a < CONFORMAL_FMU_AXES; ++a)
    at[a] = fmu->state.input[a] / conformal_fmu_input_unit[a];
  code = conformal_packed_force(conformal_packed, at, CONFORMAL_FMU_COLUMNS, fmu->value, fmu->slope, NULL, &beyond);
  if (code == CONFORMAL_PACKED_BEYOND)
    return conformal_fmu_beyond(fmu, beyond);
  if (code != CONFORMAL_PACKED_OK)
    return conformal_fmu_wrong(fmu, "The table in this FMU is damaged.");
  for (c = 0; c < CONFORMAL_FMU_COLUMNS; ++c) {
    fmu->value[c] *= conformal_fmu_output_unit[c];
    for (a = 0; a < CONFORMAL_FMU_AXES; ++a)
      fmu->slope[c * CONFORMAL_FMU_AXES + a] *= conformal_fmu_output_unit[c] / conformal_fmu_input_unit[a];
  }
  fmu->looked_up = true;
  return CONFORMAL_FMU_OK;
}

/* How far the inputs are inside of the table: the smallest distance from an end of an axis over the axis' length, below
 * 0 outside. Which end it is: `axis`, and `side` (1 the lower, -1 the upper one). Not a number for an input that is none. */
static double conformal_fmu_margin(const conformal_fmu* fmu, int* axis, double* side)
{
  double least = 1;
  int a;
  for (a = 0; a < CONFORMAL_FMU_AXES; ++a) {
    const double at = fmu->state.input[a] / conformal_fmu_input_unit[a];
    const double from = conformal_fmu_points(a)[0], to = conformal_fmu_end(a);
    const double lower = (at - from) / (to - from), upper = (to - at) / (to - from);
    if (!(lower >= least) || !(upper >= least)) {
      *axis = a;
      *side = upper < lower ? -1 : 1;
      least = upper < lower ? upper : lower;
      if (least != least)
        return least;
    }
  }
  return least;
}

static conformal_fmu_status conformal_fmu_get(conformal_fmu* fmu, const unsigned* reference, size_t count, double* value)
{
  size_t k;
  if (!conformal_fmu_in(fmu, CONFORMAL_FMU_ANY))
    return CONFORMAL_FMU_ERROR;
  if (count > 0 && (!reference || !value))
    return conformal_fmu_wrong(fmu, "Values are asked for without a place to write them to.");
  for (k = 0; k < count; ++k)
    if (reference[k] > CONFORMAL_FMU_LAST)
      return conformal_fmu_wrong(fmu, "There is no real variable with this value reference.");
    else if (reference[k] >= CONFORMAL_FMU_FIRST_OUTPUT && reference[k] < CONFORMAL_FMU_MARGIN) {
      const conformal_fmu_status status = conformal_fmu_look_up(fmu);
      if (status != CONFORMAL_FMU_OK)
        return status;
    }
  for (k = 0; k < count; ++k)
    if (reference[k] == CONFORMAL_FMU_TIME)
      value[k] = fmu->state.time;
    else if (reference[k] < CONFORMAL_FMU_FIRST_OUTPUT)
      value[k] = fmu->state.input[reference[k] - CONFORMAL_FMU_FIRST_INPUT];
    else if (reference[k] < CONFORMAL_FMU_MARGIN)
      value[k] = fmu->value[reference[k] - CONFORMAL_FMU_FIRST_OUTPUT];
    else if (reference[k] == CONFORMAL_FMU_MARGIN) {
      int axis;
      double side;
      value[k] = conformal_fmu_margin(fmu, &axis, &side);
    } else {
      const unsigned column = reference[k] - CONFORMAL_FMU_FIRST_ERROR;
      value[k] = conformal_fmu_points(CONFORMAL_FMU_AXES)[column] * conformal_fmu_output_unit[column];
    }
  return CONFORMAL_FMU_OK;
}

static conformal_fmu_status conformal_fmu_set(conformal_fmu* fmu, const unsigned* reference, size_t count,
                                              const double* value)
{
  size_t k;
  if (!conformal_fmu_in(fmu, CONFORMAL_FMU_NEW | CONFORMAL_FMU_INITIAL | CONFORMAL_FMU_RUNNING))
    return CONFORMAL_FMU_ERROR;
  if (count > 0 && (!reference || !value))
    return conformal_fmu_wrong(fmu, "Values are set without values.");
  for (k = 0; k < count; ++k)
    if (reference[k] < CONFORMAL_FMU_FIRST_INPUT || reference[k] >= CONFORMAL_FMU_FIRST_OUTPUT)
      return conformal_fmu_wrong(fmu, "Only inputs can be set.");
  for (k = 0; k < count; ++k)
    fmu->state.input[reference[k] - CONFORMAL_FMU_FIRST_INPUT] = value[k];
  if (count > 0)
    fmu->looked_up = false;
  return CONFORMAL_FMU_OK;
}

/* The derivative of an output along an input, both by their value references. */
static double conformal_fmu_slope(const conformal_fmu* fmu, unsigned output, unsigned input)
{
  const int known = (int)(input - CONFORMAL_FMU_FIRST_INPUT);
  if (output == CONFORMAL_FMU_MARGIN) {
    int axis = 0;
    double side = 0;
    conformal_fmu_margin(fmu, &axis, &side);
    if (axis != known)
      return 0;
    return side / (conformal_fmu_end(axis) - conformal_fmu_points(axis)[0]) / conformal_fmu_input_unit[axis];
  }
  return fmu->slope[(int)(output - CONFORMAL_FMU_FIRST_OUTPUT) * CONFORMAL_FMU_AXES + known];
}

/* result [outputs] = derivatives times seed [inputs], or, adjoint, result [inputs] = seed [outputs] times them. */
static conformal_fmu_status conformal_fmu_derivative(conformal_fmu* fmu, const unsigned* output, size_t outputs,
                                                     const unsigned* input, size_t inputs, const double* seed,
                                                     double* result, bool adjoint)
{
  size_t k, i;
  conformal_fmu_status status;
  if (!conformal_fmu_in(fmu, CONFORMAL_FMU_INITIAL | CONFORMAL_FMU_RUNNING | CONFORMAL_FMU_ENDED))
    return CONFORMAL_FMU_ERROR;
  if ((outputs > 0 && !output) || (inputs > 0 && !input) || (outputs > 0 && inputs > 0 && (!seed || !result)))
    return conformal_fmu_wrong(fmu, "Derivatives are asked for without references, a seed or a place to write them to.");
  for (k = 0; k < outputs; ++k)
    if (output[k] < CONFORMAL_FMU_FIRST_OUTPUT || output[k] > CONFORMAL_FMU_MARGIN)
      return conformal_fmu_wrong(fmu, "Derivatives are those of outputs.");
  for (i = 0; i < inputs; ++i)
    if (input[i] < CONFORMAL_FMU_FIRST_INPUT || input[i] >= CONFORMAL_FMU_FIRST_OUTPUT)
      return conformal_fmu_wrong(fmu, "Derivatives are along inputs.");
  status = conformal_fmu_look_up(fmu);
  if (status != CONFORMAL_FMU_OK)
    return status;
  for (k = 0; k < (adjoint ? inputs : outputs); ++k) {
    double sum = 0;
    for (i = 0; i < (adjoint ? outputs : inputs); ++i)
      sum += seed[i] * (adjoint ? conformal_fmu_slope(fmu, output[i], input[k])
                                : conformal_fmu_slope(fmu, output[k], input[i]));
    result[k] = sum;
  }
  return CONFORMAL_FMU_OK;
}

/* One step of co-simulation: the inputs must be in the table, and time goes on. */
static conformal_fmu_status conformal_fmu_step(conformal_fmu* fmu, double from, double step)
{
  conformal_fmu_status status;
  if (!conformal_fmu_in(fmu, CONFORMAL_FMU_RUNNING))
    return CONFORMAL_FMU_ERROR;
  if (!fmu->co_simulation)
    return conformal_fmu_wrong(fmu, "Only an instance for co-simulation does steps.");
  if (!(step >= 0))
    return conformal_fmu_wrong(fmu, "A step does not go backwards.");
  status = conformal_fmu_look_up(fmu);
  if (status == CONFORMAL_FMU_OK)
    fmu->state.time = from + step;
  return status;
}

static conformal_fmu_status conformal_fmu_set_time(conformal_fmu* fmu, double time)
{
  if (!conformal_fmu_in(fmu, CONFORMAL_FMU_RUNNING))
    return CONFORMAL_FMU_ERROR;
  fmu->state.time = time;
  return CONFORMAL_FMU_OK;
}

/* There are no states and no event indicators. */
static conformal_fmu_status conformal_fmu_none(const conformal_fmu* fmu, size_t count)
{
  if (!conformal_fmu_in(fmu, CONFORMAL_FMU_ANY))
    return CONFORMAL_FMU_ERROR;
  return count == 0 ? CONFORMAL_FMU_OK : conformal_fmu_wrong(fmu, "This FMU has no such variables.");
}

static conformal_fmu_status conformal_fmu_unable(const conformal_fmu* fmu)
{
  return fmu ? conformal_fmu_wrong(fmu, "This FMU does not offer that (modelDescription.xml says so).")
             : CONFORMAL_FMU_ERROR;
}
