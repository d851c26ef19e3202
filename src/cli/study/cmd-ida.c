#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/progress.h"
#include "cli/base/subcommand.h"
#include "cli/study/cmd-study.h"
#include "io/exchange/record.h"
#include "io/text/file-writer.h"
#include "io/text/json-text.h"
#include "io/text/text-format.h"
#include "study/cases/run.h"
#include "study/report/table.h"

#include <glib/gi18n.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Most factors of one record. */
#define MOST_SCALES 10000

/* s that a structure is followed beyond its record, where the project does not say how long. */
#define AFTER 5.0

static char *ida_folder, *ida_csv, *ida_scale, *ida_unit;
static char **ida_records;
static double ida_time_step;
static int ida_jobs;

/* One record at all factors. */
typedef struct Curve {
  char *name;                    /* of the record's file, without folders; owned */
  double peak;                   /* of the record, m/s2 */
  gsize count;                   /* by ascending factor: */
  double *scales, *peaks;        /* owned; what follows goes with `scales` */
  double *displacements, *times; /* NaN: the case failed; it stands */
  gsize first; /* case in which it overturns; their number where it does in none */
} Curve;

typedef struct Ida {
  QnProject project; /* the model as it was read, with the user's overrides */
  GArray *scales;    /* of double */
  Curve *curves;
  gsize count;
} Ida;

/* --- What is asked ----------------------------------------------------------------------- */

/* "0.1:2:0.1": from, to, step. */
static gboolean
parse_scales (const char *text, GArray *scales)
{
  double numbers[3];
  const char *at = text;
  for (int i = 0; i < 3; i++) {
    char *end;
    numbers[i] = g_ascii_strtod (at, &end);
    if (end == at || *end != (i < 2 ? ':' : '\0') || !(numbers[i] > 0)
        || !isfinite (numbers[i]))
      return FALSE;
    at = end + 1;
  }
  double count = floor ((numbers[1] - numbers[0]) / numbers[2] * (1 + 1e-12) + 1e-9) + 1;
  for (double i = 0; i < count && count <= MOST_SCALES; i++) {
    /* a decimal fraction stays one: 0.1 + 2 x 0.1 is 0.3 */
    char *short_text = g_strdup_printf ("%.12g", numbers[0] + i * numbers[2]);
    double value = g_ascii_strtod (short_text, NULL);
    g_free (short_text);
    g_array_append_val (scales, value);
  }
  return scales->len > 0;
}

/* --- A study for each record --------------------------------------------------------------- */

/* The model with this record, the only one, as its ground motion. It acts along the direction of
 * the project's first ground motion, or along x. */
static void
make_model (const Ida *ida, const char *record, double end, QnProject *model)
{
  const QnModel *source = &ida->project.model;
  QnVec2 direction =
    source->ground_count > 0 ? source->ground[0].direction : qn_vec2 (1, 0);
  char x[QN_NUMBER_TEXT_SIZE], y[QN_NUMBER_TEXT_SIZE], duration[QN_NUMBER_TEXT_SIZE];
  g_autoptr (GPtrArray) all = g_ptr_array_new_with_free_func (g_free);
  for (char **o = qn_overrides; o != NULL && *o != NULL; o++)
    g_ptr_array_add (all, g_strdup (*o));
  qn_number_text (direction.x, x);
  qn_number_text (direction.y, y);
  qn_number_text (end + AFTER, duration);
  if (source->analysis.procedure != QN_PROCEDURE_DYNAMIC)
    g_ptr_array_add (all, g_strdup ("analysis.procedure=\"dynamic\""));
  if (!(source->analysis.dynamic.duration > 0))
    g_ptr_array_add (all, g_strconcat ("analysis.dynamic.duration=", duration, NULL));
  if (!(source->analysis.dynamic.time_step > 0))
    g_ptr_array_add (all, g_strdup ("analysis.dynamic.time_step=0.005"));
  g_ptr_array_add (all, g_strdup_printf ("analysis.dynamic.ground=[{\"direction\": [%s, "
                                         "%s], \"record\": \"%s\", \"rest\": true}]",
                                         x, y, record));
  g_ptr_array_add (all, NULL);
  qn_cli_must (qn_project_parse (ida->project.text, ida->project.text_length,
                                 ida->project.name, (const char *const *) all->pdata,
                                 model, QN_TROUBLE));
}

