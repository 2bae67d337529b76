/* FMI 2.0: the functions that an importer finds in the library by their names (sections 2.1, 3.2 and 4.2 of the
 * standard, https://fmi-standard.org). Arguments are those of the standard, with the same types in memory. */

#define FMI2(name) CONFORMAL_FMU_NAME(name)
#define FMI2_STATUS CONFORMAL_FMU_EXPORT conformal_fmu_status
typedef conformal_fmu fmu2;

typedef struct {
  conformal_fmu_logger2 logger;
  void* (*allocate)(size_t count, size_t size);
  void (*release)(void*);
  void (*finished)(void* environment, conformal_fmu_status);
  void* environment;
} conformal_fmu_callbacks2;

typedef struct {
  int again, terminate, nominals, values, has_next;
  double next;
} conformal_fmu_events2;

CONFORMAL_FMU_EXPORT const char* FMI2(fmi2GetTypesPlatform)(void) { return "default"; }
CONFORMAL_FMU_EXPORT const char* FMI2(fmi2GetVersion)(void) { return "2.0"; }

FMI2_STATUS FMI2(fmi2SetDebugLogging)(fmu2* fmu, int on, size_t count, const char* const categories[])
{
  (void)count, (void)categories;
  if (!fmu)
    return CONFORMAL_FMU_ERROR;
  fmu->logging = on != 0;
  return CONFORMAL_FMU_OK;
}

CONFORMAL_FMU_EXPORT fmu2* FMI2(fmi2Instantiate)(const char* name, int type, const char* token, const char* resources,
                                                 const conformal_fmu_callbacks2* callbacks, int visible, int logging)
{
  conformal_fmu like = {0};
  (void)resources, (void)visible;
  like.co_simulation = type == 1;
  like.logging = logging != 0;
  if (callbacks) {
    like.environment = callbacks->environment;
    like.logger2 = callbacks->logger;
  }
  return conformal_fmu_make(&like, name, token);
}
CONFORMAL_FMU_EXPORT void FMI2(fmi2FreeInstance)(fmu2* fmu) { conformal_fmu_free(fmu); }

FMI2_STATUS FMI2(fmi2SetupExperiment)(fmu2* fmu, int has_tolerance, double tolerance, double start, int has_stop,
                                      double stop)
{
  (void)has_tolerance, (void)tolerance, (void)has_stop, (void)stop;
  if (!conformal_fmu_in(fmu, CONFORMAL_FMU_NEW))
    return CONFORMAL_FMU_ERROR;
  fmu->state.time = start;
  return CONFORMAL_FMU_OK;
}
FMI2_STATUS FMI2(fmi2EnterInitializationMode)(fmu2* fmu)
{
  return conformal_fmu_go(fmu, CONFORMAL_FMU_NEW, CONFORMAL_FMU_INITIAL);
}
FMI2_STATUS FMI2(fmi2ExitInitializationMode)(fmu2* fmu)
{
  return conformal_fmu_go(fmu, CONFORMAL_FMU_INITIAL, CONFORMAL_FMU_RUNNING);
}
FMI2_STATUS FMI2(fmi2Terminate)(fmu2* fmu) { return conformal_fmu_go(fmu, CONFORMAL_FMU_RUNNING, CONFORMAL_FMU_ENDED); }
FMI2_STATUS FMI2(fmi2Reset)(fmu2* fmu)
{
  if (!fmu)
    return CONFORMAL_FMU_ERROR;
  conformal_fmu_begin(fmu);
  return CONFORMAL_FMU_OK;
}

FMI2_STATUS FMI2(fmi2GetReal)(fmu2* fmu, const unsigned reference[], size_t count, double value[])
{
  return conformal_fmu_get(fmu, reference, count, value);
}
FMI2_STATUS FMI2(fmi2SetReal)(fmu2* fmu, const unsigned reference[], size_t count, const double value[])
{
  return conformal_fmu_set(fmu, reference, count, value);
}

