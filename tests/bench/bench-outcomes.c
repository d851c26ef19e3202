/* Is every answer true? Seeded walls of up to 90 blocks (support/walls.h), each with one of the
 * laws that joints may have, in linear geometry and in large displacements in turn. Each is written as a
 * project, read, solved, written as a result, read, and checked as `quoin-cli check --result` does.
 *
 *   bench-outcomes [--first SEED] [--count N] [--most BLOCKS] [--joints NAME] [--uncertain N]
 *                  [--unsolved N] [--limit] [--save FOLDER]
 *
 * With --limit, every wall is answered by non-associative limit analysis, in linear geometry, and a proved
 * collapse of a path of prescribed work that lies outside the fixed points is told, and counted beside.
 * With --save, the walls are written there as projects. With --most, walls of more blocks are left out: for sanitizers and valgrind. With --joints, all walls
 * have the joints of this name. One line for each wall,
 * then the table: outcomes by geometry, uncertain mechanisms, and violations. A violation is a result
 * that cannot be read back, a statement that is not true, or a collapse above the associative bound,
 * which limit analysis gives for the same joints with dilatancy = friction. The program fails where
 * there is one, or where more mechanisms are uncertain than --uncertain says, or more walls have no answer
 * (not-converged) than --unsolved says. Structures in large
 * displacements may stiffen as they move (a joint that closes, an arch that thrusts more); theirs are
 * counted beside, and told. */
#include "bench/bench.h"
#include "core/limit/limit.h"
#include "core/path/analysis.h"
#include "io/result/result-file.h"
#include "io/text/fault-text.h"
#include "support/models.h"
#include "support/scratch.h"
#include "support/walls.h"

#include <locale.h>
#include <math.h>
#include <string.h>

/* A multiplier is that of a bound to this part. */
#define SAME 1e-6

/* A multiplier without associativity is no sharper than this part of it. */
#define OUTSIDE 0.01

typedef struct Options {
  int first, count, most_blocks, most_uncertain, most_unsolved;
  char *joints;   /* or NULL */
  char *save;     /* folder of the projects, or NULL */
  gboolean limit; /* by limit analysis */
} Options;

/* --- Joints ------------------------------------------------------------------------------- */

/* Mean weight of a block, N: what strengths are measured by. */
static double
mean_weight (const QnModel *model)
{
  g_auto (QnModel) copy;
  double sum = 0;

  g_assert_cmpint (qn_model_copy (model, &copy, NULL), ==, QN_OK);
  g_assert_cmpint (qn_model_prepare (&copy, NULL), ==, QN_OK);
  for (size_t i = 0; i < copy.block_count; i++)
    sum += copy.blocks[i].weight;
  sum /= (double) copy.block_count;
  return sum;
}

static void
dilate (QnModel *model, double part)
{
  model->laws[0].dilatancy = part * model->laws[0].friction;
}

static void
make_frictional (QnModel *model)
{
  dilate (model, 0);
}

static void
make_half_associative (QnModel *model)
{
  dilate (model, 0.5);
}

static void
make_associative (QnModel *model)
{
  dilate (model, 1);
}

static void
make_cohesive (QnModel *model)
{
  model->laws[0].cohesion = 0.5 * mean_weight (model);
  model->laws[0].tension = 0.25 * mean_weight (model);
}

static void
make_crushable (QnModel *model)
{
  model->laws[0].compression = 20 * mean_weight (model);
  model->laws[0].kind = QN_LAW_MOHR_COULOMB;
}

static void
make_tensionless (QnModel *model)
{
  model->laws[0].kind = QN_LAW_NO_TENSION;
}

static void
make_uneven (QnModel *model)
{
  test_model_soften_every_other_block (model, 100);
}

