/* libquoin: block masonry from C and from every language that can call it.
 *
 * A model is read from a project file, or built by calls; its contacts are found at once. Models
 * are read-only from then on, and may be used by many threads. An analysis gives a result, a
 * figure draws both. All numbers are SI (m, N, rad, s), decimal points whatever the locale.
 *
 *   QuoinError *error = NULL;
 *   QuoinModel *model = quoin_model_open ("wall3.quoin", NULL, &error);
 *   QuoinResult *result = quoin_solve (model, NULL, NULL, &error);
 *   printf ("%g\n", quoin_result_get_collapse_multiplier (result));
 *
 * Ownership: what a function called _new, _open, _parse, _import, _with, _read, _finish, _ref,
 * quoin_solve, quoin_limit or quoin_modal returns belongs to the caller; strings and arrays of
 * _get_ functions belong to the object and live as long as it does.
 *
 * Failure: a function with an `error` parameter returns NULL or false and, where `error` is not
 * NULL, sets *error, to be freed with quoin_error_free(). Set it to NULL before: an error that is
 * there already stays, as the first of several calls. NULL for an object or a text that must be
 * given is an error of kind USAGE; functions without an `error` parameter do nothing then. For NULL
 * and for an index that is out of range they return 0, not-a-number, false or NULL (a number
 * of a face: SIZE_MAX) and leave what they were to fill as it is, but counts become 0.
 *
 * The interface is stable within a major version: functions are added, none is changed. Types
 * are opaque, so that they can grow.
 */
#ifndef QUOIN_H
#define QUOIN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct QuoinError QuoinError;
typedef struct QuoinModel QuoinModel;
typedef struct QuoinBuilder QuoinBuilder;
typedef struct QuoinResult QuoinResult;
typedef struct QuoinModes QuoinModes;
typedef struct QuoinFigure QuoinFigure;

/* "0.1.0" */
const char *quoin_version (void);

/* --- Errors ------------------------------------------------------------------------------ */

typedef enum {
  QUOIN_ERROR_INVALID,   /* the content of a file or a value breaks a rule */
  QUOIN_ERROR_FILE,      /* a file cannot be read or written */
  QUOIN_ERROR_USAGE,     /* no such option, view, format … */
  QUOIN_ERROR_NO_MEMORY, /* an allocation failed */
  QUOIN_ERROR_NO_ANSWER  /* the state that was found does not allow what was asked */
} QuoinErrorKind;

QuoinErrorKind quoin_error_get_kind (const QuoinError *error);

/* One line, such as "wall.quoin:12:7: blocks[3].vertices: polygon crosses itself". */
const char *quoin_error_get_message (const QuoinError *error);

/* The place that the message begins with: file, line and column from 1, and path of the key.
 * NULL and 0 where it names none. */
const char *quoin_error_get_file (const QuoinError *error);
int quoin_error_get_line (const QuoinError *error);
int quoin_error_get_column (const QuoinError *error);
const char *quoin_error_get_key (const QuoinError *error);

void quoin_error_free (QuoinError *error);

/* Frees what the functions that say so return. */
void quoin_free (void *memory);

/* --- Models ------------------------------------------------------------------------------ */

/* Reads a project file. `overrides` (nullable, NULL-terminated) are "path=value" strings as
 * "laws[0].friction=0.5". */
QuoinModel *quoin_model_open (const char *path, const char *const *overrides,
                              QuoinError **error);

/* The same from memory; `name` stands for the file in messages, and files that the
 * project names lie beside it. */
QuoinModel *quoin_model_parse (const char *text, size_t length, const char *name,
                               const char *const *overrides, QuoinError **error);

/* Reads a drawing: DXF, SVG, or a COMPAS assembly as JSON. unit: m per unit of the drawing, 0:
 * as the file says; thickness m; unit_weight N/m3; friction: a tangent. */
QuoinModel *quoin_model_import (const char *path, double unit, double thickness,
                                double unit_weight, double friction, QuoinError **error);

/* The same with the options of the command line, "unit=mm", "tolerance=0.002",
 * "layer=VAULT=block", "close-joints=0.03", "mortar-joints=0", "thickness=0.3",
 * "unit-weight=20000", "friction=0.65"; NULL-terminated, or NULL. *report (nullable): a
 * line for each thing that was found, repaired or left out, on failure too; NULL where
 * the file could not be read; to be freed with quoin_free(). */
QuoinModel *quoin_model_import_with (const char *path, const char *const *options,
                                     char **report, QuoinError **error);

