/* FMI 3.0: the functions that an importer finds in the library by their names (section 2.3 and chapters 3 and 4 of the
 * standard, https://fmi-standard.org). Arguments are those of the standard, with the same types in memory. */

#define FMI3(name) CONFORMAL_FMU_NAME(name)
#define FMI3_STATUS CONFORMAL_FMU_EXPORT conformal_fmu_status
typedef conformal_fmu fmu3;

CONFORMAL_FMU_EXPORT const char* FMI3(fmi3GetVersion)(void) { return "3.0"; }

FMI3_STATUS FMI3(fmi3SetDebugLogging)(fmu3* fmu, bool on, size_t count, const char* const categories[])
{
  (void)count;
  (void)categories;
  if (!fmu)
    return CONFORMAL_FMU_ERROR;
  fmu->logging = on;
  return CONFORMAL_FMU_OK;
}

CONFORMAL_FMU_EXPORT fmu3* FMI3(fmi3InstantiateModelExchange)(const char* name, const char* token, const char* resources,
                                                              bool visible, bool logging, void* environment,
                                                              conformal_fmu_logger3 logger)
{
  conformal_fmu like = {0};
  (void)resources;
  (void)visible;
  like.logging = logging;
  like.environment = environment;
  like.logger3 = logger;
  return conformal_fmu_make(&like, name, token);
}

CONFORMAL_FMU_EXPORT fmu3* FMI3(fmi3InstantiateCoSimulation)(const char* name, const char* token, const char* resources,
                                                             bool visible, bool logging, bool event_mode,
                                                             bool early_return, const unsigned required[],
                                                             size_t count, void* environment,
                                                             conformal_fmu_logger3 logger, void (*update)(void))
{
  conformal_fmu like = {0};
  (void)resources;
  (void)visible;
  (void)early_return;
  (void)required;
  (void)update;
  like.co_simulation = true;
  like.logging = logging;
  like.environment = environment;
  like.logger3 = logger;
  if (event_mode || count > 0) {
    conformal_fmu_unable(&like);
    return NULL;
  }
  return conformal_fmu_make(&like, name, token);
}

CONFORMAL_FMU_EXPORT fmu3* FMI3(fmi3InstantiateScheduledExecution)(const char* name, const char* token,
                                                                   const char* resources, bool visible, bool logging,
                                                                   void* environment, conformal_fmu_logger3 logger,
                                                                   void (*update)(void), void (*lock)(void),
                                                                   void (*unlock)(void))
{
  conformal_fmu like = {0};
  (void)name, (void)token, (void)resources, (void)visible, (void)logging, (void)update, (void)lock, (void)unlock;
  like.environment = environment;
  like.logger3 = logger;
  conformal_fmu_unable(&like);
  return NULL;
}

CONFORMAL_FMU_EXPORT void FMI3(fmi3FreeInstance)(fmu3* fmu) { conformal_fmu_free(fmu); }

FMI3_STATUS FMI3(fmi3EnterInitializationMode)(fmu3* fmu, bool has_tolerance, double tolerance, double start, bool has_stop,
                                              double stop)
{
  const conformal_fmu_status status = conformal_fmu_go(fmu, CONFORMAL_FMU_NEW, CONFORMAL_FMU_INITIAL);
  (void)has_tolerance, (void)tolerance, (void)has_stop, (void)stop;
  if (status == CONFORMAL_FMU_OK)
    fmu->state.time = start;
  return status;
}
FMI3_STATUS FMI3(fmi3ExitInitializationMode)(fmu3* fmu)
{
  return conformal_fmu_go(fmu, CONFORMAL_FMU_INITIAL, CONFORMAL_FMU_RUNNING);
}
FMI3_STATUS FMI3(fmi3EnterEventMode)(fmu3* fmu)
{
  return fmu && fmu->co_simulation ? conformal_fmu_unable(fmu)
                                   : conformal_fmu_go(fmu, CONFORMAL_FMU_RUNNING, CONFORMAL_FMU_RUNNING);
}
FMI3_STATUS FMI3(fmi3EnterContinuousTimeMode)(fmu3* fmu)
{
  return fmu && fmu->co_simulation ? conformal_fmu_unable(fmu)
                                   : conformal_fmu_go(fmu, CONFORMAL_FMU_RUNNING, CONFORMAL_FMU_RUNNING);
}
FMI3_STATUS FMI3(fmi3EnterStepMode)(fmu3* fmu)
{
  return fmu && !fmu->co_simulation ? conformal_fmu_unable(fmu)
                                    : conformal_fmu_go(fmu, CONFORMAL_FMU_RUNNING, CONFORMAL_FMU_RUNNING);
}
FMI3_STATUS FMI3(fmi3Terminate)(fmu3* fmu) { return conformal_fmu_go(fmu, CONFORMAL_FMU_RUNNING, CONFORMAL_FMU_ENDED); }
FMI3_STATUS FMI3(fmi3Reset)(fmu3* fmu)
{
  if (!fmu)
    return CONFORMAL_FMU_ERROR;
  conformal_fmu_begin(fmu);
  return CONFORMAL_FMU_OK;
}

