#include "bench/bench.h"

#include "render/curve-plot.h"

#include <cholmod.h>
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/utsname.h>
#include <time.h>

#define KERNEL_SIDE   150
#define KERNEL_ROUNDS 5

double
bench_cpu_seconds (void)
{
  return (double) clock () / CLOCKS_PER_SEC;
}

bool
bench_within_time (const QnProgress *progress, void *end)
{
  (void) progress;
  return bench_cpu_seconds () < *(const double *) end;
}

static cholmod_sparse *
laplacian (int side, cholmod_common *c)
{
  size_t n = (size_t) side * (size_t) side;
  cholmod_triplet *t = cholmod_allocate_triplet (n, n, 3 * n, 1, CHOLMOD_REAL, c);
  int *row = t->i, *column = t->j;
  double *value = t->x;
  for (int i = 0; i < (int) n; i++) {
    const int others[3] = { i, i % side > 0 ? i - 1 : -1, i >= side ? i - side : -1 };
    for (int k = 0; k < 3; k++)
      if (others[k] >= 0) {
        row[t->nnz] = others[k];
        column[t->nnz] = i;
        value[t->nnz++] = k == 0 ? 4.001 : -1;
      }
  }
  cholmod_sparse *matrix = cholmod_triplet_to_sparse (t, 0, c);
  cholmod_free_triplet (&t, c);
  return matrix;
}

static double
time_kernel (void)
{
  double best = G_MAXDOUBLE;
  cholmod_common c;
  cholmod_start (&c);
  c.supernodal = CHOLMOD_SIMPLICIAL;
  c.nmethods = 1;
  c.method[0].ordering = CHOLMOD_AMD;
  cholmod_sparse *matrix = laplacian (KERNEL_SIDE, &c);
  cholmod_dense *right = cholmod_ones (matrix->nrow, 1, CHOLMOD_REAL, &c);
  for (int round = 0; round < KERNEL_ROUNDS; round++) {
    double start = bench_cpu_seconds ();
    cholmod_factor *factor = cholmod_analyze (matrix, &c);
    cholmod_factorize (matrix, factor, &c);
    cholmod_dense *solution = cholmod_solve (CHOLMOD_A, factor, right, &c);
    best = MIN (best, bench_cpu_seconds () - start);
    g_assert_nonnull (solution);
    cholmod_free_dense (&solution, &c);
    cholmod_free_factor (&factor, &c);
  }
  cholmod_free_dense (&right, &c);
  cholmod_free_sparse (&matrix, &c);
  cholmod_finish (&c);
  return best;
}

double
bench_kernel_seconds (void)
{
  static double seconds;
  if (seconds == 0)
    seconds = time_kernel ();
  return seconds;
}

void
bench_reset_peak (void)
{
  FILE *file = g_fopen ("/proc/self/clear_refs", "w");
  if (file != NULL) {
    fputs ("5", file);
    fclose (file);
  }
}

double
bench_peak_megabytes (void)
{
  g_autofree char *status = NULL;
  if (g_file_get_contents ("/proc/self/status", &status, NULL, NULL)) {
    const char *line = strstr (status, "VmHWM:");
    if (line != NULL)
      return g_ascii_strtod (line + strlen ("VmHWM:"), NULL) / 1024;
  }
  struct rusage usage;
  getrusage (RUSAGE_SELF, &usage);
  return (double) usage.ru_maxrss / 1024;
}

static const char *
output_folder (void)
{
  const char *folder = g_getenv ("QUOIN_BENCH_OUTPUT");
  return folder != NULL && *folder != '\0' ? folder : "bench-results";
}

/* The value of the first line of /proc/cpuinfo with this key. */
static char *
processor (void)
{
  g_autofree char *text = NULL;
  if (g_file_get_contents ("/proc/cpuinfo", &text, NULL, NULL)) {
    const char *line = strstr (text, "model name");
    const char *colon = line != NULL ? strchr (line, ':') : NULL;
    if (colon != NULL)
      return g_strndup (colon + 2, strcspn (colon + 2, "\n"));
  }
  return g_strdup ("unknown processor");
}