static char *
dup_study_text (const Ida *ida, const char *title, const char *model)
{
  GString *json =
    g_string_new ("{ \"format\": \"quoin-study\", \"version\": 1, \"title\": ");
  qn_json_append_string (json, title);
  g_string_append_printf (json, ",\n  \"model\": \"%s\", \"run\": \"dynamic\",\n", model);
  g_string_append (json, "  \"parameters\": [ { \"name\": \"scale\",\n    \"path\": "
                         "\"analysis.dynamic.ground[0].scale\", \"values\": [");
  for (guint i = 0; i < ida->scales->len; i++) {
    g_string_append (json, i > 0 ? ", " : "");
    qn_json_append_number (json, g_array_index (ida->scales, double, i));
  }
  g_string_append (json, "] } ],\n  \"plan\": { \"kind\": \"grid\" },\n  \"outputs\": "
                         "[\"peak_displacement\", \"collapsed\", \"time_of_collapse\", "
                         "\"energy_error\"] }\n");
  return g_string_free (json, FALSE);
}

/* Puts record, model and study beside each other into the folder, and reads the study. */
static void
make_study (const Ida *ida, gsize index, Curve *curve, QnStudy *study)
{
  const char *path = ida_records[index];
  g_autofree char *stem = g_strdup_printf ("record-%" G_GSIZE_FORMAT, index + 1);
  g_autofree char *csv = g_strconcat (stem, ".csv", NULL);
  g_autofree char *model_name = g_strconcat (stem, ".quoin", NULL);
  g_autofree char *study_name = g_strconcat (stem, ".quoin-study", NULL);
  g_autofree char *record_path = g_build_filename (ida_folder, csv, NULL);
  g_autofree char *model_path = g_build_filename (ida_folder, model_name, NULL);
  g_autofree char *study_path = g_build_filename (ida_folder, study_name, NULL);
  QnRecord record;
  QnProject model;
  /* What the command line states is for the records that do not. */
  qn_cli_must (
    qn_record_read (path, NULL, 0, FALSE, &record, NULL)
    || qn_record_read (path, ida_unit, ida_time_step, FALSE, &record, QN_TROUBLE));
  QnRecordFacts facts = qn_record_facts (&record);
  g_autofree char *doubt = qn_record_dup_doubt (&record);
  if (doubt != NULL)
    qn_cli_warning ("%s: %s", path, doubt);
  g_autofree char *gap = qn_record_dup_gap (&record, path);
  if (gap != NULL)
    qn_cli_warning ("%s", gap);
  curve->name = g_path_get_basename (path);
  curve->peak = facts.peak;
  qn_cli_must (qn_record_write (record_path, &record, QN_TROUBLE));
  qn_record_clear (&record);
  make_model (ida, csv, facts.duration, &model);
  QnProjectText *text = qn_project_write (&model, NULL, NULL);
  g_autofree char *json = dup_study_text (ida, curve->name, model_name);
  qn_cli_must (qn_file_write (model_path, text->text, text->length, QN_TROUBLE)
               && qn_file_write (study_path, json, strlen (json), QN_TROUBLE)
               && qn_study_read (study_path, NULL, study, QN_TROUBLE));
  qn_project_text_free (text);
  qn_project_clear (&model);
}

static void
take_run_curve (Curve *curve, const QnStudy *study, const char *folder)
{
  QnTable table;
  qn_cli_must (qn_table_read (&table, study, folder, QN_TROUBLE));
  const gsize scale = (gsize) qn_table_find (&table, "scale"),
              peak = (gsize) qn_table_find (&table, "peak_displacement"),
              time = (gsize) qn_table_find (&table, "time_of_collapse");
  curve->count = curve->first = table.rows->len;
  curve->scales = qn_cli_keep (g_new (double, 4 * curve->count));
  curve->peaks = curve->scales + curve->count;
  curve->displacements = curve->peaks + curve->count;
  curve->times = curve->displacements + curve->count;
  for (gsize i = 0; i < curve->count; i++) {
    curve->scales[i] = qn_table_number (&table, i, scale);
    curve->peaks[i] = curve->scales[i] * curve->peak;
    curve->displacements[i] = qn_table_number (&table, i, peak);
    curve->times[i] = qn_table_number (&table, i, time);
    if (isfinite (curve->times[i]))
      curve->first = MIN (curve->first, i);
  }
  qn_table_clear (&table);
}

/* --- What comes out ------------------------------------------------------------------------ */