FMI3_STATUS FMI3(fmi3GetFloat64)(fmu3* fmu, const unsigned reference[], size_t count, double value[], size_t values)
{
  return fmu && values != count ? conformal_fmu_wrong(fmu, "Each variable has one value.")
                                : conformal_fmu_get(fmu, reference, count, value);
}
FMI3_STATUS FMI3(fmi3SetFloat64)(fmu3* fmu, const unsigned reference[], size_t count, const double value[], size_t values)
{
  return fmu && values != count ? conformal_fmu_wrong(fmu, "Each variable has one value.")
                                : conformal_fmu_set(fmu, reference, count, value);
}

/* There are no variables of other types. */
#define FMI3_NO_VARIABLES(name, type)                                                                                 \
  FMI3_STATUS FMI3(fmi3Get##name)(fmu3 * fmu, const unsigned reference[], size_t count, type value[], size_t values)    \
  {                                                                                                                     \
    (void)reference, (void)value, (void)values;                                                                         \
    return conformal_fmu_none(fmu, count);                                                                              \
  }                                                                                                                     \
  FMI3_STATUS FMI3(fmi3Set##name)(fmu3 * fmu, const unsigned reference[], size_t count, const type value[],             \
                                  size_t values)                                                                        \
  {                                                                                                                     \
    (void)reference, (void)value, (void)values;                                                                         \
    return conformal_fmu_none(fmu, count);                                                                              \
  }
typedef const char* conformal_fmu_text;
FMI3_NO_VARIABLES(Float32, float)
FMI3_NO_VARIABLES(Int8, int8_t)
FMI3_NO_VARIABLES(UInt8, uint8_t)
FMI3_NO_VARIABLES(Int16, int16_t)
FMI3_NO_VARIABLES(UInt16, uint16_t)
FMI3_NO_VARIABLES(Int32, int32_t)
FMI3_NO_VARIABLES(UInt32, uint32_t)
FMI3_NO_VARIABLES(Int64, int64_t)
FMI3_NO_VARIABLES(UInt64, uint64_t)
FMI3_NO_VARIABLES(Boolean, bool)
FMI3_NO_VARIABLES(String, conformal_fmu_text)

FMI3_STATUS FMI3(fmi3GetBinary)(fmu3* fmu, const unsigned reference[], size_t count, size_t size[], const uint8_t* value[],
                                size_t values)
{
  (void)reference, (void)size, (void)value, (void)values;
  return conformal_fmu_none(fmu, count);
}
FMI3_STATUS FMI3(fmi3SetBinary)(fmu3* fmu, const unsigned reference[], size_t count, const size_t size[],
                                const uint8_t* const value[], size_t values)
{
  (void)reference, (void)size, (void)value, (void)values;
  return conformal_fmu_none(fmu, count);
}

/* Clocks, and what belongs to them. */
#define FMI3_NO_CLOCKS(name, first, second, third)                                                                    \
  FMI3_STATUS FMI3(name)(fmu3 * fmu, const unsigned reference[], size_t count, first, second, third)                    \
  {                                                                                                                     \
    (void)reference, (void)a, (void)b, (void)c;                                                                         \
    return conformal_fmu_none(fmu, count);                                                                              \
  }
#define FMI3_NO_CLOCKS_2(name, first, second)                                                                         \
  FMI3_STATUS FMI3(name)(fmu3 * fmu, const unsigned reference[], size_t count, first, second)                           \
  {                                                                                                                     \
    (void)reference, (void)a, (void)b;                                                                                  \
    return conformal_fmu_none(fmu, count);                                                                              \
  }
#define FMI3_NO_CLOCKS_1(name, first)                                                                                 \
  FMI3_STATUS FMI3(name)(fmu3 * fmu, const unsigned reference[], size_t count, first)                                   \
  {                                                                                                                     \
    (void)reference, (void)a;                                                                                           \
    return conformal_fmu_none(fmu, count);                                                                              \
  }
FMI3_NO_CLOCKS_1(fmi3GetClock, bool a[])
FMI3_NO_CLOCKS_1(fmi3SetClock, const bool a[])
FMI3_NO_CLOCKS_2(fmi3GetIntervalDecimal, double a[], int b[])
FMI3_NO_CLOCKS(fmi3GetIntervalFraction, uint64_t a[], uint64_t b[], int c[])
FMI3_NO_CLOCKS_1(fmi3GetShiftDecimal, double a[])
FMI3_NO_CLOCKS_2(fmi3GetShiftFraction, uint64_t a[], uint64_t b[])
FMI3_NO_CLOCKS_1(fmi3SetIntervalDecimal, const double a[])
FMI3_NO_CLOCKS_2(fmi3SetIntervalFraction, const uint64_t a[], const uint64_t b[])
FMI3_NO_CLOCKS_1(fmi3SetShiftDecimal, const double a[])
FMI3_NO_CLOCKS_2(fmi3SetShiftFraction, const uint64_t a[], const uint64_t b[])
FMI3_STATUS FMI3(fmi3ActivateModelPartition)(fmu3* fmu, unsigned clock, double time)
{
  (void)clock, (void)time;
  return conformal_fmu_unable(fmu);
}

FMI3_STATUS FMI3(fmi3GetNumberOfVariableDependencies)(fmu3* fmu, unsigned reference, size_t* count)
{
  (void)reference, (void)count;
  return conformal_fmu_unable(fmu);
}
FMI3_STATUS FMI3(fmi3GetVariableDependencies)(fmu3* fmu, unsigned dependent, size_t element[], unsigned independent[],
                                              size_t elements[], int kind[], size_t count)
{
  (void)dependent, (void)element, (void)independent, (void)elements, (void)kind, (void)count;
  return conformal_fmu_unable(fmu);
}

FMI3_STATUS FMI3(fmi3GetFMUState)(fmu3* fmu, void** state) { return conformal_fmu_keep(fmu, state); }
FMI3_STATUS FMI3(fmi3SetFMUState)(fmu3* fmu, void* state) { return conformal_fmu_restore(fmu, state); }
FMI3_STATUS FMI3(fmi3FreeFMUState)(fmu3* fmu, void** state) { return conformal_fmu_drop(fmu, state); }
FMI3_STATUS FMI3(fmi3SerializedFMUStateSize)(fmu3* fmu, void* state, size_t* size)
{
  if (!fmu || !state || !size)
    return CONFORMAL_FMU_ERROR;
  *size = sizeof fmu->state;
  return CONFORMAL_FMU_OK;
}
FMI3_STATUS FMI3(fmi3SerializeFMUState)(fmu3* fmu, void* state, uint8_t bytes[], size_t size)
{
  return conformal_fmu_to_bytes(fmu, state, bytes, size);
}
FMI3_STATUS FMI3(fmi3DeserializeFMUState)(fmu3* fmu, const uint8_t bytes[], size_t size, void** state)
{
  return conformal_fmu_from_bytes(fmu, bytes, size, state);
}

FMI3_STATUS FMI3(fmi3GetDirectionalDerivative)(fmu3* fmu, const unsigned unknown[], size_t unknowns,
                                               const unsigned known[], size_t knowns, const double seed[], size_t seeds,
                                               double sensitivity[], size_t sensitivities)
{
  return fmu && (seeds != knowns || sensitivities != unknowns)
             ? conformal_fmu_wrong(fmu, "Each variable has one value.")
             : conformal_fmu_derivative(fmu, unknown, unknowns, known, knowns, seed, sensitivity, false);
}
FMI3_STATUS FMI3(fmi3GetAdjointDerivative)(fmu3* fmu, const unsigned unknown[], size_t unknowns, const unsigned known[],
                                           size_t knowns, const double seed[], size_t seeds, double sensitivity[],
                                           size_t sensitivities)
{
  return fmu && (seeds != unknowns || sensitivities != knowns)
             ? conformal_fmu_wrong(fmu, "Each variable has one value.")
             : conformal_fmu_derivative(fmu, unknown, unknowns, known, knowns, seed, sensitivity, true);
}

FMI3_STATUS FMI3(fmi3EnterConfigurationMode)(fmu3* fmu) { return conformal_fmu_unable(fmu); }
FMI3_STATUS FMI3(fmi3ExitConfigurationMode)(fmu3* fmu) { return conformal_fmu_unable(fmu); }
FMI3_STATUS FMI3(fmi3EvaluateDiscreteStates)(fmu3* fmu) { return conformal_fmu_unable(fmu); }
FMI3_STATUS FMI3(fmi3UpdateDiscreteStates)(fmu3* fmu, bool* again, bool* terminate, bool* nominals, bool* values,
                                           bool* has_next, double* next)
{
  if (!conformal_fmu_in(fmu, CONFORMAL_FMU_RUNNING) || !again || !terminate || !nominals || !values || !has_next)
    return CONFORMAL_FMU_ERROR;
  (void)next;
  *again = *terminate = *nominals = *values = *has_next = false;
  return CONFORMAL_FMU_OK;
}

FMI3_STATUS FMI3(fmi3CompletedIntegratorStep)(fmu3* fmu, bool no_way_back, bool* event, bool* terminate)
{
  (void)no_way_back;
  if (!conformal_fmu_in(fmu, CONFORMAL_FMU_RUNNING) || !event || !terminate)
    return CONFORMAL_FMU_ERROR;
  *event = *terminate = false;
  return CONFORMAL_FMU_OK;
}
FMI3_STATUS FMI3(fmi3SetTime)(fmu3* fmu, double time) { return conformal_fmu_set_time(fmu, time); }
FMI3_STATUS FMI3(fmi3SetContinuousStates)(fmu3* fmu, const double state[], size_t count)
{
  (void)state;
  return conformal_fmu_none(fmu, count);
}
FMI3_STATUS FMI3(fmi3GetContinuousStateDerivatives)(fmu3* fmu, double derivative[], size_t count)
{
  (void)derivative;
  return conformal_fmu_none(fmu, count);
}
FMI3_STATUS FMI3(fmi3GetEventIndicators)(fmu3* fmu, double indicator[], size_t count)
{
  (void)indicator;
  return conformal_fmu_none(fmu, count);
}
FMI3_STATUS FMI3(fmi3GetContinuousStates)(fmu3* fmu, double state[], size_t count)
{
  (void)state;
  return conformal_fmu_none(fmu, count);
}
FMI3_STATUS FMI3(fmi3GetNominalsOfContinuousStates)(fmu3* fmu, double nominal[], size_t count)
{
  (void)nominal;
  return conformal_fmu_none(fmu, count);
}
FMI3_STATUS FMI3(fmi3GetNumberOfEventIndicators)(fmu3* fmu, size_t* count)
{
  if (!fmu || !count)
    return CONFORMAL_FMU_ERROR;
  *count = 0;
  return CONFORMAL_FMU_OK;
}
FMI3_STATUS FMI3(fmi3GetNumberOfContinuousStates)(fmu3* fmu, size_t* count)
{
  return FMI3(fmi3GetNumberOfEventIndicators)(fmu, count);
}

FMI3_STATUS FMI3(fmi3GetOutputDerivatives)(fmu3* fmu, const unsigned reference[], size_t count, const int32_t order[],
                                           double value[], size_t values)
{
  (void)reference, (void)count, (void)order, (void)value, (void)values;
  return conformal_fmu_unable(fmu);
}
FMI3_STATUS FMI3(fmi3DoStep)(fmu3* fmu, double from, double step, bool no_way_back, bool* event, bool* terminate,
                             bool* early, double* reached)
{
  const conformal_fmu_status status = conformal_fmu_step(fmu, from, step);
  (void)no_way_back;
  if (!fmu)
    return status;
  if (event)
    *event = false;
  if (terminate)
    *terminate = false;
  if (early)
    *early = false;
  if (reached)
    *reached = fmu->state.time;
  return status;
}