/* What every new drawing begins with: dry-jointed stone, weights as dead load and
 * sideways as live load, large displacements. It has no blocks; quoin_model_to_text() is
 * a text to put some into. */
QuoinModel *quoin_model_new (QuoinError **error);

/* Parametric masonry: "wall", "arch", "column", "buttress", "portal", "rubble", "grid",
 * "voronoi". keys: "length=6", "unit=0.4x0.2", "bond=english", members of the object in
 * the project file, NULL-terminated or NULL; what is not given has a default, as on the
 * command line. friction: of dry joints, a tangent. */
QuoinModel *quoin_model_generate (const char *kind, const char *const *keys,
                                  double friction, QuoinError **error);

/* The same model with other values. */
QuoinModel *quoin_model_with (const QuoinModel *model, const char *const *overrides,
                              QuoinError **error);

QuoinModel *quoin_model_ref (QuoinModel *model);
void quoin_model_unref (QuoinModel *model);

/* Writes a project file, whole or not at all. */
bool quoin_model_save (const QuoinModel *model, const char *path, QuoinError **error);

/* The same as a string, to be freed with quoin_free(). */
char *quoin_model_to_text (const QuoinModel *model);

const char *quoin_model_get_title (const QuoinModel *model); /* "" where there is none */

/* What it was read from: name of the file, its bytes, and overrides one after the other,
 * NULL behind the last. quoin_model_parse() makes the same model of these. */
const char *quoin_model_get_path (const QuoinModel *model);
const char *quoin_model_get_source (const QuoinModel *model, size_t *length);
const char *quoin_model_get_override (const QuoinModel *model, size_t index);

/* What reading and detection found to be looked at: unknown keys, gaps, loose blocks. */
size_t quoin_model_get_warning_count (const QuoinModel *model);
const char *quoin_model_get_warning (const QuoinModel *model, size_t index);

/* Blocks, faces, pairs, loads, and what is wrong: JSON, keys as in data/check-format.md;
 * to be freed with quoin_free(). */
char *quoin_model_check (const QuoinModel *model);

size_t quoin_model_get_block_count (const QuoinModel *model);
const char *quoin_model_get_block_name (const QuoinModel *model, size_t block);
double quoin_model_get_block_area (const QuoinModel *model, size_t block);      /* m2 */
double quoin_model_get_block_thickness (const QuoinModel *model, size_t block); /* m */
double quoin_model_get_block_weight (const QuoinModel *model, size_t block);    /* N */
/* x, y, m */
const double *quoin_model_get_block_centroid (const QuoinModel *model, size_t block);
/* *count x 2: x, y, m, counter-clockwise */
const double *quoin_model_get_block_vertices (const QuoinModel *model, size_t block,
                                              size_t *count);
/* dof: 0 ux, 1 uy, 2 rz */
bool quoin_model_is_block_fixed (const QuoinModel *model, size_t block, int dof);

/* Contact faces as detected; every face has contact pairs, numbered one face after the other. */
size_t quoin_model_get_face_count (const QuoinModel *model);
void quoin_model_get_face_blocks (const QuoinModel *model, size_t face, size_t *a,
                                  size_t *b);
/* x, y of its start and of its end, m */
void quoin_model_get_face_ends (const QuoinModel *model, size_t face, double ends[4]);
size_t quoin_model_get_pair_count (const QuoinModel *model);
size_t quoin_model_get_pair_face (const QuoinModel *model, size_t pair);

/* --- Models built by calls --------------------------------------------------------------- */

/* A model without blocks, with dead load by weight and without live load. Nothing fails before
 * quoin_builder_finish(). */
QuoinBuilder *quoin_builder_new (const char *title);
void quoin_builder_free (QuoinBuilder *builder);

/* A dry or cohesive joint (basis "contact"): kn, ks in N/m; friction and dilatancy are tangents;
 * cohesion and tension in N. The first law is that of every contact. */
void quoin_builder_add_joint (QuoinBuilder *builder, const char *name, double kn,
                              double ks, double friction, double dilatancy,
                              double cohesion, double tension);

/* vertices: count x 2, m, in either orientation; unit_weight N/m3; fixed: a support. `name` may
 * be NULL. */
void quoin_builder_add_block (QuoinBuilder *builder, const char *name,
                              const double *vertices, size_t count, double thickness,
                              double unit_weight, bool fixed);

/* Live load on every block: its weight times (x, y). */
void quoin_builder_add_live_weight (QuoinBuilder *builder, double x, double y);

/* A force N on a block at its centroid, with a moment N m: dead, or growing with the multiplier. */
void quoin_builder_add_force (QuoinBuilder *builder, const char *block, double x,
                              double y, double moment, bool live);