/* Laws of members, as joints that a wall might be glued with. */
static void
make_member (QnModel *model, QnLawKind kind)
{
  QnLaw *law = &model->laws[0];
  double weight = mean_weight (model);

  law->kind = kind;
  law->friction = law->cohesion = law->tension = 0;
  law->yield = 10 * weight;
  law->hardening = kind == QN_LAW_BILINEAR ? 0.05 : 0;
  law->strength = kind == QN_LAW_CONCRETE ? 40 * weight : 15 * weight;
  law->ultimate_strain = kind == QN_LAW_STEEL ? 100 * law->strength / law->kn : 0;
  law->fracture_energy =
    kind == QN_LAW_STEEL ? 1000 * law->strength * law->strength / law->kn : 0;
  if (kind == QN_LAW_CURVE) {
    law->point_count = 3;
    law->points[0] = qn_vec2 (-80 * weight / law->kn, -40 * weight);
    law->points[1] = qn_vec2 (-20 * weight / law->kn, -20 * weight);
    law->points[2] = qn_vec2 (2 * weight / law->kn, 2 * weight);
  }
}

static void
make_elastic (QnModel *model)
{
  make_member (model, QN_LAW_ELASTIC);
}

static void
make_plastic (QnModel *model)
{
  make_member (model, QN_LAW_ELASTIC_PLASTIC);
}

static void
make_hardening (QnModel *model)
{
  make_member (model, QN_LAW_BILINEAR);
}

static void
make_steel (QnModel *model)
{
  make_member (model, QN_LAW_STEEL);
}

static void
make_concrete (QnModel *model)
{
  make_member (model, QN_LAW_CONCRETE);
}

static void
make_curve (QnModel *model)
{
  make_member (model, QN_LAW_CURVE);
}

/* Friction without dilatancy, the common joint, more often than the others. */
static const struct {
  const char *name;
  void (*make) (QnModel *model);
} joints[] = {
  { "friction", make_frictional }, { "half associative", make_half_associative },
  { "friction", make_frictional }, { "associative", make_associative },
  { "friction", make_frictional }, { "cohesion", make_cohesive },
  { "friction", make_frictional }, { "crushing", make_crushable },
  { "friction", make_frictional }, { "no tension", make_tensionless },
  { "friction", make_frictional }, { "two stiffnesses", make_uneven },
  { "elastic", make_elastic },     { "elastic-plastic", make_plastic },
  { "bilinear", make_hardening },  { "steel", make_steel },
  { "concrete", make_concrete },   { "curve", make_curve },
};

/* --- One wall ----------------------------------------------------------------------------- */

typedef struct Wall {
  int seed;
  const char *joints;
  QnGeometry geometry;
  char kind[120];
  QnOutcome outcome;
  gboolean uncertain;
  double multiplier, bound; /* NAN: none */
  double path;              /* of prescribed work, where it is outside the fixed points */
  char *violation;          /* or NULL */
} Wall;

typedef struct Tally {
  int outcomes[QN_GEOMETRY_COUNT][QN_OUTCOME_COUNT];
  int uncertain[QN_GEOMETRY_COUNT];
  int bounded, violations, above[QN_GEOMETRY_COUNT], outside;
} Tally;

/* The place of joints by their name, or -1. */
static int
find_joints (const char *name)
{
  for (gsize i = 0; i < G_N_ELEMENTS (joints); i++)
    if (strcmp (joints[i].name, name) == 0)
      return (int) i;
  return -1;
}

