/* Error of continuous members against blocks, pairs and processor time: the cantilever of beam
 * theory in linear geometry, the elastica in nonlinear geometry. */
#include "bench/bench.h"
#include "bench/chart.h"
#include "core/path/analysis.h"
#include "support/models.h"

#include <math.h>

/* A way to place pairs on a face. */
typedef struct Rule {
  const char *name;
  QnPairRule pairs;
} Rule;

static const Rule rules[] = {
  { "gauss 2", { .placement = QN_PLACEMENT_GAUSS, .count = 2 } },
  { "uniform 2", { .placement = QN_PLACEMENT_UNIFORM, .count = 2 } },
  { "uniform 3", { .placement = QN_PLACEMENT_UNIFORM, .count = 3 } },
  { "uniform 10", { .placement = QN_PLACEMENT_UNIFORM, .count = 10 } },
  { "uniform 30", { .placement = QN_PLACEMENT_UNIFORM, .count = 30 } },
};

static Chart by_blocks = { .name = "cantilever",
                           .title = "Cantilever: error of the tip's displacement",
                           .x_label = "Blocks",
                           .x_unit = "",
                           .y_label = "Error (%)" };
static Chart by_time = { .name = "cantilever-time",
                         .title = "Cantilever, 4 to 128 blocks: error of the tip's "
                                  "displacement against processor time",
                         .x_label = "Time",
                         .x_unit = "s",
                         .y_label = "Error (%)" };
static Chart by_pairs = { .name = "elastica-pairs",
                          .title = "Elastica at PL²/EI = 2, 8 to 128 blocks: error "
                                   "against processor time, by pairs",
                          .x_label = "Time",
                          .x_unit = "s",
                          .y_label = "Error (%)" };
static Chart by_load = { .name = "elastica",
                         .title = "Elastica, 8 to 128 blocks: error of the tip's "
                                  "displacement against processor time",
                         .x_label = "Time",
                         .x_unit = "s",
                         .y_label = "Error (%)" };

typedef struct Member {
  double length, depth, width, young; /* m, Pa; nu = 0 */
} Member;

/* Equal blocks from the clamped section to the load, both at centroids, so that every face stands
 * for as much of the member as there is between two of them. */
static void
init_member (QnModel *model, const Member *member, int blocks, QnPairRule pairs,
             double force)
{
  const double h = member->length / (blocks - 1);
  qn_model_init (model);
  QnLaw *law = qn_model_add_law (model, "member");
  *law = (QnLaw){ .name = law->name,
                  .kind = QN_LAW_ELASTIC,
                  .basis = QN_BASIS_MATERIAL,
                  .kn = member->young,
                  .ks = member->young / 2,
                  .shear_factor = 5. / 6 };
  model->contact.law = 0;
  model->contact.pairs = pairs;
  for (int i = 0; i < blocks; i++) {
    g_autofree char *name = g_strdup_printf ("b%d", i);
    QnBlock *block = test_model_add_rectangle (model, name, (i - 0.5) * h,
                                               -member->depth / 2, h, member->depth);
    block->thickness = member->width;
    if (i == 0)
      block->support[0] = block->support[1] = block->support[2] = true;
  }
  QnLoad *load = qn_model_add_live_load (model);
  load->kind = QN_LOAD_FORCE;
  load->block = (QnId) model->block_count - 1;
  load->vector = qn_vec2 (0, -force);
}

/* Downward displacement of the tip, m, NAN where the path did not arrive; *seconds is what the
 * solution took. */
static double
solve_tip (QnModel *model, double *seconds, int *factorizations)
{
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (model, &contacts, NULL), ==, QN_OK);
  double start = bench_cpu_seconds ();
  g_assert_cmpint (qn_analysis_run (model, &contacts, NULL, NULL, &result, NULL), ==,
                   QN_OK);
  *seconds = bench_cpu_seconds () - start;
  *factorizations = result.statistics.factorizations;
  double tip = NAN;
  if (result.outcome == QN_OUTCOME_TARGET_REACHED)
    tip = -qn_result_step_displacements (
      &result,
      result.step_count - 1)[QN_DOF_COUNT * (model->block_count - 1) + QN_DOF_UY];
  qn_model_clear (model);
  return tip;
}

