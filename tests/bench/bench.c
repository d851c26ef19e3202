#include "bench/bench.h"

#include <cholmod.h>
#include <glib/gstdio.h>
#include <locale.h>
#include <malloc.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/utsname.h>
#include <time.h>
#include <unistd.h>

#define KERNEL_SIDE   150
#define KERNEL_ROUNDS 5
#define KERNEL_VALID  10 /* s */

void
bench_no_arguments (int argc, char **argv, const char *summary)
{
  g_autoptr (GOptionContext) context = g_option_context_new (NULL);
  g_autoptr (GError) error = NULL;
  setlocale (LC_ALL, "C.UTF-8");
  g_option_context_set_summary (context, summary);
  gboolean parsed = g_option_context_parse (context, &argc, &argv, &error);
  if (parsed && argc == 1)
    return;
  fprintf (stderr, "%s: %s\n", g_get_prgname (),
           parsed ? "takes no arguments" : error->message);
  exit (2);
}

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
  static gint64 measured;
  if (seconds == 0
      || g_get_monotonic_time () - measured > KERNEL_VALID * G_USEC_PER_SEC) {
    seconds = time_kernel ();
    measured = g_get_monotonic_time ();
  }
  return seconds;
}

void
bench_reset_peak (void)
{
  malloc_trim (0); /* what earlier parts have freed is not this one's */
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

const char *
bench_output_folder (void)
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

static double
memory_gigabytes (void)
{
  return (double) sysconf (_SC_PHYS_PAGES) * (double) sysconf (_SC_PAGE_SIZE) / 0x1p30;
}

static void
describe_machine (void)
{
  struct utsname system;
  g_autofree char *name = processor ();
  g_autofree char *path = g_build_filename (bench_output_folder (), "machine.txt", NULL);
  FILE *file = g_fopen (path, "w");
  if (file == NULL)
    g_error ("%s: cannot be written", path);
  uname (&system);
  fprintf (file, "processor       %s, %u used of %u\n", name, 1, g_get_num_processors ());
  fprintf (file, "system          %s %s\n", system.sysname, system.machine);
  fprintf (file, "memory          %.0f GB\n", memory_gigabytes ());
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
  g_autofree char *path = g_build_filename (bench_output_folder (), file, NULL);
  if (g_mkdir_with_parents (bench_output_folder (), 0777) != 0)
    g_error ("%s: cannot be made", bench_output_folder ());
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

FILE *
bench_bars_open (const char *name)
{
  g_autofree char *file = g_strconcat (name, "-bars", NULL);
  return bench_csv_open (file, "bar,case,measured,demanded,met");
}

gboolean
bench_bar (FILE *csv, const char *bar, const char *what, double measured,
           BenchDemand demand, double value)
{
  gboolean met = demand == BENCH_AT_MOST ? measured <= value : measured >= value;
  bench_csv_row (csv, "\"%s\",%s,%.3g,%s %g,%s", bar, what, measured,
                 demand == BENCH_AT_MOST ? "at most" : "at least", value,
                 met ? "yes" : "no");
  return met;
}