static void
lay (Wall *wall, const Options *options, QnProject *project)
{
  QnModel model;
  QnProject drawn;
  g_autoptr (GError) error = NULL;
  gsize length;
  /* One after the other, each in both geometries. */
  int law = options->joints != NULL ? find_joints (options->joints)
                                    : wall->seed / 2 % (int) G_N_ELEMENTS (joints);

  test_wall_draw_any (&model, (guint32) wall->seed, wall->kind, sizeof wall->kind);
  g_strdelimit (wall->kind, ",", ';');
  joints[law].make (&model);
  wall->joints = joints[law].name;
  wall->geometry =
    options->limit || wall->seed % 2 == 0 ? QN_GEOMETRY_LINEAR : QN_GEOMETRY_NONLINEAR;
  model.analysis.geometry = wall->geometry;
  if (options->limit) {
    model.analysis.procedure = QN_PROCEDURE_LIMIT;
    model.analysis.flow = QN_FLOW_NON_ASSOCIATIVE;
  }
  qn_project_init (&drawn);
  qn_model_clear (&drawn.model);
  drawn.model = model;
  g_assert_cmpint (qn_model_prepare (&drawn.model, NULL), ==, QN_OK);
  g_autofree char *text = qn_project_to_text (&drawn, &length);
  g_autofree char *name = g_strdup_printf ("seed-%d.quoin", wall->seed);
  g_autofree char *path =
    options->save != NULL ? g_build_filename (options->save, name, NULL) : NULL;
  if (path != NULL && !g_file_set_contents (path, text, (gssize) length, &error))
    g_error ("%s", error->message);
  if (!qn_project_parse (text, length, "wall.quoin", NULL, project, &error))
    g_error ("seed %d: %s", wall->seed, error->message);
  qn_project_clear (&drawn);
}

/* The largest multiplier of equilibrium on the undeformed structure; NAN where limit analysis does not
 * know the joints, or does not end. */
static double
find_bound (const QnProject *project, const QnContacts *contacts)
{
  QnLimitSolution solution;
  double bound = NAN;

  if (qn_limit_associative (&project->model, contacts, NULL, NULL, &solution, NULL)
      != QN_OK)
    return NAN;
  if (solution.outcome == QN_OUTCOME_COLLAPSE)
    bound = solution.upper_bound;
  qn_limit_solution_clear (&solution);
  return bound;
}

/* What a result file says that is not true; NULL where all is. */
static char *
find_untruth (const QnResultFile *file, const QnProject *project,
              const QnContacts *contacts)
{
  QnResultFaults faults;
  g_autoptr (GError) error = NULL;

  if (!qn_result_file_find_faults (file, "wall.json", project, contacts, &faults, &error))
    return g_strdup (error->message);
  if (faults.count > 0)
    return qn_fault_dup_text (&project->model, contacts, &faults.items[0]);
  return NULL;
}

static char *
read_and_check (const char *path, const QnProject *project, const QnContacts *contacts)
{
  QnResultFile file;
  g_autoptr (GError) error = NULL;

  g_autoptr (GPtrArray) unproved = g_ptr_array_new_with_free_func (g_free);
  gsize length;
  g_autofree char *text = NULL;

  if (!g_file_get_contents (path, &text, &length, &error)
      || !qn_result_file_parse (text, length, path, &file, &error))
    return g_strdup (error->message);
  char *untruth = find_untruth (&file, project, contacts);
  if (untruth == NULL
      && !qn_result_text_agrees (text, length, path, &file, project, contacts, unproved,
                                 &error))
    untruth = g_strdup (error->message);
  qn_result_file_clear (&file);
  return untruth;
}

/* The multiplier of a path of prescribed work that is proved and lies outside the fixed points of limit
 * analysis; NAN where there is none. */
static double
find_outside (const QnProject *project, const QnContacts *contacts,
              const QnLimitFigures *limit)
{
  QnModel model = project->model; /* whose arrays stay the project's */
  g_auto (QnResult) path;
  double outside = NAN;

  model.analysis.procedure = QN_PROCEDURE_WORK;
  g_assert_cmpint (qn_analysis_run (&model, contacts, NULL, NULL, &path, NULL), ==,
                   QN_OK);
  if (path.has_collapse_multiplier && !path.mechanism_uncertain
      && (path.collapse_multiplier < (1 - OUTSIDE) * limit->lower_bound
          || path.collapse_multiplier > (1 + OUTSIDE) * limit->upper_bound))
    outside = path.collapse_multiplier;
  return outside;
}