/* Any value by its path in the project file: "analysis.increments", "37". */
void quoin_builder_set (QuoinBuilder *builder, const char *path, const char *value);

/* The builder stays as it is. */
QuoinModel *quoin_builder_finish (const QuoinBuilder *builder, QuoinError **error);

/* --- Analyses ---------------------------------------------------------------------------- */

/* Called at least once per iteration from the thread that computes; false cancels, and what has
 * converged by then is kept. `multiplier` is the time reached, s, in analyses in time. */
typedef bool (*QuoinProgressFunc) (double multiplier, int32_t steps, int32_t iterations,
                                   void *data);

/* Within such a callback, whichever analysis runs: how much of it is done, from 0 to 1,
 * never less than before; 1 is told once, at its end, unless it was cancelled. And of
 * what: "path", "time", "limit analysis", which also finds the bound of a path,
 * "stability", "modes", "capacity". The share is exact of analyses in time, and grows
 * ever more slowly where an end is not known. Elsewhere not-a-number and NULL. */
double quoin_progress_get_done (void);
const char *quoin_progress_get_what (void);

/* The analysis that the model's settings name. Collapse, no convergence or cancelling are
 * outcomes of the result, not errors. `progress` may be NULL. */
QuoinResult *quoin_solve (QuoinModel *model, QuoinProgressFunc progress, void *data,
                          QuoinError **error);

/* The load multiplier at which the path first loses its stability, in nonlinear geometry:
 * outcome "snap", the first limit multiplier, and the buckling mode as mechanism. */
QuoinResult *quoin_stability (QuoinModel *model, QuoinProgressFunc progress, void *data,
                              QuoinError **error);

/* Limit analysis of rigid blocks; associative: dilatancy = friction, whose multiplier nothing
 * exceeds. */
QuoinResult *quoin_limit (QuoinModel *model, bool associative, QuoinProgressFunc progress,
                          void *data, QuoinError **error);

/* How the multiplier of an associative limit analysis that found collapse changes, JSON:
 * "multiplier"; "laws", each with "name" and the changes by its "friction", "cohesion",
 * "tension" (per 1, per N or Pa as the law has them), "weight" and "thickness" of its
 * blocks (per factor); "dead_loads" and "live_loads", per factor. To be freed with
 * quoin_free(). */
char *quoin_limit_sensitivity (const QuoinResult *result, QuoinError **error);

/* The lowest frequencies about the equilibrium under dead load or, with `loaded`, about the last
 * one of the analysis. */
QuoinModes *quoin_modal (QuoinModel *model, size_t count, bool loaded,
                         QuoinProgressFunc progress, void *data, QuoinError **error);
/* The same with the tangent stiffness of joints that slide, where closed ones are elastic otherwise. */
QuoinModes *quoin_modal_sliding (QuoinModel *model, size_t count, bool loaded,
                                 QuoinProgressFunc progress, void *data,
                                 QuoinError **error);
void quoin_modes_free (QuoinModes *modes);

/* The capacity curve, and the displacement checks of EN 1998-3 and NTC 2018, as JSON,
 * keys as the command line writes; to be freed with quoin_free(). options:
 * "spectrum=type1", "ag=0.25g", "soil=B", "damping=0.05", "unit=g", "confidence=1.2",
 * "control=w.6.5" instead of the project's, "mechanism=true": the kinematic curve of what
 * limit analysis finds, "tie-strain=0.05", "height=6" and the others of the command line;
 * NULL-terminated or NULL. picture (nullable): PNG, SVG, PDF or CSV
 * of the curve. */
char *quoin_capacity (QuoinModel *model, const char *const *options, const char *picture,
                      QuoinProgressFunc progress, void *data, QuoinError **error);
size_t quoin_modes_get_count (const QuoinModes *modes);
const double *quoin_modes_get_omega (const QuoinModes *modes);  /* count, rad/s */
const double *quoin_modes_get_shapes (const QuoinModes *modes); /* count x bodies x 3 */
/* count x 3, kg: the mass of each mode, and its effective masses in x and y, which sum up
 * to the mass that moves. */
const double *quoin_modes_get_masses (const QuoinModes *modes);
/* Rayleigh's coefficients of mass, 1/s, and of stiffness, s, that give the first mode that
 * is no rigid motion and the last one this part of critical damping. */
void quoin_modes_get_damping (const QuoinModes *modes, double ratio,
                              double coefficients[2]);
/* Rows of a shape: blocks, then nodes of beams. */
size_t quoin_modes_get_body_count (const QuoinModes *modes);

