#include "io/exchange/drawing-import.h"
#include "core/base/numbers.h"
#include "io/exchange/drawing.h"
#include "io/exchange/import-work.h"
#include "io/text/file-read.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Elasticity of lime mortar: Pa, and Poisson's ratio. */
#define MORTAR_MODULUS 1e9
#define MORTAR_POISSON 0.2

/* Tolerance where the user gives none, as part of a block's size. */
#define DEFAULT_TOLERANCE 0.002

/* Blocks stand in one row where their feet differ by less than this part of the least height: nobody
 * draws to a thousandth. */
#define SAME_ROW 0.05

/* Sizes of blocks, m, that a drawing may have in the unit it declares. */
#define SMALLEST_BLOCK 0.03
#define LARGEST_BLOCK  4.0

/* ---- unit ---- */

void
qn_import_tell (QnImportWork *work, gboolean warn, const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  char *line = g_strdup_vprintf (format, arguments);
  va_end (arguments);
  g_ptr_array_add (work->report->lines, line);
  if (warn)
    g_ptr_array_add (work->report->warnings, g_strdup (line));
}

double
qn_import_median (GArray *values)
{
  g_array_sort (values, qn_compare_doubles);
  return values->len > 0 ? g_array_index (values, double, values->len / 2) : 0;
}

double
qn_import_unit (const char *name)
{
  static const struct {
    const char *name;
    double metres;
  } units[] = { { "mm", 0.001 }, { "cm", 0.01 },   { "dm", 0.1 },
                { "m", 1 },      { "in", 0.0254 }, { "ft", 0.3048 } };
  for (gsize i = 0; i < G_N_ELEMENTS (units); i++)
    if (strcmp (units[i].name, name) == 0)
      return units[i].metres;
  return 0;
}

/* Median size of the drawing's closed outlines, or of its open paths' lengths where there are
 * none, in the drawing's unit; 0 for an empty drawing. */
static double
block_size (const QnDrawing *drawing)
{
  g_autoptr (GArray) sizes = g_array_new (FALSE, FALSE, sizeof (double));
  for (int pass = 0; pass < 2 && sizes->len == 0; pass++)
    for (guint i = 0; i < drawing->paths->len; i++) {
      const QnDrawingPath *path = &g_array_index (drawing->paths, QnDrawingPath, i);
      if (path->hidden)
        continue;
      QnRing ring = { path->points, path->count };
      double size = pass == 1 ? qn_box_size (qn_ring_bounds (&ring))
                    : path->count >= 4 || path->closed
                      ? sqrt (fabs (qn_ring_area (&ring)))
                      : 0;
      if (size > 0)
        g_array_append_val (sizes, size);
    }
  return qn_import_median (sizes);
}

static gboolean
is_plausible (double size)
{
  return size >= SMALLEST_BLOCK && size <= LARGEST_BLOCK;
}

/* The unit given, else the declared one if blocks have a plausible size in it, else a guess. */
static void
choose_unit (QnImportWork *work, double size)
{
  static const double guesses[] = { 1, 0.001, 0.01 };
  static const char *const names[] = { "m", "mm", "cm" };
  const QnDrawing *drawing = work->drawing;
  double declared = drawing->unit;
  QnBox bounds = QN_BOX_EMPTY;
  for (guint i = 0; i < drawing->paths->len; i++) {
    const QnDrawingPath *path = &g_array_index (drawing->paths, QnDrawingPath, i);
    if (!path->hidden)
      qn_box_add_box (&bounds, qn_box_of_points (path->points, path->count));
  }
  double width = bounds.max.x - bounds.min.x, height = bounds.max.y - bounds.min.y;
  work->unit = work->settings->unit;
  if (work->unit > 0) {
    qn_import_tell (work, FALSE, _ ("unit: %g m as given; extents %.6g x %.6g m"),
                    work->unit, width * work->unit, height * work->unit);
    return;
  }
  if (size == 0) { /* nothing to see */
    work->unit = declared > 0 ? declared : 1;
    return;
  }
  if (declared > 0 && is_plausible (size * declared)) {
    work->unit = declared;
    qn_import_tell (work, FALSE,
                    _ ("unit: %g m as the file declares; extents %.6g x %.6g m"),
                    declared, width * declared, height * declared);
    return;
  }
  gsize guess = 0;
  while (guess < G_N_ELEMENTS (guesses) && !is_plausible (size * guesses[guess]))
    guess++;
  gboolean fits = guess < G_N_ELEMENTS (guesses);
  work->unit = fits ? guesses[guess] : declared > 0 ? declared : 1;
  if (declared > 0 && fits)
    qn_import_tell (
      work, TRUE,
      _ ("unit: the file declares %g m, which would make blocks of about %.3g m; "
         "read as %s "
         "instead, extents %.6g x %.6g m (--unit decides)"),
      declared, size * declared, names[guess], width * work->unit, height * work->unit);
  else if (fits)
    qn_import_tell (
      work, TRUE,
      _ ("unit: not declared; read as %s from its extents, %.6g x %.6g m (--unit "
         "decides)"),
      names[guess], width * work->unit, height * work->unit);
  else
    qn_import_tell (
      work, TRUE,
      _ ("unit: blocks of about %.3g m are not plausible in any unit; read as %g m "
         "(--unit decides)"),
      size * work->unit, work->unit);
}

