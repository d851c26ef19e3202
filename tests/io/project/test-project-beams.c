/* Sections, nodes and beams: read, written and read again; what is refused, with its place; and
 * results that hold their forces. */
#include "core/path/analysis.h"
#include "io/project-text.h"
#include "io/result/result-file.h"
#include "support/auto-clear.h"
#include "support/room.h"
#include "support/scratch.h"

#include <string.h>

/* A block on a plane, tied to a support by a beam that is hinged there, a strut below it. */
static const char text[] =
  "{ \"format\": \"quoin\", \"version\": 1, \"gravity\": 10,\n"
  "  \"laws\": [{ \"name\": \"joint\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,\n"
  "    \"friction\": 0.6 }],\n"
  "  \"blocks\": [\n"
  "    { \"name\": \"base\", \"vertices\": [[-2, -1], [2, -1], [2, 0], [-2, 0]],\n"
  "      \"thickness\": 1, \"unit_weight\": 1, \"support\": [true, true, true] },\n"
  "    { \"name\": \"stone\", \"vertices\": [[0, 0], [1, 0], [1, 2], [0, 2]],\n"
  "      \"thickness\": 1, \"density\": 2000 } ],\n"
  "  \"sections\": [\n"
  "    { \"name\": \"oak\", \"young\": 1e10, \"poisson\": 0.3, \"width\": 0.1,\n"
  "      \"height\": 0.2, \"yield\": 3e7, \"density\": 700 },\n"
  "    { \"name\": \"iron\", \"young\": 2e11, \"shear_modulus\": 8e10, \"area\": 2e-3,\n"
  "      \"inertia\": 4e-7, \"shear_factor\": 0.4, \"plastic_moment\": 9e3,\n"
  "      \"unit_weight\": 77e3 } ],\n"
  "  \"nodes\": [\n"
  "    { \"name\": \"top\", \"block\": \"stone\", \"side\": \"top\" },\n"
  "    { \"name\": \"heart\", \"block\": \"stone\" },\n"
  "    { \"name\": \"ear\", \"block\": \"stone\", \"at\": [1, 0.5] },\n"
  "    { \"name\": \"wall\", \"at\": [4, 2], \"support\": [true, true, false] },\n"
  "    { \"name\": \"foot\", \"at\": [3, 0], \"support\": [true, true, true] } ],\n"
  "  \"beams\": [\n"
  "    { \"name\": \"tie\", \"nodes\": [\"top\", \"wall\"], \"section\": \"oak\",\n"
  "      \"hinges\": [false, true], \"elements\": 3 },\n"
  "    { \"name\": \"strut\", \"kind\": \"euler-bernoulli\", \"nodes\": [\"ear\", "
  "\"foot\"],\n"
  "      \"section\": \"iron\" },\n"
  "    { \"name\": \"brace\", \"nodes\": [\"heart\", \"wall\"], \"section\": \"iron\",\n"
  "      \"hinges\": [true, true] } ],\n"
  "  \"contact\": { \"law\": \"joint\" },\n"
  "  \"loads\": { \"dead\": [{ \"kind\": \"weight\", \"direction\": [0, -1] },\n"
  "      { \"kind\": \"line\", \"beam\": \"tie\", \"value\": [0, -300] }],\n"
  "    \"live\": [\n"
  "      { \"kind\": \"force\", \"node\": \"tie.2\", \"value\": [100, -400], \"moment\": "
  "30 },\n"
  "      { \"kind\": \"force\", \"node\": \"ear\", \"value\": [50, 0] },\n"
  "      { \"kind\": \"force\", \"block\": \"stone\", \"value\": [200, 0], \"at\": [0, "
  "2] }] },\n"
  "  \"analysis\": { \"procedure\": \"displacement\", \"control\": { \"node\": "
  "\"tie.1\",\n"
  "      \"component\": \"uy\", \"target\": -1e-3 } } }\n";