static void
describe_machine (void)
{
  struct utsname system;
  g_autofree char *name = processor ();
  g_autofree char *path = g_build_filename (output_folder (), "machine.txt", NULL);
  FILE *file = g_fopen (path, "w");
  if (file == NULL)
    g_error ("%s: cannot be written", path);
  uname (&system);
  fprintf (file, "processor       %s, %u used of %u\n", name, 1, g_get_num_processors ());
  fprintf (file, "system          %s %s\n", system.sysname, system.machine);
  fprintf (file, "compiler        %s\n", __VERSION__);
  fprintf (file, "CHOLMOD         %d.%d.%d\n", CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION,
           CHOLMOD_SUBSUB_VERSION);
  fprintf (file, "kernel          %.4f s\n", bench_kernel_seconds ());
  fclose (file);
}

FILE *
bench_csv_open (const char *name, const char *columns)
{
  g_autofree char *file = g_strconcat (name, ".csv", NULL);
  g_autofree char *path = g_build_filename (output_folder (), file, NULL);
  if (g_mkdir_with_parents (output_folder (), 0777) != 0)
    g_error ("%s: cannot be made", output_folder ());
  describe_machine ();
  FILE *csv = g_fopen (path, "w");
  if (csv == NULL)
    g_error ("%s: cannot be written", path);
  bench_csv_row (csv, "%s", columns);
  return csv;
}

void
bench_csv_row (FILE *csv, const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  g_autofree char *line = g_strdup_vprintf (format, arguments);
  va_end (arguments);
  fprintf (csv, "%s\n", line);
  fflush (csv);
  printf ("%s\n", line);
  fflush (stdout);
}

static BenchSeries *
find_series (const BenchChart *chart, const char *label)
{
  for (size_t i = 0; i < chart->series_count; i++)
    if (g_str_equal (chart->series[i].label, label))
      return (BenchSeries *) &chart->series[i];
  return NULL;
}

void
bench_chart_add (BenchChart *chart, const char *label, double x, double y)
{
  BenchSeries *series = find_series (chart, label);
  if (series == NULL) {
    g_assert_cmpuint (chart->series_count, <, G_N_ELEMENTS (chart->series));
    series = &chart->series[chart->series_count++];
    series->label = g_strdup (label);
    series->x = g_array_new (FALSE, FALSE, sizeof (double));
    series->y = g_array_new (FALSE, FALSE, sizeof (double));
  }
  g_array_append_val (series->x, x);
  g_array_append_val (series->y, y);
}

/* Index of the value nearest to x by ratio. */
static guint
nearest (const GArray *values, double x)
{
  guint best = 0;
  for (guint i = 1; i < values->len; i++)
    if (fabs (log (g_array_index (values, double, i) / x))
        < fabs (log (g_array_index (values, double, best) / x)))
      best = i;
  return best;
}

double
bench_chart_exponent (const BenchChart *chart, const char *label, double x0, double x1)
{
  const BenchSeries *series = find_series (chart, label);
  if (series == NULL)
    return NAN;
  guint a = nearest (series->x, x0), b = nearest (series->x, x1);
  if (a == b)
    return NAN;
  return log (g_array_index (series->y, double, b) / g_array_index (series->y, double, a))
         / log (g_array_index (series->x, double, b)
                / g_array_index (series->x, double, a));
}

void
bench_chart_write (BenchChart *chart)
{
  QnCurve curves[G_N_ELEMENTS (chart->series)];
  g_autofree char *file = g_strconcat (chart->name, ".svg", NULL);
  g_autofree char *path = g_build_filename (output_folder (), file, NULL);
  GError *error = NULL;
  QnMetadata metadata;
  QnOutput output;

  for (size_t i = 0; i < chart->series_count; i++) {
    BenchSeries *series = &chart->series[i];
    curves[i] = (QnCurve){ .label = series->label,
                           .x = (double *) series->x->data,
                           .y = (double *) series->y->data,
                           .count = series->x->len,
                           .limit_point = -1,
                           .collapse_point = -1,
                           .dot = -1 };
  }
  const QnCurvePlot plot = { .title = chart->title,
                             .x_label = chart->x_label,
                             .x_unit = chart->x_unit,
                             .y_label = chart->y_label,
                             .x_log = true,
                             .y_log = true,
                             .points = true,
                             .curves = curves,
                             .curve_count = chart->series_count };
  qn_output_init (&output);
  output.width = 900;
  output.height = 640;
  qn_metadata_init (&metadata);
  if (!qn_curve_export (&plot, path, &output, &metadata, &error))
    g_error ("%s", error->message);
  for (size_t i = 0; i < chart->series_count; i++) {
    g_free (chart->series[i].label);
    g_array_unref (chart->series[i].x);
    g_array_unref (chart->series[i].y);
  }
  chart->series_count = 0;
}