/* ---- supports ---- */

/* An outline of the lowest row. */
typedef struct Foot {
  QnOutline *outline;
  QnBox box;
  gboolean tapers; /* towards its foot, as a voussoir of a flat arch does */
} Foot;

static int
compare_feet (gconstpointer a, gconstpointer b)
{
  double x = ((const Foot *) a)->box.min.x, y = ((const Foot *) b)->box.min.x;
  return (x > y) - (x < y);
}

/* Width of an outline at the level of its foot or its head. */
static double
width_at (const QnRing *ring, double y, double margin)
{
  QnBox box = QN_BOX_EMPTY;
  for (gsize i = 0; i < ring->count; i++)
    if (fabs (ring->points[i].y - y) <= margin)
      qn_box_add_point (&box, ring->points[i]);
  return box.max.x - box.min.x;
}

/* Blocks side by side that all taper downwards, but for the ends, hold each other: they are a flat arch
 * that stands on its ends. Fixes those alone, and all of other rows. Returns how many it left. */
static gsize
fix_row (Foot *feet, guint count, double gap)
{
  gsize left = 0;
  for (guint first = 0, end; first < count; first = end) {
    gboolean wedges = TRUE;
    for (end = first + 1;
         end < count && feet[end].box.min.x <= feet[end - 1].box.max.x + gap; end++)
      wedges = wedges && (end == first + 1 || feet[end - 1].tapers);
    for (guint i = first; i < end; i++)
      if (wedges && end - first >= 3 && i > first && i + 1 < end)
        left++;
      else
        feet[i].outline->role = QN_ROLE_SUPPORT;
  }
  return left;
}

/* Fixes the lowest row where no layer says what is fixed. */
static void
infer_supports (QnImportWork *work)
{
  double lowest = INFINITY, least_height = INFINITY;
  gsize supports = 0;
  for (guint i = 0; i < work->outlines->len; i++) {
    const QnOutline *outline = &g_array_index (work->outlines, QnOutline, i);
    supports += outline->role == QN_ROLE_SUPPORT;
    QnBox box = qn_ring_bounds (&outline->ring);
    lowest = fmin (lowest, box.min.y);
    least_height = fmin (least_height, box.max.y - box.min.y);
  }

  if (supports > 0) {
    qn_import_tell (work, FALSE, _ ("fixed by their layer: %zu"), supports);
    return;
  }
  double margin =
    fmax (SAME_ROW * least_height, fmax (work->tolerance, 1e-9 * fabs (lowest)));
  g_autoptr (GArray) feet = g_array_new (FALSE, FALSE, sizeof (Foot));
  for (guint i = 0; i < work->outlines->len; i++) {
    QnOutline *outline = &g_array_index (work->outlines, QnOutline, i);
    Foot foot = { .outline = outline, .box = qn_ring_bounds (&outline->ring) };
    if (foot.box.min.y > lowest + margin)
      continue;
    foot.tapers = width_at (&outline->ring, foot.box.max.y, margin)
                  > width_at (&outline->ring, foot.box.min.y, margin) + margin;
    g_array_append_val (feet, foot);
  }
  g_array_sort (feet, compare_feet);
  gsize held = fix_row ((Foot *) (void *) feet->data, feet->len, 0.1 * least_height);
  supports = feet->len - held;
  if (held > 0)
    qn_import_tell (
      work, TRUE,
      _ ("blocks of the lowest row that are the voussoirs of a flat arch, and "
         "not fixed: %zu"),
      held);
  qn_import_tell (
    work, TRUE,
    g_dngettext (GETTEXT_PACKAGE,
                 "no layer of supports: the lowest row is fixed, %zu block",
                 "no layer of supports: the lowest row is fixed, %zu blocks", supports),
    supports);
}

