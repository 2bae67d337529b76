/*
 * Conformal wheel-rail contact for programs in C, Fortran, Matlab and whatever else can call C.
 *
 *     conformal_contact *contact;
 *     char message[1000];
 *     double totals[CONFORMAL_TOTALS], errors[CONFORMAL_TOTALS];
 *     int lateral;
 *     if (conformal_open_file("scene.toml", &contact, message, sizeof message) != CONFORMAL_OK) ...
 *     conformal_key(contact, "position.lateral", &lateral);       once
 *     for (...) {                                                 each time step
 *       conformal_set_number(contact, lateral, 6.6);
 *       if (conformal_solve(contact) != CONFORMAL_OK) puts(conformal_message(contact));
 *       conformal_totals(contact, totals, CONFORMAL_TOTALS);      totals[CONFORMAL_FX] is in N
 *       conformal_total_errors(contact, errors, CONFORMAL_TOTALS);
 *       printf("%g +- %g N", totals[CONFORMAL_FX], errors[CONFORMAL_FX]);
 *     }
 *     conformal_close(contact);
 *
 * Units mm, N, MPa, rad. Forces act on the rail; x is the rolling direction, y points to the right, z down;
 * on the surface s is the arc length along the rail and n points into the rail. data/scenes/README.md lists
 * the keys.
 *
 * Every function that returns an int returns one of the codes below. If one fails, conformal_message() says
 * what is wrong, why, and what to do; functions that get a `message` put the words there. No exception leaves
 * a function, and none prints or ends the program. A handle is for one thread at a time; many handles may be
 * used side by side. Only conformal_stop() may be called while another thread solves. A case starts from the
 * tractions of the case before on the same handle, so that small changes are solved faster than new cases.
 */
#ifndef CONFORMAL_CONTACT_H
#define CONFORMAL_CONTACT_H