static void
test_read (void)
{
  g_auto (QnProject) project;
  test_parse (text, &project);
  const QnModel *model = &project.model;
  g_assert_cmpuint (project.warnings->len, ==, 0);
  g_assert_cmpuint (model->node_count, ==, 7);
  g_assert_cmpuint (model->element_count, ==, 5);
  g_assert_cmpfloat (model->nodes[0].at.y, ==, 2);
  g_assert_cmpfloat (model->nodes[1].at.y, ==, 1);
  g_assert_cmpint (model->nodes[2].seat, ==, QN_SEAT_POINT);
  g_assert_true (model->nodes[3].support[1] && !model->nodes[3].support[2]);
  g_assert_cmpfloat_with_epsilon (model->sections[0].unit_weight, 7000, 1e-9);
  g_assert_cmpfloat_with_epsilon (qn_section_plastic_moment (&model->sections[0]), 3e4,
                                  1e-6);
  g_assert_true (model->beams[0].hinge[1] && !model->beams[0].hinge[0]);
  g_assert_cmpint (model->live_loads[0].kind, ==, QN_LOAD_NODE);
  g_assert_cmpint (model->live_loads[0].node, ==, qn_model_find_node (model, "tie.2"));
  g_assert_cmpint (model->dead_loads[1].kind, ==, QN_LOAD_LINE);
  g_assert_cmpint (model->analysis.control.node, ==, qn_model_find_node (model, "tie.1"));
  g_assert_cmpint (model->analysis.control.block, ==, QN_NONE);
}

/* The canonical layout says all that there is: what it is read as writes the same bytes. */
static void
test_round_trip (void)
{
  g_auto (QnProject) project, again;
  test_parse (text, &project);
  g_autofree char *written = qn_project_to_text (&project, NULL);
  test_parse (written, &again);
  g_autofree char *rewritten = qn_project_to_text (&again, NULL);
  g_assert_cmpstr (written, ==, rewritten);
  g_assert_cmpuint (again.model.node_count, ==, project.model.node_count);
  g_assert_cmpuint (again.model.element_count, ==, project.model.element_count);
  for (size_t i = 0; i < again.model.node_count; i++) {
    const QnNode *a = &project.model.nodes[i], *b = &again.model.nodes[i];
    g_assert_cmpstr (a->name, ==, b->name);
    g_assert_cmpint (a->seat, ==, b->seat);
    g_assert_true (a->at.x == b->at.x && a->at.y == b->at.y && a->side == b->side);
  }
  for (size_t i = 0; i < again.model.section_count; i++) {
    QnSection a = project.model.sections[i], b = again.model.sections[i];
    g_assert_cmpstr (a.name, ==, b.name);
    a.name = b.name = NULL;
    g_assert_cmpmem (&a, sizeof a, &b, sizeof b);
  }
  for (size_t i = 0; i < again.model.beam_count; i++) {
    QnBeam a = project.model.beams[i], b = again.model.beams[i];
    a.name = b.name = NULL;
    g_assert_cmpmem (&a, sizeof a, &b, sizeof b);
  }
}

/* Without blocks, neither laws nor contacts are needed. */
static void
test_beams_alone (void)
{
  g_auto (QnProject) project, again;
  test_parse (
    "{ \"format\": \"quoin\", \"version\": 1,"
    " \"sections\": [{ \"name\": \"s\", \"young\": 1, \"area\": 1, \"inertia\": 1 }],"
    " \"nodes\": [{ \"name\": \"a\", \"at\": [0, 0], \"support\": [true, true, true] },"
    " { \"name\": \"b\", \"at\": [1, 0] }],"
    " \"beams\": [{ \"name\": \"ab\", \"nodes\": [\"a\", \"b\"], \"section\": \"s\" }] }",
    &project);
  g_autofree char *written = qn_project_to_text (&project, NULL);
  test_parse (written, &again);
  g_assert_cmpuint (again.model.law_count, ==, 0);
  g_assert_cmpuint (again.model.beam_count, ==, 1);
  g_assert_cmpuint (again.warnings->len, ==, 0);
}