/* What the joints are: dry, or those between blocks and bodies of lime mortar as thick as the widest
 * gap. Each body has two faces with two springs in series: four times the stiffness of the layer.
 * Sources: docs/method/laws.md. */
static void
set_law (QnLaw *law, const QnImportWork *work)
{
  law->friction = work->settings->friction;
  if (!work->has_mortar)
    return;
  g_clear_pointer (&law->source, free);
  law->kn = 4 * MORTAR_MODULUS / work->report->widest_gap;
  law->ks = law->kn / (2 * (1 + MORTAR_POISSON));
  law->friction = 0.4;
  law->cohesion = 0.1e6;
}

static gboolean
fill_project (QnImportWork *work, QnProject *project)
{
  QnModel *model = &project->model;
  const QnImportSettings *settings = work->settings;
  set_law (&model->laws[0], work);
  for (guint i = 0; i < work->outlines->len; i++) {
    const QnOutline *outline = &g_array_index (work->outlines, QnOutline, i);
    g_autofree char *name = g_strdup_printf ("b%u", i + 1);
    QnBlock *block =
      qn_model_add_block (model, name, outline->ring.points, outline->ring.count);
    if (block == NULL)
      return FALSE;
    block->thickness = outline->thickness > 0 ? outline->thickness : settings->thickness;
    block->unit_weight =
      outline->density > 0 ? outline->density * model->gravity : settings->unit_weight;
    for (int dof = 0; dof < QN_DOF_COUNT; dof++)
      block->support[dof] = outline->role == QN_ROLE_SUPPORT;
  }
  return TRUE;
}

static gboolean
run_import (QnImportWork *work, QnProject *project, GError **error)
{
  QnDiag diag = { 0 };
  /* What the reader of the file reported. */
  for (guint i = 0; i < work->drawing->notes->len; i++) {
    const QnDrawingNote *note = work->drawing->notes->pdata[i];
    if (note->line > 0)
      qn_import_tell (work, !note->minor, _ ("%s: %u, first at line %u"), note->text,
                      note->count, note->line);
    else
      qn_import_tell (work, !note->minor, "%s: %u", note->text, note->count);
  }
  if (!qn_import_find_layers (work, error))
    return FALSE;
  const double size = block_size (work->drawing);
  choose_unit (work, size);
  work->tolerance = work->settings->tolerance > 0 ? work->settings->tolerance
                                                  : DEFAULT_TOLERANCE * size * work->unit;
  qn_import_sort_paths (work);
  qn_import_drop_flawed (work);
  qn_import_drop_repeated (work);
  QnStatus status = QN_OK;
  for (int role = 0; role < QN_ROLE_IGNORED && status == QN_OK; role++)
    status = qn_import_take_faces (work, (QnRole) role, &diag);
  if (status == QN_OK) {
    qn_import_heal (work);
    qn_import_drop_flawed (work);
    qn_import_treat_gaps (work);
    status = qn_import_cut_openings (work, &diag);
  }
  if (status == QN_OK && work->outlines->len == 0)
    return qn_io_fail (error, QN_IO_ERROR_INVALID,
                       _ ("%s:1: no closed outline to make a block of"), work->name);
  infer_supports (work);
  qn_import_tell (work, FALSE, _ ("blocks: %u"), work->outlines->len);
  if (!qn_project_begin (project, work->has_mortar ? "lime mortar" : "dry joint", error))
    return FALSE;
  project->name = g_strdup (work->name);
  if (status == QN_OK && !fill_project (work, project))
    status = qn_diag_no_memory (&diag);
  if (status == QN_OK)
    status = qn_model_prepare (&project->model, &diag);
  if (status == QN_OK)
    return TRUE;
  qn_project_set_error (project, &diag, error);
  qn_project_clear (project);
  return FALSE;
}