/* --- Results ----------------------------------------------------------------------------- */

/* Reads a result file of this model. Overrides that it was computed with, as of --set, are
 * those of the result's model then. */
QuoinResult *quoin_result_read (QuoinModel *model, const char *path, QuoinError **error);

/* The same from memory; `name` stands for the file in messages. */
QuoinResult *quoin_result_parse (QuoinModel *model, const char *text, size_t length,
                                 const char *name, QuoinError **error);

/* Whether the project's bytes or the overrides were others when a result that was read
 * was computed: the same blocks and contact pairs, but loads, laws or settings may
 * differ. */
bool quoin_result_is_of_changed_model (const QuoinResult *result);

/* Writes a result file, whole or not at all. */
bool quoin_result_write (const QuoinResult *result, const char *path, QuoinError **error);

/* The same as a string, JSON with all that a result file holds: contacts with their
 * points and normals, forces of every step, the history of an analysis in time, its
 * energies, beams, the mechanism's kind and joints. Keys: data/result-format.md. To be
 * freed with quoin_free(). */
char *quoin_result_to_text (const QuoinResult *result);

/* Whether everything that the result says is true, by the laws alone. *faults (nullable):
 * what is not, a line each, "" where all is; to be freed with quoin_free(). */
bool quoin_result_check (const QuoinResult *result, char **faults, QuoinError **error);

void quoin_result_free (QuoinResult *result);

/* The model that was solved; borrowed. */
QuoinModel *quoin_result_get_model (const QuoinResult *result);

/* "collapse", "target-reached", "snap", "unbounded", "dead-load-unstable", "cancelled",
 * "not-converged" */
const char *quoin_result_get_outcome (const QuoinResult *result);

/* Sentences: the outcome, what made the analysis end there, and how the structure moves.
 * To be freed with quoin_free(). */
char *quoin_result_describe (const QuoinResult *result);

/* Not-a-number where there is none. */
double quoin_result_get_collapse_multiplier (const QuoinResult *result);
double quoin_result_get_first_limit_multiplier (const QuoinResult *result);
double quoin_result_get_lower_bound (const QuoinResult *result); /* limit analysis */
double quoin_result_get_upper_bound (const QuoinResult *result);

/* Collapses that were met and proved: forces within the strength of every joint in
 * balance, and a mechanism that they let move. A structure whose joints dilate by less
 * than their friction may have many; the collapse multiplier is the least. */
size_t quoin_result_get_solution_count (const QuoinResult *result);
double quoin_result_get_solution_multiplier (const QuoinResult *result, size_t solution);
/* "load", "displacement", "work", "arc-length": what the path prescribed there; "limit": of rigid
 * blocks */
const char *quoin_result_get_solution_found_by (const QuoinResult *result,
                                                size_t solution);
/* Largest since the dead load, m; not-a-number of rigid blocks */
double quoin_result_get_solution_displacement (const QuoinResult *result,
                                               size_t solution);

/* From the least solution to the associative bound, which no equilibrium exceeds;
 * not-a-number where an end is not known. */
void quoin_result_get_collapse_interval (const QuoinResult *result, double interval[2]);

/* Whether, in linear geometry, blocks moved farther than it is valid for before the answer was
 * found. And the multiplier at which they did: not-a-number where they did not, or in time. */
bool quoin_result_is_beyond_linear (const QuoinResult *result);
double quoin_result_get_beyond_linear_multiplier (const QuoinResult *result);

/* What happens on a path as the load grows, by multiplier; with load stages that of the
 * last one. */
size_t quoin_result_get_event_count (const QuoinResult *result);
double quoin_result_get_event_multiplier (const QuoinResult *result, size_t event);
/* "local": a joint or two settle; "snap": the structure jumps by 5 % of its displacement or more;
 * "collapse" */
const char *quoin_result_get_event_kind (const QuoinResult *result, size_t event);
/* Largest displacement since the dead load before and after, m; of a collapse the latter is how far
 * the motion was followed. */
void quoin_result_get_event_displacements (const QuoinResult *result, size_t event,
                                           double displacements[2]);
double quoin_result_get_event_energy (const QuoinResult *result,
                                      size_t event); /* set free, J */
/* *count: numbers of the blocks that move, ascending */
const int32_t *quoin_result_get_event_blocks (const QuoinResult *result, size_t event,
                                              size_t *count);