static const struct {
  const char *from, *to, *path, *says;
} faults[] = {
  { "\"section\": \"oak\",", "", "beams[0]", "section" },
  { "\"section\": \"oak\"", "\"section\": \"elm\"", "beams[0].section", "no section" },
  { "[\"top\", \"wall\"]", "[\"top\", \"roof\"]", "beams[0].nodes[1]", "no node" },
  { "[\"top\", \"wall\"]", "[\"top\"]", "beams[0].nodes", "two values" },
  { "[\"top\", \"wall\"]", "[\"top\", 3]", "beams[0].nodes[1]", "name of a node" },
  { "[\"top\", \"wall\"]", "[\"top\", \"heart\"]", "beams[0].nodes", "same block" },
  { "\"at\": [4, 2]", "\"at\": [0.5, 2]", "beams[0].nodes", "no length" },
  { "[false, true]", "[false, 1]", "beams[0].hinges[1]", "true or false" },
  { "\"elements\": 3", "\"elements\": 0", "beams[0].elements", "1" },
  { "\"kind\": \"euler-bernoulli\"", "\"kind\": \"euler\"", "beams[1].kind", "euler" },
  { "\"block\": \"stone\", \"side\": \"top\"", "\"block\": \"brick\", \"side\": \"top\"",
    "nodes[0].block", "no block" },
  { "\"side\": \"top\"", "\"side\": \"upper\"", "nodes[0].side", "upper" },
  { "\"block\": \"stone\", \"side\": \"top\"", "\"side\": \"top\"", "nodes[0].side",
    "block" },
  { "\"side\": \"top\"", "\"side\": \"top\", \"at\": [0, 0]", "nodes[0].side",
    "exclude" },
  { "{ \"name\": \"ear\"", "{ \"name\": \"top\", \"at\": [9, 9] }, { \"name\": \"ear\"",
    "nodes[2].name", "twice" },
  { "\"block\": \"stone\" }", "\"block\": \"stone\", \"support\": [true, true, true] }",
    "nodes[1].support", "a node on a block has no support" },
  { "\"at\": [3, 0], ", "", "nodes[4].at", "missing" },
  { "\"young\": 1e10", "\"young\": -1", "sections[0].young", "positive" },
  { "\"poisson\": 0.3", "\"poisson\": 0.7", "sections[0].poisson", "0.5" },
  { "\"poisson\": 0.3", "\"poisson\": 0.3, \"shear_modulus\": 1", "sections[0]",
    "exclude" },
  { "\"height\": 0.2, ", "", "sections[0].height", "missing" },
  { "\"inertia\": 4e-7,", "", "sections[1]", "inertia" },
  { "\"area\": 2e-3", "\"area\": 2e-3, \"height\": 1", "sections[1].area", "exclude" },
  { "\"plastic_moment\": 9e3", "\"yield\": 9e3", "sections[1].yield", "rectangle" },
  { "\"beam\": \"tie\"", "\"beam\": \"rope\"", "loads.dead[1].beam", "no beam" },
  { "\"node\": \"tie.2\"", "\"node\": \"tie.3\"", "loads.live[0].node", "no node" },
  { "\"node\": \"ear\"", "\"node\": \"ear\", \"block\": \"stone\"", "loads.live[1].block",
    "exclude" },
  { "\"node\": \"tie.2\", \"value\": [100, -400], \"moment\": 30",
    "\"node\": \"wall\", \"value\": [100, -400], \"moment\": 30", "loads.live[0].moment",
    "hinged" },
  { "\"control\": { \"node\": \"tie.1\"", "\"control\": { \"node\": \"top\"",
    "analysis.control.node", "controlled node is on a block" },
  { "\"control\": { \"node\": \"tie.1\"", "\"control\": { \"node\": \"wall\"",
    "analysis.control.component", "fixed" },
};

