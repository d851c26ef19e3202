/* Contact detection against the number of blocks: walls in running bond, façades with openings and
 * the same façades turned by one radian, 1,000 to 100,000 blocks.
 *
 *   bench-contacts [--check] [BLOCKS…]
 *
 * Each beside one factorisation of the elastic stiffness matrix of the same model, and with what
 * it takes to find the contacts anew after one block has moved. Every time is the best of
 * several rounds through all sizes; in each round a small model is searched so often that as many
 * blocks pass as the large one has, so that a busy machine disturbs all sizes alike. What is demanded is in contacts-bars.csv: the contacts of 100,000 blocks within three
 * factorisations, and a growth exponent of at most 1.1; with --check the program fails where that
 * is not so. */
#include "bench/bench.h"
#include "bench/chart.h"
#include "bench/scaling-case.h"
#include "support/models.h"

#include <locale.h>
#include <math.h>

/* A machine that others use too gets so many chances to show what it can do. */
#define ROUNDS 15

/* Most sizes in one run. */
#define SIZES 32

/* Demands are for models where either time can be measured. */
#define LEAST_FOR_RATIO 50000

static gboolean check;

static Chart chart = { .name = "contacts",
                       .title = "Contact detection against the number of blocks",
                       .x_label = "Blocks",
                       .x_unit = "",
                       .y_label = "Time (s)" };

/* One size of a kind. */
typedef struct Size {
  int asked; /* blocks */
  ScalingCase c;
  double prepare, detect; /* best times so far, s */
} Size;

/* Mean time of so many detections, s. */
static double
time_detection (ScalingCase *c, size_t times)
{
  double seconds = 0;
  for (size_t i = 0; i < times; i++) {
    qn_contacts_clear (&c->contacts);
    double start = bench_cpu_seconds ();
    g_assert_cmpint (qn_contacts_detect (&c->model, &c->contacts, NULL), ==, QN_OK);
    seconds += bench_cpu_seconds () - start;
  }
  return seconds / (double) times;
}

/* One round for one size; `most` is how many blocks the largest one has. */
static void
time_size (Size *size, size_t most)
{
  ScalingCase *c = &size->c;
  double start = bench_cpu_seconds ();
  g_assert_cmpint (qn_model_prepare (&c->model, NULL), ==, QN_OK);
  size->prepare = fmin (size->prepare, bench_cpu_seconds () - start);
  size->detect = fmin (size->detect, time_detection (c, most / c->blocks));
  g_assert_cmpuint (c->contacts.findings.count, ==, 0);
}

static void
init_size (Size *size, const char *kind, int blocks)
{
  *size = (Size){ .asked = blocks, .prepare = G_MAXDOUBLE, .detect = G_MAXDOUBLE };
  scaling_case_init (&size->c, blocks, !g_str_equal (kind, "wall"));
  if (g_str_equal (kind, "turned façade"))
    test_model_rotate (&size->c.model, 1);
}

/* Writes down what was measured, beside a factorisation. */
static gboolean
report (FILE *csv, FILE *bars, const char *kind, Size *size)
{
  ScalingCase *c = &size->c;
  c->faces = c->contacts.face_count;
  scaling_case_elastic (c);
  double ratio = size->detect / c->factorization, kernel = bench_kernel_seconds ();
  bench_csv_row (csv, "%s,%zu,%zu,%.4f,%.4f,%.3f,%.4f,%.3f", kind, c->blocks, c->faces,
                 size->prepare, size->detect, size->detect / kernel, c->factorization,
                 ratio);
  chart_add (&chart, kind, (double) c->blocks, size->detect);
  if (!g_str_equal (kind, "turned façade")) {
    g_autofree char *label = g_strdup_printf ("factorisation, %s", kind);
    chart_add (&chart, label, (double) c->blocks, c->factorization);
  }
  if (size->asked < LEAST_FOR_RATIO)
    return TRUE;
  g_autofree char *what = g_strdup_printf ("%s of %d", kind, size->asked);
  return bench_bar (bars, "detection / factorisation", what, ratio, BENCH_AT_MOST, 3);
}

/* Slope of the line through the logarithms of blocks and seconds by least squares. */
static double
exponent (const Size *sizes, int count)
{
  double n = count, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (int i = 0; i < count; i++) {
    double x = log ((double) sizes[i].c.blocks), y = log (sizes[i].detect);
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

static gboolean
run_kind (FILE *csv, FILE *bars, const char *kind, const int *asked, int count)
{
  Size sizes[SIZES];
  size_t most = 0;
  gboolean met = TRUE;
  for (int i = 0; i < count; i++) {
    init_size (&sizes[i], kind, asked[i]);
    most = MAX (most, sizes[i].c.blocks);
  }
  for (int round = 0; round < ROUNDS; round++)
    for (int i = 0; i < count; i++)
      time_size (&sizes[i], most);
  for (int i = 0; i < count; i++)
    met &= report (csv, bars, kind, &sizes[i]);
  if (count > 1)
    met &= bench_bar (bars, "growth exponent", kind, exponent (sizes, count),
                      BENCH_AT_MOST, 1.1);
  for (int i = 0; i < count; i++)
    scaling_case_clear (&sizes[i].c);
  return met;
}

int
main (int argc, char **argv)
{
  static const char *const kinds[] = { "wall", "façade", "turned façade" };
  int sizes[SIZES] = { 1000, 3000, 10000, 30000, 100000 }, count = 5;
  const GOptionEntry entries[] = {
    { "check", 0, 0, G_OPTION_ARG_NONE, &check, "Fail where a demand is not met", NULL },
    G_OPTION_ENTRY_NULL,
  };
  g_autoptr (GOptionContext) context = g_option_context_new ("BLOCKS…");
  g_autoptr (GError) error = NULL;
  gboolean met = TRUE;

  setlocale (LC_ALL, "C.UTF-8");
  g_option_context_add_main_entries (context, entries, NULL);
  if (!g_option_context_parse (context, &argc, &argv, &error)) {
    fprintf (stderr, "bench-contacts: %s\n", error->message);
    return 2;
  }
  for (int i = 1; i < argc && i <= (int) G_N_ELEMENTS (sizes); i++)
    sizes[(count = i) - 1] = (int) g_ascii_strtoll (argv[i], NULL, 10);
  FILE *csv = bench_csv_open ("contacts",
                              "kind,blocks,faces,prepare s,detection s,detection/kernel,"
                              "factorisation s,detection/factorisation");
  FILE *bars = bench_bars_open ("contacts");
  for (size_t i = 0; i < G_N_ELEMENTS (kinds); i++)
    met &= run_kind (csv, bars, kinds[i], sizes, count);
  fclose (csv);
  fclose (bars);
  chart_write (&chart);
  return met || !check ? 0 : 1;
}