/* L 3 m, 0.5 x 0.2 m, 30 GPa, 100 kN: 14.400 mm of bending and 0.240 mm of shear. */
static void
run_cantilever (FILE *csv, int blocks, const Rule *rule)
{
  const Member member = { 3, 0.5, 0.2, 30e9 };
  const double exact = 14.640e-3;
  QnModel model;
  double seconds;
  int factorizations;

  init_member (&model, &member, blocks, rule->pairs, 100e3);
  model.analysis.increments = 1;
  model.analysis.max_multiplier = 1;
  double tip = solve_tip (&model, &seconds, &factorizations);
  double error = 100 * (tip / exact - 1);
  bench_csv_row (csv, "cantilever,,%d,%s,%.6f,%.6f,%+.5f,%.5f,%.4f,%d", blocks,
                 rule->name, 1e3 * tip, 1e3 * exact, error, seconds,
                 seconds / bench_kernel_seconds (), factorizations);
  chart_add (&by_blocks, rule->name, blocks, fabs (error));
  chart_add (&by_time, rule->name, seconds, fabs (error));
}

/* Tip load a = P L^2 / EI, deflection w / L by elliptic integrals; the member is slender, so that
 * shear and stretching stay below 0.01 %. */
static void
run_elastica (FILE *csv, int blocks, const Rule *rule, double a, double exact)
{
  const Member member = { 1, 0.005, 0.1, 200e9 };
  double inertia = member.width * pow (member.depth, 3) / 12, seconds;
  int factorizations;
  QnModel model;

  init_member (&model, &member, blocks, rule->pairs,
               a * member.young * inertia / pow (member.length, 2));
  model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  model.analysis.increments = 100;
  model.analysis.max_multiplier = 1;
  double tip = solve_tip (&model, &seconds, &factorizations) / member.length;
  double error = 100 * (tip / exact - 1);
  bench_csv_row (csv, "elastica,%g,%d,%s,%.6f,%.6f,%+.5f,%.5f,%.4f,%d", a, blocks,
                 rule->name, tip, exact, error, seconds,
                 seconds / bench_kernel_seconds (), factorizations);
  if (rule == &rules[0]) {
    g_autofree char *label = g_strdup_printf ("PL²/EI = %g", a);
    chart_add (&by_load, label, seconds, fabs (error));
  }
  if (a == 2)
    chart_add (&by_pairs, rule->name, seconds, fabs (error));
}

int
main (int argc, char **argv)
{
  /* Mattiasson 1981. */
  static const double loads[][2] = {
    { 1, 0.30172 }, { 2, 0.49346 }, { 5, 0.71379 }, { 10, 0.81061 }
  };
  bench_no_arguments (
    argc, argv, "Error of continuous members against blocks, pairs and processor time.");
  FILE *csv =
    bench_csv_open ("members", "case,PL2/EI,blocks,pairs,value (mm; w/L),exact,error %,"
                               "time s,time/kernel,factorisations");
  for (size_t r = 0; r < G_N_ELEMENTS (rules); r++)
    for (int blocks = 4; blocks <= 128; blocks *= 2)
      run_cantilever (csv, blocks, &rules[r]);
  for (size_t r = 0; r < G_N_ELEMENTS (rules); r++)
    for (size_t i = 0; i < G_N_ELEMENTS (loads); i++)
      for (int blocks = 8; blocks <= 128; blocks *= 2)
        run_elastica (csv, blocks, &rules[r], loads[i][0], loads[i][1]);
  fclose (csv);
  chart_write (&by_blocks);
  chart_write (&by_time);
  chart_write (&by_load);
  chart_write (&by_pairs);
  return 0;
}
