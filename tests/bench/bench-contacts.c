/* Contact detection against the number of blocks: walls in running bond, façades with openings and
 * the same façades turned by one radian, 1,000 to 100,000 blocks.
 *
 *   bench-contacts [--check] [BLOCKS…]
 *
 * Each beside one factorisation of the elastic stiffness matrix of the same model, and with what
 * it takes to find the contacts anew after one block has moved. Every time is the best of
 * several. What is demanded is in contacts-bars.csv: the contacts of 100,000 blocks within three
 * factorisations, and a growth exponent of at most 1.1; with --check the program fails where that
 * is not so. */
#include "bench/bench.h"
#include "bench/chart.h"
#include "bench/scaling-case.h"
#include "support/models.h"

#include <locale.h>
#include <math.h>

/* A machine that others use too gets so many chances to show what it can do. */
#define ROUNDS 5

/* Demands are for models where either time can be measured. */
#define LEAST_FOR_RATIO 50000

static gboolean check;

static Chart chart = { .name = "contacts",
                       .title = "Contact detection against the number of blocks",
                       .x_label = "Blocks",
                       .x_unit = "",
                       .y_label = "Time (s)" };

/* Best times so far, s. */
typedef struct Timing {
  double prepare, detect, update;
} Timing;

/* What detection takes for all sizes of a kind. */
typedef struct Growth {
  GArray *blocks, *seconds; /* logarithms */
} Growth;

/* Moves one block a little and updates. */
static double
time_update (const QnModel *model, const QnContacts *contacts)
{
  QnModel moved;
  QnContacts updated;
  g_assert_cmpint (qn_model_copy (model, &moved, NULL), ==, QN_OK);
  const QnBlock *block = &moved.blocks[moved.block_count / 2];
  for (QnId i = 0; i < block->vertex_count; i++)
    moved.vertices[block->first_vertex + i].x += 0.05;
  double start = bench_cpu_seconds ();
  g_assert_cmpint (qn_contacts_update (model, contacts, &moved, &updated, NULL), ==,
                   QN_OK);
  double seconds = bench_cpu_seconds () - start;
  qn_contacts_clear (&updated);
  qn_model_clear (&moved);
  return seconds;
}

static Timing
time_model (ScalingCase *c)
{
  Timing best = { .prepare = G_MAXDOUBLE, .detect = G_MAXDOUBLE, .update = G_MAXDOUBLE };
  for (int round = 0; round < ROUNDS; round++) {
    double start = bench_cpu_seconds ();
    g_assert_cmpint (qn_model_prepare (&c->model, NULL), ==, QN_OK);
    best.prepare = fmin (best.prepare, bench_cpu_seconds () - start);
    if (round > 0)
      qn_contacts_clear (&c->contacts);
    start = bench_cpu_seconds ();
    g_assert_cmpint (qn_contacts_detect (&c->model, &c->contacts, NULL), ==, QN_OK);
    best.detect = fmin (best.detect, bench_cpu_seconds () - start);
    best.update = fmin (best.update, time_update (&c->model, &c->contacts));
    g_assert_cmpuint (c->contacts.findings.count, ==, 0);
  }
  c->faces = c->contacts.face_count;
  return best;
}

static gboolean
run (FILE *csv, FILE *bars, const char *kind, int blocks, Growth *growth)
{
  ScalingCase c;
  gboolean turned = g_str_equal (kind, "turned façade"), met = TRUE;
  scaling_case_init (&c, blocks, !g_str_equal (kind, "wall"));
  if (turned)
    test_model_rotate (&c.model, 1);
  Timing best = time_model (&c);
  scaling_case_elastic (&c);
  double ratio = best.detect / c.factorization, kernel = bench_kernel_seconds ();
  bench_csv_row (csv, "%s,%zu,%zu,%.4f,%.4f,%.3f,%.4f,%.3f,%.4f,%.3f", kind, c.blocks,
                 c.faces, best.prepare, best.detect, best.detect / kernel, best.update,
                 best.update / kernel, c.factorization, ratio);
  chart_add (&chart, kind, (double) c.blocks, best.detect);
  if (!turned) {
    g_autofree char *label = g_strdup_printf ("factorisation, %s", kind);
    chart_add (&chart, label, (double) c.blocks, c.factorization);
  }
  if (blocks >= LEAST_FOR_RATIO) {
    g_autofree char *what = g_strdup_printf ("%s of %d", kind, blocks);
    met = bench_bar (bars, "detection / factorisation", what, ratio, BENCH_AT_MOST, 3);
  }
  double x = log ((double) c.blocks), y = log (best.detect);
  g_array_append_val (growth->blocks, x);
  g_array_append_val (growth->seconds, y);
  scaling_case_clear (&c);
  return met;
}

/* Slope of the line through the logarithms by least squares. */
static double
exponent (const Growth *growth)
{
  double n = growth->blocks->len, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (guint i = 0; i < growth->blocks->len; i++) {
    double x = g_array_index (growth->blocks, double, i);
    double y = g_array_index (growth->seconds, double, i);
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

static gboolean
run_kind (FILE *csv, FILE *bars, const char *kind, const int *sizes, int count)
{
  Growth growth = { g_array_new (FALSE, FALSE, sizeof (double)),
                    g_array_new (FALSE, FALSE, sizeof (double)) };
  gboolean met = TRUE;
  for (int i = 0; i < count; i++)
    met &= run (csv, bars, kind, sizes[i], &growth);
  if (count > 1)
    met &=
      bench_bar (bars, "growth exponent", kind, exponent (&growth), BENCH_AT_MOST, 1.1);
  g_array_unref (growth.blocks);
  g_array_unref (growth.seconds);
  return met;
}

int
main (int argc, char **argv)
{
  static const char *const kinds[] = { "wall", "façade", "turned façade" };
  int sizes[32] = { 1000, 3000, 10000, 30000, 100000 }, count = 5;
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
  FILE *csv = bench_csv_open (
    "contacts", "kind,blocks,faces,prepare s,detection s,detection/kernel,update s,"
                "update/kernel,factorisation s,detection/factorisation");
  FILE *bars = bench_bars_open ("contacts");
  for (size_t i = 0; i < G_N_ELEMENTS (kinds); i++)
    met &= run_kind (csv, bars, kinds[i], sizes, count);
  fclose (csv);
  fclose (bars);
  chart_write (&chart);
  return met || !check ? 0 : 1;
}