gboolean
qn_drawing_to_project (QnDrawing *drawing, const char *name,
                       const QnImportSettings *settings, QnProject *project,
                       QnImportReport *report, GError **error)
{
  *project = (QnProject){ 0 };
  qn_drawing_drop_unbounded (drawing);
  *report =
    (QnImportReport){ .lines = g_ptr_array_new_with_free_func (g_free),
                      .warnings = g_ptr_array_new_with_free_func (g_free),
                      .layers = g_array_new (FALSE, FALSE, sizeof (QnImportLayer)) };
  QnImportWork work = { .drawing = drawing,
                        .settings = settings,
                        .name = name,
                        .report = report,
                        .layers = g_hash_table_new (NULL, NULL),
                        .outlines = g_array_new (FALSE, FALSE, sizeof (QnOutline)) };
  gboolean done =
    qn_import_check_layers (settings, error) && run_import (&work, project, error);
  for (guint i = 0; i < work.outlines->len; i++)
    qn_ring_clear (&g_array_index (work.outlines, QnOutline, i).ring);
  g_array_unref (work.outlines);
  g_hash_table_unref (work.layers);
  for (int role = 0; role < QN_ROLE_COUNT; role++)
    qn_segments_clear (&work.soups[role]);
  return done;
}

void
qn_import_report_clear (QnImportReport *report)
{
  g_clear_pointer (&report->lines, g_ptr_array_unref);
  g_clear_pointer (&report->warnings, g_ptr_array_unref);
  for (guint i = 0; report->layers != NULL && i < report->layers->len; i++)
    g_free (g_array_index (report->layers, QnImportLayer, i).name);
  g_clear_pointer (&report->layers, g_array_unref);
  qn_gaps_clear (&report->gaps);
}

/* By the ending; where that says nothing, a file with boxes is HybriDFEM's and any other DXF. */
static QnDrawingReader *
reader_of (const char *path, const char *text, gsize length)
{
  g_autofree char *lower = g_ascii_strdown (path, -1);
  if (g_str_has_suffix (lower, ".svg") || g_str_has_suffix (lower, ".svgz"))
    return qn_svg_import;
  if (g_str_has_suffix (lower, ".json") || g_str_has_suffix (lower, ".obj"))
    return qn_compas_import;
  if (!g_str_has_suffix (lower, ".dxf")
      && g_strstr_len (text, (gssize) length, "Box") != NULL)
    return qn_hybridfem_import;
  return qn_dxf_import;
}

/* The number of an option, or NULL. */
static double *
find_number (QnImportSettings *settings, const char *option)
{
  const struct {
    const char *name;
    double *number;
  } numbers[] = {
    { "tolerance", &settings->tolerance },     { "thickness", &settings->thickness },
    { "unit-weight", &settings->unit_weight }, { "friction", &settings->friction },
    { "close-joints", &settings->gap_width },  { "mortar-joints", &settings->gap_width }
  };
  for (gsize i = 0; i < G_N_ELEMENTS (numbers); i++)
    if (strcmp (numbers[i].name, option) == 0)
      return numbers[i].number;
  return NULL;
}

gboolean
qn_import_settings_set (QnImportSettings *settings, const char *option, const char *value,
                        GError **error)
{
  double *number = find_number (settings, option);
  const char *problem = NULL;
  char *end = NULL;
  if (strcmp (option, "unit") == 0) {
    settings->unit = qn_import_unit (value);
    problem = settings->unit == 0 ? _ ("must be mm, cm, dm, m, in or ft") : NULL;
  } else if (number == NULL) {
    problem = _ ("no such option");
  } else {
    gboolean gaps = number == &settings->gap_width;
    gboolean again = gaps && settings->gaps != QN_GAPS_OPEN;
    *number = g_ascii_strtod (value, &end);
    if (gaps)
      settings->gaps = option[0] == 'c' ? QN_GAPS_CLOSED : QN_GAPS_FILLED;
    problem = end == value || *end != '\0' || !isfinite (*number) ? _ ("must be a number")
              : *number < 0 ? _ ("must not be negative")
              : number == &settings->thickness && *number == 0 ? _ ("must be positive")
              : again ? _ ("and the other treatment of joints exclude each other")
                      : NULL;
  }
  if (problem == NULL)
    return TRUE;
  return qn_io_fail (error, QN_IO_ERROR_OVERRIDE, "%s %s", option, problem);
}

gboolean
qn_import_file (const char *path, const QnImportSettings *settings, QnProject *project,
                QnImportReport *report, GError **error)
{
  gsize length;
  *project = (QnProject){ 0 };
  *report = (QnImportReport){ 0 };
  g_autofree char *text = qn_file_read (path, &length, error);
  if (text == NULL)
    return FALSE;
  QnDrawing drawing;
  if (!qn_drawing_read (reader_of (path, text, length), text, length, path, &drawing,
                        error))
    return FALSE;
  gboolean done =
    qn_drawing_to_project (&drawing, path, settings, project, report, error);
  qn_drawing_clear (&drawing);
  return done;
}