static void
print_runs (const Ida *ida)
{
  for (gsize c = 0; c < ida->count; c++) {
    const Curve *curve = &ida->curves[c];
    gsize first = curve->first, failed = 0, stands = 0;
    for (gsize i = 0; i < curve->count; i++) {
      gboolean known = isfinite (curve->displacements[i]) != 0;
      failed += !known;
      stands += i > first && known && !isfinite (curve->times[i]);
    }
    if (first < curve->count)
      qn_print (
        _ (
          "%s: overturns first at %.4g times the record, peak %.4g m/s2, after %.3g s\n"),
        curve->name, curve->scales[first], curve->peaks[first], curve->times[first]);
    else
      qn_print (_ ("%s: does not overturn at any of these factors\n"), curve->name);
    if (stands > 0)
      qn_print (_ ("%s: stands again at %zu larger factors\n"), curve->name, stands);
    if (failed > 0)
      qn_print (_ ("%s: %zu of %zu cases have no result\n"), curve->name, failed,
                curve->count);
  }
}

static void
write_runs (const Ida *ida)
{
  QnFileWriter *out = qn_file_writer_open (ida_csv);
  qn_file_writer_puts (out, "record,scale,peak acceleration [m/s2],peak displacement "
                            "[m],overturned,time [s]\n");
  for (gsize c = 0; c < ida->count; c++) {
    const Curve *curve = &ida->curves[c];
    for (gsize i = 0; i < curve->count; i++) {
      qn_file_writer_json (out, "%s", curve->name);
      const double row[] = { curve->scales[i], curve->peaks[i], curve->displacements[i],
                             isfinite (curve->times[i]) ? 1 : 0, curve->times[i] };
      for (gsize k = 0; k < G_N_ELEMENTS (row); k++) {
        qn_file_writer_puts (out, ",");
        if (isfinite (row[k]))
          qn_file_writer_number (out, row[k]);
      }
      qn_file_writer_puts (out, "\n");
    }
  }
  qn_cli_must (qn_file_writer_commit (out, QN_TROUBLE));
}

/* Every record up to where it first overturns, and dashed from there to that level and along it. */
static void
draw_runs (const Ida *ida)
{
  g_autoptr (QnPlot) plot = qn_plot_new (_ ("Peak displacement (m)"),
                                         _ ("Peak acceleration of the ground (m/s²)"));
  double *levels = qn_plot_keep (plot, g_new0 (double, 6 * ida->count));
  const char *overturning = _ ("overturns first at this level");
  double farthest = 0;
  for (gsize c = 0; c < ida->count; c++)
    for (gsize i = 0; i < ida->curves[c].first; i++)
      farthest = fmax (farthest, ida->curves[c].displacements[i]); /* passes over NaN */
  for (gsize c = 0; c < ida->count; c++) {
    Curve *curve = &ida->curves[c];
    gsize first = curve->first;
    double last = 0, level = 0;
    for (gsize i = 0; i < first; i++)
      if (isfinite (curve->displacements[i])) {
        last = curve->displacements[i];
        level = curve->peaks[i];
      }
    const QnMarks marks = { .kind = QN_MARKS_LINE,
                            .label = curve->name,
                            .series = (int) c,
                            .x = curve->displacements,
                            .y = curve->peaks,
                            .count = first };
    qn_plot_add (plot, marks);
    QnMarks *points = qn_plot_add (plot, marks);
    points->kind = QN_MARKS_POINTS;
    points->label = NULL;
    if (first == curve->count)
      continue;
    double *x = levels + 6 * c, *y = x + 3;
    x[0] = x[1] = last;
    x[2] = farthest > 0 ? 1.1 * farthest : 1;
    y[0] = level;
    y[1] = y[2] = curve->peaks[first];
    qn_plot_mark (plot, QN_MARKS_LINE, overturning, (int) c, x, y, 3)->dash =
      QN_USUAL_DASH;
    overturning = NULL; /* told once */
  }
  qn_picture_plot (plot, ida->project.model.title, &ida->project);
}

/* --- All of it ------------------------------------------------------------------------------ */

