#include "doc/view/sheet.h"

#include "io/text/file-writer.h"
#include "io/text/io-error.h"
#include "io/text/mechanism-text.h"
#include "render/figure/compare-sheet.h"
#include "render/scene/reading.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

static const char *
without_folders (const char *path)
{
  const char *slash = strrchr (path, G_DIR_SEPARATOR);
  return slash != NULL ? slash + 1 : path;
}

const char *
qn_project_title (const QnProject *project)
{
  const char *title = project->model.title;
  return title != NULL && *title != '\0' ? title : without_folders (project->name);
}

void
qn_project_get_metadata (const QnProject *project, QnMetadata *metadata)
{
  qn_metadata_init (metadata);
  metadata->generator = "quoin " QN_VERSION;
  if (project != NULL) {
    metadata->model = without_folders (project->name);
    metadata->model_sha256 = project->sha256;
  }
}

gboolean
qn_is_table (const char *path)
{
  g_autofree char *lower = path != NULL ? g_ascii_strdown (path, -1) : NULL;
  return lower != NULL && g_str_has_suffix (lower, ".csv");
}

/* ---- tables ---- */

static gboolean
write_curve_table (const char *path, const QnCurve *curves, gsize count, GError **error)
{
  QnFileWriter *writer = qn_file_writer_open (path);
  qn_file_writer_puts (writer,
                       count > 0 && curves[0].in_time
                         ? "run,step,time [s],displacement [m or rad],mark\n"
                       : count > 0 && curves[0].settles
                         ? "run,step,settlement [m or rad],reaction [N or N m],mark\n"
                         : "run,step,displacement [m or rad],multiplier [-],mark\n");
  for (gsize c = 0; c < count; c++)
    for (gsize i = 0; i < curves[c].count; i++) {
      const QnCurve *curve = &curves[c];
      const char *mark = (ptrdiff_t) i == curve->collapse_point ? "collapse"
                         : (ptrdiff_t) i == curve->limit_point  ? "limit point"
                                                                : "";
      qn_file_writer_quoted (writer, curve->label != NULL ? curve->label : "");
      qn_file_writer_csv (writer, ",%zu,%g,%g,%s\n", i, curve->x[i], curve->y[i], mark);
    }
  return qn_file_writer_commit (writer, error);
}

static gboolean
write_comparison (const char *path, const QnSheetRun *runs, gsize count, GError **error)
{
  QnFileWriter *writer = qn_file_writer_open (path);
  qn_file_writer_puts (writer, "project,title,outcome,multiplier [-],mechanism,steps\n");
  for (gsize i = 0; i < count; i++) {
    const QnResult *result = runs[i].result;
    g_autofree char *mechanism = qn_collapse_dup_words (
      &runs[i].project->model, runs[i].contacts, result, qn_mechanism_dup_title);
    qn_file_writer_quoted (writer, runs[i].project->name);
    qn_file_writer_puts (writer, ",");
    qn_file_writer_quoted (writer, qn_project_title (runs[i].project));
    qn_file_writer_printf (writer, ",%s,", qn_outcome_names[result->outcome]);
    if (result->has_collapse_multiplier)
      qn_file_writer_number (writer, result->collapse_multiplier);
    qn_file_writer_puts (writer, ",");
    qn_file_writer_quoted (writer, mechanism != NULL ? mechanism : "");
    qn_file_writer_printf (writer, ",%" G_GSIZE_FORMAT "\n", result->step_count);
  }
  return qn_file_writer_commit (writer, error);
}

/* ---- curves ---- */

static gboolean
read_curve (QnCurve *curve, const QnSheetRun *run, const QnCurveSheet *sheet,
            gboolean table, GError **error)
{
  const QnModel *model = &run->project->model;
  QnCurveMotion motion = qn_result_curve_motion (model, run->result);
  if (motion.body == QN_NONE)
    return qn_io_fail (error, QN_IO_ERROR_INVALID, _ ("%s: no step to show"),
                       run->project->name);
  qn_curve_from_result (curve, model, run->result, motion);
  if (sheet->until > 0)
    qn_curve_cut (curve, sheet->until);
  else if (!sheet->whole && !table)
    qn_curve_cut_runaway (curve);
  return TRUE;
}