static void
test_faults (void)
{
  for (gsize i = 0; i < G_N_ELEMENTS (faults); i++) {
    QnProject project;
    GError *error = NULL;
    g_autofree char *spoiled = test_replace (text, faults[i].from, faults[i].to);
    g_autofree char *path = g_strconcat (": ", faults[i].path, NULL);
    g_assert_false (
      qn_project_parse (spoiled, strlen (spoiled), "t.quoin", NULL, &project, &error));
    g_test_message ("%s", error->message);
    g_assert_true (strstr (error->message, path) != NULL);
    g_assert_true (strstr (error->message, faults[i].says) != NULL);
    g_clear_error (&error);
  }
}

/* Solves, writes, reads and checks; then spoils one number after another. */
static void
check_result (const char *geometry)
{
  g_autofree char *override = g_strconcat ("analysis.geometry=", geometry, NULL);
  const char *const overrides[] = { override, "analysis.procedure=load",
                                    "analysis.max_multiplier=2", NULL };
  g_auto (QnProject) project;
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;
  g_auto (QnResultFile) file;
  QnResultFaults found;
  GError *error = NULL;
  g_assert_true (
    qn_project_parse (text, strlen (text), "t.quoin", overrides, &project, &error));
  const QnModel *model = &project.model;
  g_assert_cmpint (qn_contacts_detect (model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (model, &contacts, NULL, NULL, &result, NULL), ==,
                   QN_OK);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);

  char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "beams.json", NULL);
  g_assert_true (
    qn_result_file_write (path, &project, &contacts, &result, QN_DETAIL_FORCES, &error));
  g_assert_true (qn_result_file_read (path, &file, &error));
  g_assert_no_error (error);
  g_assert_true (qn_result_file_match (&file, "r", &project, &contacts, NULL, &error));
  g_assert_cmpuint (file.result.node_count, ==, 7);
  g_assert_cmpuint (file.result.element_count, ==, 5);
  size_t numbers = result.step_count * qn_result_body_count (&result) * QN_DOF_COUNT;
  g_assert_cmpmem (file.result.displacements, numbers * sizeof (double),
                   result.displacements, numbers * sizeof (double));
  size_t forces = result.step_count * result.element_count * 6;
  for (size_t i = 0; i < forces; i++)
    g_assert_cmpfloat (((double *) file.result.beam_forces)[i], ==,
                       ((double *) result.beam_forces)[i]);
  g_assert_cmpint (qn_result_find_faults (model, &contacts, &file.result,
                                          QN_CHECK_RECOMPUTED, &found, NULL),
                   ==, QN_OK);
  g_test_message ("%s: out of balance %g", geometry, found.last.out_of_balance);
  g_assert_cmpint (found.count, ==, 0);
  g_assert_cmpfloat (found.last.out_of_balance, <, 1e-8);
  g_assert_cmpfloat (found.last.yield_violation, <, 1e-8);

  QnBeamForces *last =
    file.result.beam_forces + (file.result.step_count - 1) * file.result.element_count;
  for (size_t i = 0; i < model->element_count * sizeof *last / sizeof (double); i++) {
    double *number = (double *) last + i, kept = *number;
    *number += 1;
    g_assert_cmpint (qn_result_find_faults (model, &contacts, &file.result,
                                            QN_CHECK_RECOMPUTED, &found, NULL),
                     ==, QN_OK);
    g_assert_cmpfloat (found.last.out_of_balance, >, 1e-6);
    *number = kept;
  }
  test_scratch_free (folder);
}

static void
test_result (void)
{
  check_result ("linear");
  check_result ("nonlinear");
}

QN_TESTS
{
  g_test_add_func ("/project-beams/read", test_read);
  g_test_add_func ("/project-beams/round-trip", test_round_trip);
  g_test_add_func ("/project-beams/beams-alone", test_beams_alone);
  g_test_add_func ("/project-beams/faults", test_faults);
  g_test_add_func ("/project-beams/result", test_result);
}