/* FALSE, and nothing done, where the wall has more blocks than the options want. */
static gboolean
run (const char *folder, const Options *options, Wall *wall)
{
  QnProject project;
  QnContacts contacts;
  QnResult result;
  g_autoptr (GError) error = NULL;
  g_autofree char *path = g_build_filename (folder, "wall.json", NULL);

  lay (wall, options, &project);
  if (project.model.block_count > (size_t) options->most_blocks) {
    qn_project_clear (&project);
    return FALSE;
  }
  g_assert_cmpint (qn_contacts_detect (&project.model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (&project.model, &contacts, NULL, NULL, &result, NULL),
                   ==, QN_OK);
  wall->outcome = result.outcome;
  wall->uncertain = result.mechanism_uncertain;
  wall->multiplier = result.has_collapse_multiplier ? result.collapse_multiplier : NAN;
  wall->bound = result.has_collapse_multiplier ? find_bound (&project, &contacts) : NAN;
  wall->path =
    result.limit.given ? find_outside (&project, &contacts, &result.limit) : NAN;
  if (!qn_result_file_write (path, &project, &contacts, &result, QN_DETAIL_FORCES,
                             &error))
    g_error ("%s", error->message);
  wall->violation = read_and_check (path, &project, &contacts);
  if (wall->violation == NULL && wall->geometry == QN_GEOMETRY_LINEAR
      && wall->multiplier > wall->bound + SAME * (1 + fabs (wall->bound)))
    wall->violation = g_strdup ("above the associative bound");
  qn_result_clear (&result);
  qn_contacts_clear (&contacts);
  qn_project_clear (&project);
  return TRUE;
}

/* --- All ---------------------------------------------------------------------------------- */

static char *
number_text (double number)
{
  return isnan (number) ? g_strdup ("") : g_strdup_printf ("%.6g", number);
}

static void
tell (FILE *csv, const Wall *wall, Tally *tally)
{
  g_autofree char *multiplier = number_text (wall->multiplier);
  g_autofree char *bound = number_text (wall->bound);

  g_autofree char *path = number_text (wall->path);
  bench_csv_row (
    csv, "%d,%s,%s,%s,%s,%s,%s,%s,%s,%s", wall->seed, wall->kind, wall->joints,
    wall->geometry == QN_GEOMETRY_LINEAR ? "linear" : "nonlinear",
    qn_outcome_names[wall->outcome], multiplier, bound, wall->uncertain ? "yes" : "no",
    path, wall->violation != NULL ? wall->violation : "");
  tally->outcomes[wall->geometry][wall->outcome]++;
  tally->uncertain[wall->geometry] += wall->uncertain;
  tally->bounded += isfinite (wall->bound);
  tally->above[wall->geometry] +=
    wall->multiplier > wall->bound + SAME * (1 + fabs (wall->bound));
  tally->outside += isfinite (wall->path);
  tally->violations += wall->violation != NULL;
}

static void
print_row (const char *name, int linear, int nonlinear)
{
  if (linear + nonlinear > 0)
    printf ("| %s | %d | %d |\n", name, linear, nonlinear);
}

static void
print_table (const Tally *tally)
{
  printf ("\n| outcome | linear | large displacements |\n| --- | --- | --- |\n");
  for (int i = 0; i < QN_OUTCOME_COUNT; i++)
    print_row (qn_outcome_names[i], tally->outcomes[QN_GEOMETRY_LINEAR][i],
               tally->outcomes[QN_GEOMETRY_NONLINEAR][i]);
  print_row ("uncertain mechanism", tally->uncertain[QN_GEOMETRY_LINEAR],
             tally->uncertain[QN_GEOMETRY_NONLINEAR]);
  print_row ("above the bound of the undeformed structure",
             tally->above[QN_GEOMETRY_LINEAR], tally->above[QN_GEOMETRY_NONLINEAR]);
  print_row ("path outside the fixed points", tally->outside, 0);
  printf ("\n%d collapses have an associative bound; %d violations\n", tally->bounded,
          tally->violations);
}

static gboolean
parse (int *argc, char ***argv, Options *options, GError **error)
{
  const GOptionEntry entries[] = {
    { "first", 0, 0, G_OPTION_ARG_INT, &options->first, "First seed (1)", "SEED" },
    { "count", 0, 0, G_OPTION_ARG_INT, &options->count, "How many walls (1000)", "N" },
    { "most", 0, 0, G_OPTION_ARG_INT, &options->most_blocks, "Most blocks of a wall",
      "BLOCKS" },
    { "joints", 0, 0, G_OPTION_ARG_STRING, &options->joints,
      "Joints of all walls (in turn)", "NAME" },
    { "uncertain", 0, 0, G_OPTION_ARG_INT, &options->most_uncertain,
      "Most uncertain mechanisms (any number)", "N" },
    { "unsolved", 0, 0, G_OPTION_ARG_INT, &options->most_unsolved,
      "Most walls without answer (any number)", "N" },
    { "save", 0, 0, G_OPTION_ARG_FILENAME, &options->save, "Writes the walls there",
      "FOLDER" },
    { "limit", 0, 0, G_OPTION_ARG_NONE, &options->limit,
      "By non-associative limit analysis", NULL },
    G_OPTION_ENTRY_NULL,
  };
  g_autoptr (GOptionContext) context = g_option_context_new (NULL);
  g_option_context_add_main_entries (context, entries, NULL);
  if (!g_option_context_parse (context, argc, argv, error))
    return FALSE;
  if (options->first < 1 || options->count < 1 || options->most_blocks < 1) {
    g_set_error (error, G_OPTION_ERROR, G_OPTION_ERROR_BAD_VALUE,
                 "seeds and counts from 1");
    return FALSE;
  }
  if (options->joints != NULL && find_joints (options->joints) < 0) {
    g_set_error (error, G_OPTION_ERROR, G_OPTION_ERROR_BAD_VALUE,
                 "no joints are called %s", options->joints);
    return FALSE;
  }
  return TRUE;
}

int
main (int argc, char **argv)
{
  Options options = { .first = 1,
                      .count = 1000,
                      .most_blocks = G_MAXINT,
                      .most_uncertain = G_MAXINT,
                      .most_unsolved = G_MAXINT };
  Tally tally = { 0 };
  g_autoptr (GError) error = NULL;

  setlocale (LC_ALL, "C.UTF-8");
  if (!parse (&argc, &argv, &options, &error)) {
    fprintf (stderr, "bench-outcomes: %s\n", error->message);
    return 2;
  }
  char *folder = test_scratch_new ();
  FILE *csv =
    bench_csv_open ("outcomes", "seed,wall,joints,geometry,outcome,collapse multiplier,"
                                "associative bound,uncertain,path outside,violation");
  for (int i = 0; i < options.count; i++) {
    Wall wall = { .seed = options.first + i };
    if (!run (folder, &options, &wall))
      continue;
    tell (csv, &wall, &tally);
    g_free (wall.violation);
  }
  fclose (csv);
  print_table (&tally);
  test_scratch_free (folder);
  g_free (options.joints);
  g_free (options.save);
  int uncertain =
    tally.uncertain[QN_GEOMETRY_LINEAR] + tally.uncertain[QN_GEOMETRY_NONLINEAR];
  int unsolved = tally.outcomes[QN_GEOMETRY_LINEAR][QN_OUTCOME_NOT_CONVERGED]
                 + tally.outcomes[QN_GEOMETRY_NONLINEAR][QN_OUTCOME_NOT_CONVERGED];
  return tally.violations == 0 && uncertain <= options.most_uncertain
             && unsolved <= options.most_unsolved
           ? 0
           : 1;
}