/* Converged equilibria, the first under dead load alone. Bodies are blocks, then nodes of beams. */
size_t quoin_result_get_step_count (const QuoinResult *result);
size_t quoin_result_get_body_count (const QuoinResult *result);
const double *quoin_result_get_multipliers (const QuoinResult *result); /* steps */
/* steps x bodies x 3: ux, uy m at the centroid, rz rad */
const double *quoin_result_get_displacements (const QuoinResult *result);
/* bodies x 3, largest displacement 1; NULL where there is none */
const double *quoin_result_get_mechanism (const QuoinResult *result);

/* Contact pairs at the last equilibrium. pairs x 2: normal (<= 0 in compression) and shear, N */
size_t quoin_result_get_pair_count (const QuoinResult *result);
const double *quoin_result_get_forces (const QuoinResult *result);
/* "stick", "slip", "open", "yield" */
const char *quoin_result_get_pair_state (const QuoinResult *result, size_t pair);

/* Ties at every step: their force, N, and how much farther apart their ends are than as
 * drawn, m; false where a step does not tell them. State: "slack", "elastic", "yields",
 * "anchor"; NULL likewise. */
size_t quoin_result_get_tie_count (const QuoinResult *result);
bool quoin_result_get_tie (const QuoinResult *result, size_t step, size_t tie,
                           double *force, double *elongation);
const char *quoin_result_get_tie_state (const QuoinResult *result, size_t step,
                                        size_t tie);

int32_t quoin_result_get_iterations (const QuoinResult *result);
int32_t quoin_result_get_factorizations (const QuoinResult *result);

/* --- Studies, and the rest of the command line --------------------------------------------- */

/* Runs quoin-cli, whose cases are computed by processes anyway: "study", "run",
 * "friction.quoin-study", "-o", "folder"; NULL-terminated. It is the program that
 * QUOIN_CLI names in the environment, or the one of PATH. *output (nullable): what it
 * printed, to be freed with quoin_free(). Ends with the error of the program. */
bool quoin_command (const char *const *arguments, char **output, QuoinError **error);

/* The same, told how many cases of a study or of ida there are rows for: `multiplier` and
 * steps; iterations: how many of them failed. Within the callback quoin_progress_get_done()
 * is their share and quoin_progress_get_what() "cases". False ends the program as Ctrl+C
 * does, with an error; the same arguments go on later. */
bool quoin_command_watched (const char *const *arguments, char **output,
                            QuoinProgressFunc progress, void *data, QuoinError **error);

/* --- Figures ----------------------------------------------------------------------------- */

/* view: "model", "contacts", "deformed", "mechanism", "forces", "diagrams"; "curve" (of
 * the loads over displacement), "energy" (of an analysis in time), "compare" (mechanisms
 * on one sheet), "report". `result` may be NULL for "model", "contacts" and "report".
 * Keeps what it draws alive: model and result may go before it. */
QuoinFigure *quoin_figure_new (QuoinModel *model, QuoinResult *result, const char *view,
                               QuoinError **error);

/* One more result, of any model, for "curve", "compare" and "report". */
void quoin_figure_add (QuoinFigure *figure, QuoinResult *result);
void quoin_figure_free (QuoinFigure *figure);

/* "size" ("1600x1200", "160mmx120mm"), "dpi", "transparent", "monochrome", "title",
 * "caption"; of a picture "field" ("stress", …), "diagram", "step" ("last" or a number),
 * "scale" ("auto" or a factor) and the switches of the command line ("ghost", "loads",
 * "names", …); of an animation "frames", "rate", "speed", "once", "curve"; of curves
 * "until", "whole", "reference" ("0.36=published", again for each), "label" of the
 * results of one model, again for each; "columns" of a comparison; "paper", "sections",
 * "demand" of a report. Switches are "on" or "off". */
bool quoin_figure_set (QuoinFigure *figure, const char *name, const char *value,
                       QuoinError **error);

/* PNG, SVG or PDF by the ending, CSV of "curve" and "compare"; "deformed" and "mechanism"
 * move in GIF, WebM or pictures in a FOLDER/. Whole or not at all. */
bool quoin_figure_write (const QuoinFigure *figure, const char *path, QuoinError **error);

/* The same, told after every picture of an animation how many there are: `multiplier` and
 * steps; quoin_progress_get_what() is "frames". */
bool quoin_figure_write_watched (const QuoinFigure *figure, const char *path,
                                 QuoinProgressFunc progress, void *data,
                                 QuoinError **error);

/* The same into memory, format "png", "svg", "pdf", "csv", "gif", "webm"; to be freed
 * with quoin_free(). */
void *quoin_figure_encode (const QuoinFigure *figure, const char *format, size_t *length,
                           QuoinError **error);

#ifdef __cplusplus
}
#endif

#endif