static gboolean
draw_curves (const QnCurveSheet *sheet, const QnSheetRun *runs, const QnCurve *curves,
             gsize count, const char *path, const QnOutput *output, GError **error)
{
  QnMetadata metadata;
  qn_project_get_metadata (count == 1 ? runs[0].project : NULL, &metadata);
  g_autoptr (QnPlot) plot =
    qn_curve_plot (curves, count, sheet->references, sheet->reference_count);
  plot->title = sheet->title;
  plot->monochrome = sheet->monochrome;
  return qn_plot_export (plot, path, output, &metadata, error);
}

gboolean
qn_curve_sheet_export (const QnCurveSheet *sheet, const QnSheetRun *runs, gsize count,
                       const char *path, const QnOutput *output, GError **error)
{
  g_autofree QnCurve *curves = g_new0 (QnCurve, count);
  g_autoptr (GPtrArray) labels = g_ptr_array_new_with_free_func (g_free);
  gboolean table = qn_is_table (path), done = TRUE;
  for (gsize i = 0; i < count && done; i++) {
    done = read_curve (&curves[i], &runs[i], sheet, table, error);
    /* Runs of one project are distinguished by their own names. */
    const char *title = qn_project_title (runs[i].project);
    gsize alike = 0;
    for (gsize k = 0; k < count; k++)
      alike += strcmp (title, qn_project_title (runs[k].project)) == 0;
    g_ptr_array_add (labels, alike > 1 ? g_strdup_printf ("%s (%s)", title, runs[i].name)
                                       : g_strdup (title));
    curves[i].label = labels->pdata[i];
    if (done && !qn_curve_shares_axes (&curves[i], &curves[0]))
      done =
        qn_io_fail (error, QN_IO_ERROR_INVALID,
                    _ ("%s and %s: paths of different loads, settlements and analyses in "
                       "time have no axes in common"),
                    runs[0].name, runs[i].name);
  }
  if (done)
    done = table ? write_curve_table (path, curves, count, error)
                 : draw_curves (sheet, runs, curves, count, path, output, error);
  for (gsize i = 0; i < count; i++)
    qn_curve_clear (&curves[i]);
  return done;
}

gboolean
qn_energy_sheet_export (const QnCurveSheet *sheet, const QnSheetRun *run,
                        const char *path, const QnOutput *output, GError **error)
{
  QnMetadata metadata;
  const char *unit;
  if (run->result->history.row_count == 0)
    return qn_io_fail (error, QN_IO_ERROR_INVALID,
                       _ ("%s: only analyses in time have energies"), run->project->name);
  qn_project_get_metadata (run->project, &metadata);
  g_autoptr (QnPlot) plot = qn_energy_plot (&run->result->history, &unit);
  plot->title = sheet->title;
  plot->monochrome = sheet->monochrome;
  return qn_plot_export (plot, path, output, &metadata, error);
}

/* ---- mechanisms ---- */

gboolean
qn_comparison_export (const QnSheetRun *runs, gsize count, int columns, const char *title,
                      gboolean monochrome, const char *path, const QnOutput *output,
                      GError **error)
{
  if (qn_is_table (path))
    return write_comparison (path, runs, count, error);
  g_autofree QnFigure *figures = g_new0 (QnFigure, count);
  for (gsize i = 0; i < count; i++) {
    const QnSheetRun *run = &runs[i];
    qn_figure_init (&figures[i], &run->project->model, run->contacts, run->result,
                    qn_view_of_result (run->result));
    figures[i].options.monochrome = monochrome;
    figures[i].title = qn_project_title (run->project);
  }
  QnMetadata metadata;
  QnCompareSheet sheet = {
    .figures = figures, .count = count, .columns = columns, .title = title
  };
  qn_project_get_metadata (NULL, &metadata);
  metadata.title = title;
  return qn_compare_sheet_export (&sheet, path, output, &metadata, error);
}