static const GOptionEntry ida_entries[] = {
  { "record", 0, 0, G_OPTION_ARG_FILENAME_ARRAY, &ida_records,
    N_ ("A record of ground motion; may be given again"), N_ ("FILE") },
  { "scale", 0, 0, G_OPTION_ARG_STRING, &ida_scale,
    N_ ("Factors on the records: least, greatest, step"), N_ ("0.1:2:0.1") },
  { "unit", 0, 0, G_OPTION_ARG_STRING, &ida_unit,
    N_ ("Unit of accelerations where the records do not state it"), N_ ("g|m/s2|cm/s2") },
  { "time-step", 0, 0, G_OPTION_ARG_DOUBLE, &ida_time_step,
    N_ ("Time between samples where the records do not state it, s"), N_ ("STEP") },
  { "output", 'o', 0, G_OPTION_ARG_FILENAME, &ida_folder,
    N_ ("Folder of the results; made where there is none"), N_ ("FOLDER") },
  { "csv", 0, 0, G_OPTION_ARG_FILENAME, &ida_csv,
    N_ ("Write the curves here; - is standard output"), N_ ("OUT.csv") },
  { "picture", 0, 0, G_OPTION_ARG_FILENAME, &qn_picture.path, N_ ("Draw the curves here"),
    N_ ("OUT.png|svg|pdf") },
  { "size", 0, 0, G_OPTION_ARG_STRING, &qn_picture.size,
    N_ ("Size in pixels or millimetres"), N_ ("1600x1200|160mmx120mm") },
  { "monochrome", 0, 0, G_OPTION_ARG_NONE, &qn_picture.monochrome, N_ ("Greys only"),
    NULL },
  { "jobs", 'j', 0, G_OPTION_ARG_INT, &ida_jobs,
    N_ ("Processes at once; all cores by default"), N_ ("N") },
  QN_INPUT_ENTRIES,
  QN_QUIET_ENTRY,
  G_OPTION_ENTRY_NULL,
};

static void
run_ida (char **arguments)
{
  Ida *ida = qn_cli_keep (g_new0 (Ida, 1));
  ida->scales = g_array_new (FALSE, FALSE, sizeof (double));
  if (ida_records == NULL)
    qn_cli_usage_error (_ ("--record is missing"));
  if (ida_scale == NULL || !parse_scales (ida_scale, ida->scales))
    qn_cli_usage_error (
      _ ("--scale is least:greatest:step, all positive, as in 0.1:2:0.1"));
  if (ida_folder == NULL)
    qn_cli_usage_error (_ ("-o is missing"));
  if (ida_jobs < 0 || ida_jobs > 1024)
    qn_cli_usage_error (_ ("--jobs is a number from 1 to 1024"));
  qn_picture_if_any ();
  qn_cli_must (qn_project_load (arguments[0], (const char *const *) qn_overrides,
                                &ida->project, QN_TROUBLE));
  if (g_mkdir_with_parents (ida_folder, 0777) != 0)
    qn_cli_fail (QN_EXIT_FILE, "%s: %s", ida_folder, _ ("cannot be written"));
  ida->count = g_strv_length (ida_records);
  ida->curves = qn_cli_keep (g_new0 (Curve, ida->count));
  for (gsize i = 0; i < ida->count; i++) {
    /* Computes the cases of one record that are missing in its folder. */
    g_auto (QnStudy) study = { 0 };
    QnStudyProgress progress;
    const QnStudyRunSettings settings = { .jobs = (guint) ida_jobs, .shard = { 0, 1 } };
    g_autofree char *name = g_strdup_printf ("record-%" G_GSIZE_FORMAT, i + 1);
    g_autofree char *folder = g_build_filename (ida_folder, name, NULL);
    make_study (ida, i, &ida->curves[i], &study);
    if (!qn_study_compute (&study, folder, settings, i, ida->count, &progress))
      qn_study_cancelled (ida_folder);
    take_run_curve (&ida->curves[i], &study, folder);
  }
  if (ida_csv != NULL)
    write_runs (ida);
  if (qn_picture.path != NULL)
    draw_runs (ida);
  if (qn_subcommand_prints ())
    print_runs (ida);
}

const QnSubcommand qn_cmd_ida = {
  .name = "ida",
  .arguments = "MODEL",
  .summary =
    N_ ("Incremental dynamic analysis: records scaled until the structure overturns"),
  .help = N_ (
    "Every record at every factor is an analysis in time, on all cores. The folder is "
    "kept: after an interruption the same command computes what is missing. The "
    "record takes the place of the project's ground motions, along the direction of "
    "the first of them, or along x."),
  .options = ida_entries,
  .run = run_ida,
};
