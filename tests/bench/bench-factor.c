/* The factorisations that could serve the tangents: the program's own block LU
 * (core/linalg/block-lu.h) beside KLU and UMFPACK of SuiteSparse.
 *
 *   bench-factor [BLOCKS…]
 *
 * The matrices are tangent stiffnesses of the six walls and of generated walls and façades
 * (scaling-case.h) of about BLOCKS blocks: with all joints elastic, and with joints that slip and
 * open under the dead load and half of the live load (displacements of the elastic structure, a
 * little viscosity for blocks that nothing holds), which is unsymmetric. Each time is the least of
 * several, of the process, in milliseconds: ordering and analysis once, then one numeric
 * factorisation with one solution. The residual of that solution is relative to the load. KLU's
 * klu_refactor keeps the pivots of the first factorisation. */
#include "bench/bench.h"
#include "bench/scaling-case.h"
#include "core/assembly/assembly.h"
#include "core/linalg/block-lu.h"
#include "support/models.h"

#include <klu.h>
#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <umfpack.h>

/* So many times everything is done, at least; more for small structures. */
#define ROUNDS        5
#define LEAST_SECONDS 0.2

/* Viscosity of the tangent of slipping joints, relative to the stiffness. */
#define VISCOSITY 1e-3

typedef struct {
  int32_t n;
  int32_t *ap, *ai;
  double *ax;
  double *b, *x; /* load and solution */
} System;

/* One of the libraries; analysis, and factorisation with a solution, are called again and again. */
typedef struct {
  const char *name;
  void *(*analyse) (const System *system);
  void (*factor_and_solve) (void *state, const System *system);
  void (*release) (void *state);
} Solver;

/* --- Block LU --------------------------------------------------------------------------- */

static void *
block_analyse (const System *s)
{
  return qn_block_lu_new (s->n, s->ap, s->ai, NULL);
}

static void
block_solve (void *state, const System *s)
{
  g_assert_cmpfloat (qn_block_lu_factor (state, s->ax), >, 0);
  memcpy (s->x, s->b, (size_t) s->n * sizeof *s->x);
  qn_block_lu_solve (state, s->x);
}

static void
block_release (void *state)
{
  qn_block_lu_free (state);
}

/* --- KLU -------------------------------------------------------------------------------- */

typedef struct {
  klu_common common;
  klu_symbolic *symbolic;
  klu_numeric *numeric;
} Klu;

/* With the settings of core/linalg/linsys.c. */
static void *
klu_begin (const System *s)
{
  Klu *klu = g_new0 (Klu, 1);
  klu_defaults (&klu->common);
  klu->common.btf = 0;
  klu->common.ordering = 0;
  klu->common.tol = 0.001;
  klu->common.scale = 0;
  klu->symbolic = klu_analyze (s->n, s->ap, s->ai, &klu->common);
  return klu;
}

static void
klu_finish (Klu *klu, const System *s)
{
  memcpy (s->x, s->b, (size_t) s->n * sizeof *s->x);
  klu_solve (klu->symbolic, klu->numeric, s->n, 1, s->x, &klu->common);
}

static void
klu_solve_anew (void *state, const System *s)
{
  Klu *klu = state;
  klu_free_numeric (&klu->numeric, &klu->common);
  klu->numeric = klu_factor (s->ap, s->ai, s->ax, klu->symbolic, &klu->common);
  klu_finish (klu, s);
}

static void
klu_solve_again (void *state, const System *s)
{
  Klu *klu = state;
  if (klu->numeric == NULL)
    klu_solve_anew (state, s);
  klu_refactor (s->ap, s->ai, s->ax, klu->symbolic, klu->numeric, &klu->common);
  klu_finish (klu, s);
}

static void
klu_release (void *state)
{
  Klu *klu = state;
  klu_free_numeric (&klu->numeric, &klu->common);
  klu_free_symbolic (&klu->symbolic, &klu->common);
  g_free (klu);
}

/* --- UMFPACK ---------------------------------------------------------------------------- */

static void *
umfpack_begin (const System *s)
{
  void *symbolic = NULL;
  g_assert_cmpint (
    umfpack_di_symbolic (s->n, s->n, s->ap, s->ai, s->ax, &symbolic, NULL, NULL), ==,
    UMFPACK_OK);
  return symbolic;
}

/* Without iterative refinement, as the others. */
static void
umfpack_factor_and_solve (void *state, const System *s)
{
  double control[UMFPACK_CONTROL];
  void *numeric = NULL;
  umfpack_di_defaults (control);
  control[UMFPACK_IRSTEP] = 0;
  g_assert_cmpint (
    umfpack_di_numeric (s->ap, s->ai, s->ax, state, &numeric, control, NULL), >=,
    UMFPACK_OK);
  umfpack_di_solve (UMFPACK_A, s->ap, s->ai, s->ax, s->x, s->b, numeric, control, NULL);
  umfpack_di_free_numeric (&numeric);
}

