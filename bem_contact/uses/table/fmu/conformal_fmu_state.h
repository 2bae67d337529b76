/* The state of an instance: got, set, and turned into bytes. */

/* *kept: null, or a state of this FMU to write over. */
static conformal_fmu_status conformal_fmu_keep(const conformal_fmu* fmu, void** kept)
{
  if (!conformal_fmu_in(fmu, CONFORMAL_FMU_ANY) || !kept)
    return CONFORMAL_FMU_ERROR;
  if (!*kept)
    *kept = malloc(sizeof fmu->state);
  if (!*kept)
    return conformal_fmu_wrong(fmu, "There is no memory for the state.");
  memcpy(*kept, &fmu->state, sizeof fmu->state);
  return CONFORMAL_FMU_OK;
}

static conformal_fmu_status conformal_fmu_restore(conformal_fmu* fmu, const void* kept)
{
  if (!fmu || !kept)
    return CONFORMAL_FMU_ERROR;
  memcpy(&fmu->state, kept, sizeof fmu->state);
  fmu->looked_up = false;
  return CONFORMAL_FMU_OK;
}

static conformal_fmu_status conformal_fmu_drop(const conformal_fmu* fmu, void** kept)
{
  if (!fmu)
    return CONFORMAL_FMU_ERROR;
  if (kept) {
    free(*kept);
    *kept = NULL;
  }
  return CONFORMAL_FMU_OK;
}

static conformal_fmu_status conformal_fmu_to_bytes(const conformal_fmu* fmu, const void* kept, void* bytes, size_t size)
{
  if (!fmu || !kept || !bytes)
    return CONFORMAL_FMU_ERROR;
  if (size < sizeof fmu->state)
    return conformal_fmu_wrong(fmu, "The state needs more bytes.");
  memcpy(bytes, kept, sizeof fmu->state);
  return CONFORMAL_FMU_OK;
}

static conformal_fmu_status conformal_fmu_from_bytes(const conformal_fmu* fmu, const void* bytes, size_t size, void** kept)
{
  conformal_fmu_state read;
  if (!fmu || !bytes || !kept)
    return CONFORMAL_FMU_ERROR;
  if (size != sizeof read)
    return conformal_fmu_wrong(fmu, "These bytes are no state of this FMU.");
  memcpy(&read, bytes, size);
  if (read.mode != CONFORMAL_FMU_NEW && read.mode != CONFORMAL_FMU_INITIAL && read.mode != CONFORMAL_FMU_RUNNING &&
      read.mode != CONFORMAL_FMU_ENDED)
    return conformal_fmu_wrong(fmu, "These bytes are no state of this FMU.");
  *kept = malloc(size);
  if (!*kept)
    return conformal_fmu_wrong(fmu, "There is no memory for the state.");
  memcpy(*kept, &read, size);
  return CONFORMAL_FMU_OK;
}