/* There are no variables of other types. */
#define FMI2_NO_VARIABLES(name, type)                                                                                 \
  FMI2_STATUS FMI2(fmi2Get##name)(fmu2 * fmu, const unsigned reference[], size_t count, type value[])                   \
  {                                                                                                                     \
    (void)reference, (void)value;                                                                                       \
    return conformal_fmu_none(fmu, count);                                                                              \
  }                                                                                                                     \
  FMI2_STATUS FMI2(fmi2Set##name)(fmu2 * fmu, const unsigned reference[], size_t count, const type value[])             \
  {                                                                                                                     \
    (void)reference, (void)value;                                                                                       \
    return conformal_fmu_none(fmu, count);                                                                              \
  }
typedef const char* conformal_fmu_text2;
FMI2_NO_VARIABLES(Integer, int)
FMI2_NO_VARIABLES(Boolean, int)
FMI2_NO_VARIABLES(String, conformal_fmu_text2)

FMI2_STATUS FMI2(fmi2GetFMUstate)(fmu2* fmu, void** state) { return conformal_fmu_keep(fmu, state); }
FMI2_STATUS FMI2(fmi2SetFMUstate)(fmu2* fmu, void* state) { return conformal_fmu_restore(fmu, state); }
FMI2_STATUS FMI2(fmi2FreeFMUstate)(fmu2* fmu, void** state) { return conformal_fmu_drop(fmu, state); }
FMI2_STATUS FMI2(fmi2SerializedFMUstateSize)(fmu2* fmu, void* state, size_t* size)
{
  if (!fmu || !state || !size)
    return CONFORMAL_FMU_ERROR;
  *size = sizeof fmu->state;
  return CONFORMAL_FMU_OK;
}
FMI2_STATUS FMI2(fmi2SerializeFMUstate)(fmu2* fmu, void* state, char bytes[], size_t size)
{
  return conformal_fmu_to_bytes(fmu, state, bytes, size);
}
FMI2_STATUS FMI2(fmi2DeSerializeFMUstate)(fmu2* fmu, const char bytes[], size_t size, void** state)
{
  return conformal_fmu_from_bytes(fmu, bytes, size, state);
}
FMI2_STATUS FMI2(fmi2GetDirectionalDerivative)(fmu2* fmu, const unsigned unknown[], size_t unknowns,
                                               const unsigned known[], size_t knowns, const double seed[],
                                               double sensitivity[])
{
  return conformal_fmu_derivative(fmu, unknown, unknowns, known, knowns, seed, sensitivity, false);
}

static conformal_fmu_status conformal_fmu_continuous2(fmu2* fmu)
{
  return fmu && fmu->co_simulation ? conformal_fmu_unable(fmu)
                                   : conformal_fmu_go(fmu, CONFORMAL_FMU_RUNNING, CONFORMAL_FMU_RUNNING);
}
FMI2_STATUS FMI2(fmi2EnterEventMode)(fmu2* fmu) { return conformal_fmu_continuous2(fmu); }
FMI2_STATUS FMI2(fmi2EnterContinuousTimeMode)(fmu2* fmu) { return conformal_fmu_continuous2(fmu); }
FMI2_STATUS FMI2(fmi2NewDiscreteStates)(fmu2* fmu, conformal_fmu_events2* events)
{
  const conformal_fmu_events2 none = {0};
  if (!conformal_fmu_in(fmu, CONFORMAL_FMU_RUNNING) || !events)
    return CONFORMAL_FMU_ERROR;
  *events = none;
  return CONFORMAL_FMU_OK;
}
FMI2_STATUS FMI2(fmi2CompletedIntegratorStep)(fmu2* fmu, int no_way_back, int* event, int* terminate)
{
  (void)no_way_back;
  if (!conformal_fmu_in(fmu, CONFORMAL_FMU_RUNNING) || !event || !terminate)
    return CONFORMAL_FMU_ERROR;
  *event = *terminate = 0;
  return CONFORMAL_FMU_OK;
}
FMI2_STATUS FMI2(fmi2SetTime)(fmu2* fmu, double time) { return conformal_fmu_set_time(fmu, time); }
FMI2_STATUS FMI2(fmi2SetContinuousStates)(fmu2* fmu, const double state[], size_t count)
{
  (void)state;
  return conformal_fmu_none(fmu, count);
}
FMI2_STATUS FMI2(fmi2GetDerivatives)(fmu2* fmu, double derivative[], size_t count)
{
  (void)derivative;
  return conformal_fmu_none(fmu, count);
}
FMI2_STATUS FMI2(fmi2GetEventIndicators)(fmu2* fmu, double indicator[], size_t count)
{
  (void)indicator;
  return conformal_fmu_none(fmu, count);
}
FMI2_STATUS FMI2(fmi2GetContinuousStates)(fmu2* fmu, double state[], size_t count)
{
  (void)state;
  return conformal_fmu_none(fmu, count);
}
FMI2_STATUS FMI2(fmi2GetNominalsOfContinuousStates)(fmu2* fmu, double nominal[], size_t count)
{
  (void)nominal;
  return conformal_fmu_none(fmu, count);
}

FMI2_STATUS FMI2(fmi2SetRealInputDerivatives)(fmu2* fmu, const unsigned reference[], size_t count, const int order[],
                                              const double value[])
{
  (void)reference, (void)count, (void)order, (void)value;
  return conformal_fmu_unable(fmu);
}
FMI2_STATUS FMI2(fmi2GetRealOutputDerivatives)(fmu2* fmu, const unsigned reference[], size_t count, const int order[],
                                               double value[])
{
  (void)reference, (void)count, (void)order, (void)value;
  return conformal_fmu_unable(fmu);
}
FMI2_STATUS FMI2(fmi2DoStep)(fmu2* fmu, double from, double step, int no_way_back)
{
  (void)no_way_back;
  return conformal_fmu_step(fmu, from, step);
}
FMI2_STATUS FMI2(fmi2CancelStep)(fmu2* fmu) { return conformal_fmu_unable(fmu); }

/* Steps end before the call that does them: what is asked for here is of asynchronous steps, but for the time. */
FMI2_STATUS FMI2(fmi2GetStatus)(fmu2* fmu, int kind, conformal_fmu_status* value)
{
  (void)kind, (void)value;
  return fmu ? CONFORMAL_FMU_DISCARD : CONFORMAL_FMU_ERROR;
}
FMI2_STATUS FMI2(fmi2GetRealStatus)(fmu2* fmu, int kind, double* value)
{
  const int last_successful_time = 2;
  if (!fmu || !value)
    return CONFORMAL_FMU_ERROR;
  if (kind != last_successful_time)
    return CONFORMAL_FMU_DISCARD;
  *value = fmu->state.time;
  return CONFORMAL_FMU_OK;
}
FMI2_STATUS FMI2(fmi2GetIntegerStatus)(fmu2* fmu, int kind, int* value)
{
  (void)kind, (void)value;
  return fmu ? CONFORMAL_FMU_DISCARD : CONFORMAL_FMU_ERROR;
}
FMI2_STATUS FMI2(fmi2GetBooleanStatus)(fmu2* fmu, int kind, int* value)
{
  const int terminated = 3;
  if (!fmu || !value)
    return CONFORMAL_FMU_ERROR;
  if (kind != terminated)
    return CONFORMAL_FMU_DISCARD;
  *value = 0;
  return CONFORMAL_FMU_OK;
}
FMI2_STATUS FMI2(fmi2GetStringStatus)(fmu2* fmu, int kind, const char** value)
{
  (void)kind, (void)value;
  return fmu ? CONFORMAL_FMU_DISCARD : CONFORMAL_FMU_ERROR;
}