#ifdef __cplusplus
extern "C" {
#endif

typedef struct conformal_contact conformal_contact;

/* What functions return. */
#define CONFORMAL_OK 0            /* solved, and the certificate holds */
#define CONFORMAL_UNFORESEEN 1    /* an error of this library or of the machine */
#define CONFORMAL_WRONG_INPUT 2   /* the scene, a value, an index or a size is wrong */
#define CONFORMAL_NOT_CONVERGED 3 /* there is no certified result */
#define CONFORMAL_STOPPED 4       /* conformal_stop() was called */
#define CONFORMAL_BEYOND_TABLE 5  /* the point is outside the axes of the table */

/* "major.minor.patch" */
const char* conformal_version(void);

/* Reads a scene; relative paths start in its folder. `message` (may be a null pointer) gets at most `size`
 * characters with the final zero: what is wrong, or "". *handle is null if the scene cannot be read. */
int conformal_open_file(const char* scene_file, conformal_contact** handle, char* message, int size);
/* The same from TOML text; relative paths start in `folder`. */
int conformal_open_text(const char* toml, const char* folder, conformal_contact** handle, char* message,
                        int size);
/* A null pointer is fine. */
void conformal_close(conformal_contact* handle);

/* What the last call with this handle had to say if it failed; "" if it did not fail. Valid until the next
 * call with this handle. */
const char* conformal_message(const conformal_contact* handle);

/* The index of a key, such as "position.lateral" or "load.force", for the functions below. */
int conformal_key(conformal_contact* handle, const char* name, int* key);
/* Give a key another value, as if the scene said so. Flags are 0 and 1. If a function fails, the key keeps
 * its value. Whether values fit each other is checked by conformal_solve(). */
int conformal_set_number(conformal_contact* handle, int key, double value);
int conformal_set_numbers(conformal_contact* handle, int key, const double* values, int count); /* a list */
int conformal_set_text(conformal_contact* handle, int key, const char* value);
/* For a flag alone: another key refuses it. 0: false, all else: true. */
int conformal_set_flag(conformal_contact* handle, int key, int value);
/* Every key is again what the scene says. Indices of keys stay. */
int conformal_reset(conformal_contact* handle);

/* Solves the scene as it is now. With CONFORMAL_NOT_CONVERGED there may be a result, which is not certified.
 */
int conformal_solve(conformal_contact* handle);
/* From any thread: conformal_solve() ends soon with CONFORMAL_STOPPED. If none runs, or the one that runs has
 * its result already, the next one ends so, before it computes anything. CONFORMAL_STOPPED ends the stop: the
 * call after it solves again. Several stops before it are one. */
int conformal_stop(conformal_contact* handle);

/* Totals of the last result, on the rail. */
#define CONFORMAL_FX 0              /* N */
#define CONFORMAL_FY 1              /* N, towards the side of this wheel */
#define CONFORMAL_FZ 2              /* N, down */
#define CONFORMAL_FS 3              /* N, shear force along the tangent at the reference point */
#define CONFORMAL_MZ 4              /* N mm, about the vertical through the reference point */
#define CONFORMAL_APPROACH 5        /* mm */
#define CONFORMAL_CREEPAGE_X 6      /* found for load.force_x */
#define CONFORMAL_CREEPAGE_S 7      /* found for load.force_s */
#define CONFORMAL_PMAX 8            /* MPa */
#define CONFORMAL_AREA 9            /* mm2 */
#define CONFORMAL_FRICTION_POWER 10 /* N mm per mm rolled (shift: N mm) */
#define CONFORMAL_CERTIFICATE 11    /* worst violation of the contact conditions, relative; 1e-6 is allowed */
#define CONFORMAL_DISCRETISATION 12 /* estimated error of the elements' size, relative; -1: not estimated */
#define CONFORMAL_TOTALS 13         /* how many there are; later versions append */
/* Copies the first `count` of them. */
int conformal_totals(conformal_contact* handle, double* totals, int count);
/* Their stated errors in the same order, each in the unit of its number: what the size of the elements is
 * estimated to cause. 0: the number is prescribed. Not a number (not equal to itself): it has none,
 * as by the model "hertz". */
int conformal_total_errors(conformal_contact* handle, double* errors, int count);

/* Any number of the last result by its path, as `bem_contact solve --json` and result files have it:
 * "quantities/T_gamma", "quantities/pmax_error", "patches/0/Fn" (patches count from 0), "history/3/Fx",
 * "certified" (0 or 1). Its unit is there, too. A number that is not known is not a number (not equal to
 * itself). With CONFORMAL_WRONG_INPUT conformal_message() names the nearest paths, and *value is as it was.
 */
int conformal_number(conformal_contact* handle, const char* path, double* value);

/* The last result as one JSON object: what `bem_contact solve --json` prints, texts and units with it. *text
 * is valid until the next call of this function. */
int conformal_json(conformal_contact* handle, const char** text);

/* The model that the last result was solved with (its name in scenes, as "halfspace"), and why it was this
 * one. *why_this_model is valid until the next conformal_solve(). */
int conformal_model(conformal_contact* handle, const char** name, const char** why_this_model);

/* Why the numbers of the last result have no stated errors, and what to do; "" if they have.
 * *text is valid until the next call of this function. */
int conformal_why_no_errors(conformal_contact* handle, const char** text);

/* Patches, the one with the largest force first: values of one patch. A value that a patch does not have is
 * not a number (not equal to itself): a scene of kind "patch" has no profiles, a frictionless one no
 * creepages. */
#define CONFORMAL_PATCH_FN 0       /* N, sum of pressure */
#define CONFORMAL_PATCH_FX 1       /* N */
#define CONFORMAL_PATCH_FS 2       /* N */
#define CONFORMAL_PATCH_APPROACH 3 /* mm */
#define CONFORMAL_PATCH_PMAX 4     /* MPa */
#define CONFORMAL_PATCH_AREA 5     /* mm2 */
#define CONFORMAL_PATCH_X 6        /* mm, centre of pressure */
#define CONFORMAL_PATCH_S 7        /* mm, the same, arc length along the rail */
#define CONFORMAL_PATCH_CONTACT 8  /* elements in contact */
#define CONFORMAL_PATCH_ADHESION 9 /* elements in adhesion */
#define CONFORMAL_PATCH_SLIP 10    /* elements in slip */
#define CONFORMAL_PATCH_FY 11      /* N, track frame */
#define CONFORMAL_PATCH_FZ 12      /* N, track frame, down */
#define CONFORMAL_PATCH_MX 13      /* N mm, about x through the centre of pressure */
#define CONFORMAL_PATCH_MS 14      /* N mm, about s there */
#define CONFORMAL_PATCH_MN 15      /* N mm, about n there */
#define CONFORMAL_PATCH_SEMI_AXIS_A                                                                          \
  16 /* mm, ellipse of Hertzian pressure with the same second moments: axis nearest to x */
#define CONFORMAL_PATCH_SEMI_AXIS_B 17 /* mm, the other axis */
#define CONFORMAL_PATCH_AXIS_ANGLE 18  /* rad, from x to the first axis, towards s */
#define CONFORMAL_PATCH_Y 19           /* mm, centre of pressure, track frame */
#define CONFORMAL_PATCH_Z 20           /* mm, track frame, down */
#define CONFORMAL_PATCH_DELTA 21       /* rad, inclination there */
#define CONFORMAL_PATCH_RAIL_Y 22      /* mm, the same point in the frame of the rail's profile */
#define CONFORMAL_PATCH_RAIL_Z 23      /* mm */
#define CONFORMAL_PATCH_WHEEL_S 24     /* mm, the point opposite, arc length along the wheel's profile */
#define CONFORMAL_PATCH_WHEEL_Y 25     /* mm, in the frame of the wheel's profile */
#define CONFORMAL_PATCH_WHEEL_Z 26     /* mm */
#define CONFORMAL_PATCH_WHEEL_DELTA 27 /* rad, inclination there, 0: parallel to the axle */
#define CONFORMAL_PATCH_XI 28          /* rigid slip along x at the centre (shift: mm) */
#define CONFORMAL_PATCH_ETA 29         /* rigid slip along s there (shift: mm) */
#define CONFORMAL_PATCH_PHI 30 /* 1/mm, its rotation about n, with that of the geometry (shift: rad) */
#define CONFORMAL_PATCH_FRICTION_POWER 31 /* N mm per mm rolled (shift: N mm) */
#define CONFORMAL_PATCH_VALUES 32         /* how many there are; later versions append */
int conformal_patch_count(conformal_contact* handle, int* count);
int conformal_patch(conformal_contact* handle, int index, double* values, int count);
/* The stated errors of the values of one patch, as conformal_total_errors() has those of the totals. */
int conformal_patch_errors(conformal_contact* handle, int index, double* errors, int count);

/* Arrays. Fields have ms rows of mx elements: element (ix, is) is values[is * mx + ix] (in Fortran:
 * values(mx, ms)). `count` must be exactly mx, ms or mx * ms. */
#define CONFORMAL_X 0                  /* [mx] mm, middle of the columns */
#define CONFORMAL_S 1                  /* [ms] mm, arc length along the rail */
#define CONFORMAL_Y 2                  /* [ms] mm, track frame */
#define CONFORMAL_Z 3                  /* [ms] mm, track frame */
#define CONFORMAL_DELTA 4              /* [ms] rad, inclination */
#define CONFORMAL_P_X 5                /* [ms][mx] MPa, traction on the rail along x */
#define CONFORMAL_P_S 6                /* [ms][mx] MPa */
#define CONFORMAL_P_N 7                /* [ms][mx] MPa, pressure */
#define CONFORMAL_SLIP_X 8             /* [ms][mx] per unit of rolled distance (shift: mm) */
#define CONFORMAL_SLIP_S 9             /* [ms][mx] */
#define CONFORMAL_U_X 10               /* [ms][mx] mm, displacement of the wheel less that of the rail */
#define CONFORMAL_U_S 11               /* [ms][mx] mm */
#define CONFORMAL_U_N 12               /* [ms][mx] mm */
#define CONFORMAL_GAP 13               /* [ms][mx] mm, undeformed distance */
#define CONFORMAL_DEFORMED_DISTANCE 14 /* [ms][mx] mm */
#define CONFORMAL_STATE 15             /* [ms][mx] 0 exterior, 1 adhesion, 2 slip */
int conformal_grid(conformal_contact* handle, int* mx, int* ms);
int conformal_array(conformal_contact* handle, int which, double* values, int count);

/* Warnings of the last result: input that could be solved and is probably a mistake. The first is the most
 * important one. */
int conformal_warning_count(conformal_contact* handle, int* count);
/* *text is valid until the next conformal_solve(). */
int conformal_warning(conformal_contact* handle, int index, const char** text);
/* What it is of, for programs: "yield", "large_elements" and others (scene/warning.hpp lists them). */
int conformal_warning_kind(conformal_contact* handle, int index, const char** kind);

/*
 * Tables of `bem_contact table`: forces are looked up, in microseconds, not solved.
 *
 *     conformal_table *table;
 *     double at[] = {-2.3, 66000}, values[40], errors[40];
 *     int axes, columns, fx;
 *     if (conformal_table_open("forces.h5", &table, message, sizeof message) != CONFORMAL_OK) ...
 *     conformal_table_size(table, &axes, &columns);                                     2 and 21, say
 *     conformal_table_find(table, "Fx", &fx);
 *     if (conformal_table_look_up(table, at, axes, values, errors, columns, message, sizeof message) != ...
 *     printf("%g +- %g N", values[fx], errors[fx]);
 *     conformal_table_close(table);
 *
 * Any number of threads may use one table at the same time. `message` is what it is for
 * conformal_open_file(). Where a function has none, CONFORMAL_WRONG_INPUT means that there is no such index
 * or name, or that a pointer is null.
 */
typedef struct conformal_table conformal_table;

int conformal_table_open(const char* file, conformal_table** table, char* message, int size);
/* A null pointer is fine. No other thread may use the table any more. */
void conformal_table_close(conformal_table* table);

/* How many axes and columns it has. */
int conformal_table_size(const conformal_table* table, int* axes, int* columns);
/* Name, unit, first and last point of an axis; name, unit and stated error of a column: between
 * the points and by the size of the elements (where that is not known, between the points alone). Every
 * pointer may be null. Texts are valid until the table is closed. */
int conformal_table_axis(const conformal_table* table, int index, const char** name, const char** unit,
                         double* from, double* to);
int conformal_table_column(const conformal_table* table, int index, const char** name, const char** unit,
                           double* error);
/* The index of a column, such as "Fx". */
int conformal_table_find(const conformal_table* table, const char* name, int* column);

/* The values of the first `columns` columns at a point, one coordinate for each axis, and their stated errors
 * (may be a null pointer). CONFORMAL_WRONG_INPUT outside the axes; then `values` are as they were. */
int conformal_table_look_up(const conformal_table* table, const double* at, int axes, double* values,
                            double* errors, int columns, char* message, int size);

/* The same for the loop of a vehicle model, with derivatives, in some microseconds: it allocates nothing,
 * reads no file and makes no message. Of the first `columns` columns (32 at most): values       [columns]
 *     derivatives  [columns][axes]: of each column along each axis, exactly those of the values; may be null
 *     errors       [columns]: stated, as conformal_table_column() has them; may be null
 *     beyond       0, or k (-k): the point is beyond the upper (lower) end of axis k, counted from 1; may be
 * null Values and derivatives are continuous in all coordinates. CONFORMAL_BEYOND_TABLE outside the axes, and
 * for a coordinate that is no number; CONFORMAL_WRONG_INPUT for a table of creep forces or of more than 8
 * axes. Then nothing is written but `beyond`. `bem_contact table T.h5 --pack T.c` writes a table and this
 * function as one C source that needs no library. */
int conformal_table_force(const conformal_table* table, const double* at, int columns, double* values,
                          double* derivatives, double* errors, int* beyond);

/* What conformal_table_creep_forces() is given and gives, in the order of its arrays. */
#define CONFORMAL_ELLIPSE_A 0       /* mm, semi-axis along x */
#define CONFORMAL_ELLIPSE_B 1       /* mm, the other one */
#define CONFORMAL_ELLIPSE_MODULUS 2 /* MPa, shear modulus of both bodies */
#define CONFORMAL_ELLIPSE_BOUND 3   /* N, friction coefficient times normal force */
#define CONFORMAL_ELLIPSE_XI 4      /* 1 */
#define CONFORMAL_ELLIPSE_ETA 5     /* 1 */
#define CONFORMAL_ELLIPSE_PHI 6     /* 1/mm */
#define CONFORMAL_ELLIPSE_VALUES 7
/* Forces Fx and Fy (N) and moment Mz (N mm) on the rail of an elliptic contact, from a table of
 * --creep-forces, and their stated errors (may be a null pointer). CONFORMAL_WRONG_INPUT where a/b is outside
 * the table. */
int conformal_table_creep_forces(const conformal_table* table, const double ellipse[7], double forces[3],
                                 double errors[3], char* message, int size);

#ifdef __cplusplus
}
#endif

#endif