gboolean
qn_cracks_csv_write (const char *path, const QnProject *project,
                     const QnContacts *contacts, const QnResult *result, GError **error)
{
  const QnModel *model = &project->model;
  QnFileWriter *writer = qn_file_writer_open (path);
  qn_file_writer_puts (writer,
                       "face,block a,block b,width [m],mean [m],x [m],y [m],line\n");
  g_autoptr (GArray) cracks =
    result->step_count > 0
      ? qn_result_cracks (model, contacts, result, result->step_count - 1)
      : g_array_new (FALSE, FALSE, sizeof (QnCrack));
  g_autofree guint *lines = g_new (guint, cracks->len);
  g_array_unref (qn_cracks_by_line (contacts, cracks, lines));
  for (guint i = 0; i < cracks->len; i++) {
    const QnCrack *crack = &g_array_index (cracks, QnCrack, i);
    qn_file_writer_printf (writer, "%td,", crack->face - contacts->faces);
    qn_file_writer_quoted (writer, model->blocks[crack->face->a].name);
    qn_file_writer_puts (writer, ",");
    qn_file_writer_quoted (writer, model->blocks[crack->face->b].name);
    qn_file_writer_csv (writer, ",%g,%g,%g,%g,%d\n", crack->width, crack->mean,
                        crack->at.x, crack->at.y, (int) lines[i] + 1);
  }
  return qn_file_writer_commit (writer, error);
}

#define MOST_SAMPLES 600

/* The curve behind those of QnEnergyKind. */
#define ERROR QN_ENERGY_KIND_COUNT

static double
energy_of (const double *row, int curve)
{
  const double *sums = row + QN_HISTORY_ENERGY;
  double rest = sums[QN_ENERGY_INPUT];
  if (curve != ERROR)
    return sums[curve];
  for (int kind = QN_ENERGY_INPUT + 1; kind < QN_ENERGY_KIND_COUNT; kind++)
    rest -= sums[kind];
  return rest;
}

static const char *const energy_names[QN_ENERGY_CURVES] = {
  [QN_ENERGY_INPUT] = NC_ ("energy", "input"),
  [QN_ENERGY_KINETIC] = NC_ ("energy", "kinetic"),
  [QN_ENERGY_ELASTIC] = NC_ ("energy", "elastic"),
  [QN_ENERGY_FRICTION] = NC_ ("energy", "friction"),
  [QN_ENERGY_DAMPING] = NC_ ("energy", "damping"),
  [QN_ENERGY_NUMERICAL] = NC_ ("energy", "numerical"),
  [ERROR] = NC_ ("energy", "error"),
};

QnPlot *
qn_energy_plot (const QnHistory *history, const char **unit)
{
  static const char *const units[] = { "J", "kJ", "MJ" };
  gsize every = history->row_count / MOST_SAMPLES + 1;
  gsize count = (history->row_count + every - 1) / every;
  double largest = 0.0, scale = 1.0;
  int k = 0;
  QnPlot *plot = qn_plot_new (_ ("Time (s)"), NULL);
  double *times = qn_plot_keep (plot, g_new (double, count + 1));
  double *energies = qn_plot_keep (plot, g_new (double, QN_ENERGY_CURVES *count + 1));
  for (gsize i = 0; i < count; i++) {
    /* the last one is the last row */
    gsize at = i + 1 < count ? i * every : history->row_count - 1;
    const double *row = history->rows + history->width * at;
    times[i] = row[QN_HISTORY_TIME];
    for (int curve = 0; curve < QN_ENERGY_CURVES; curve++)
      energies[count * (gsize) curve + i] = energy_of (row, curve);
  }
  for (gsize i = 0; i < QN_ENERGY_CURVES * count; i++)
    largest = fmax (largest, fabs (energies[i]));
  for (; k < 2 && largest >= 1e3 * scale; k++)
    scale *= 1e3;
  for (gsize i = 0; i < QN_ENERGY_CURVES * count; i++)
    energies[i] /= scale;
  *unit = units[k];
  plot->y.label = qn_plot_keep (plot, g_strdup_printf (_ ("Energy (%s)"), *unit));
  for (int curve = 0; curve < QN_ENERGY_CURVES; curve++)
    qn_plot_mark (plot, QN_MARKS_LINE,
                  g_dpgettext2 (GETTEXT_PACKAGE, "energy", energy_names[curve]),
                  curve == ERROR ? QN_ENERGY_KINETIC : curve, times,
                  energies + count * (gsize) curve, count)
      ->dash = curve == ERROR ? QN_USUAL_DASH : 0;
  return plot;
}