static void
umfpack_release (void *state)
{
  umfpack_di_free_symbolic (&state);
}

static const Solver solvers[] = {
  { "block LU", block_analyse, block_solve, block_release },
  { "KLU", klu_begin, klu_solve_anew, klu_release },
  { "KLU refactor", klu_begin, klu_solve_again, klu_release },
  { "UMFPACK", umfpack_begin, umfpack_factor_and_solve, umfpack_release },
};

/* ---------------------------------------------------------------------------------------- */

/* Largest |b - A x| over the largest |b|. */
static double
residual (const System *s)
{
  g_autofree double *left = g_memdup2 (s->b, (gsize) s->n * sizeof *s->b);
  double worst = 0, largest = 0;
  for (int32_t j = 0; j < s->n; j++)
    for (int32_t e = s->ap[j]; e < s->ap[j + 1]; e++)
      left[s->ai[e]] -= s->ax[e] * s->x[j];
  for (int32_t i = 0; i < s->n; i++) {
    worst = fmax (worst, fabs (left[i]));
    largest = fmax (largest, fabs (s->b[i]));
  }
  return worst / largest;
}

static void
measure (FILE *csv, const char *kind, size_t blocks, const char *tangent, const System *s)
{
  double first = NAN;
  for (gsize k = 0; k < G_N_ELEMENTS (solvers); k++) {
    double analysis = G_MAXDOUBLE, solution = G_MAXDOUBLE;
    double begun = bench_cpu_seconds ();
    for (int round = 0; round < ROUNDS || bench_cpu_seconds () - begun < LEAST_SECONDS;
         round++) {
      double start = bench_cpu_seconds ();
      void *state = solvers[k].analyse (s);
      g_assert_nonnull (state);
      analysis = fmin (analysis, bench_cpu_seconds () - start);
      for (int time = 0; time < 3; time++) {
        start = bench_cpu_seconds ();
        solvers[k].factor_and_solve (state, s);
        solution = fmin (solution, bench_cpu_seconds () - start);
      }
      solvers[k].release (state);
    }
    first = k == 0 ? solution : first;
    bench_csv_row (csv, "%s,%zu,%d,%s,%s,%.2f,%.3f,%.2f,%.1e", kind, blocks, s->n,
                   tangent, solvers[k].name, 1e3 * analysis, 1e3 * solution,
                   solution / first, residual (s));
  }
}

static void
run (FILE *csv, const char *kind, const QnModel *model, const QnContacts *contacts)
{
  QnAssembly as;
  g_assert_cmpint (qn_assembly_setup (&as, model, contacts, NULL), ==, QN_OK);
  size_t n = (size_t) as.unknown_count;
  g_autofree double *u = g_new0 (double, n), *b = g_new0 (double, n);
  System s = { as.unknown_count, as.ap, as.ai, as.ax, b, u };

  for (size_t i = 0; i < n; i++)
    b[i] = as.dead[i] + 0.5 * as.live[i];
  g_assert_true (qn_assembly_evaluate (&as, u));
  qn_assembly_tangent (&as, 0, 0);
  measure (csv, kind, model->block_count, "elastic", &s);
  void *lu = block_analyse (&s);
  block_solve (lu, &s);
  block_release (lu);
  g_assert_true (qn_assembly_evaluate (&as, u));
  qn_assembly_tangent (&as, 0.5, VISCOSITY);
  g_assert_false (qn_assembly_is_symmetric (&as));
  measure (csv, kind, model->block_count, "slipping", &s);
  qn_assembly_clear (&as);
}

int
main (int argc, char **argv)
{
  g_autoptr (GError) error = NULL;
  setlocale (LC_ALL, "");
  g_autoptr (GOptionContext) context = g_option_context_new ("BLOCKS…");
  if (!g_option_context_parse (context, &argc, &argv, &error)) {
    g_printerr ("bench-factor: %s\n", error->message);
    return 2;
  }
  FILE *csv = bench_csv_open ("factor", "kind,blocks,unknowns,tangent,solver,analysis ms,"
                                        "factor and solve ms,over block LU,residual");
  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    g_autofree char *name = g_strdup_printf ("wall %d", number);
    QnModel model;
    QnContacts contacts;
    test_model_init_wall (&model, number, 0);
    g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
    g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
    run (csv, name, &model, &contacts);
    qn_contacts_clear (&contacts);
    qn_model_clear (&model);
  }
  for (int i = 1; i < argc; i++)
    for (int facade = 0; facade < 2; facade++) {
      ScalingCase c;
      scaling_case_init (&c, atoi (argv[i]), facade);
      scaling_case_detect (&c);
      run (csv, c.kind, &c.model, &c.contacts);
      scaling_case_clear (&c);
    }
  fclose (csv);
  return 0;
}
