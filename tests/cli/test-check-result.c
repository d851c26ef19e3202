/* quoin-cli check --result: every result of the program passes, and none of these changed ones. */
#include "cli-run.h"
#include "support/room.h"

#include <cJSON.h>
#include <string.h>

/* A result: what it is of, and how it is computed. */
typedef enum {
  SLIDING,
  ARCH,
  WALL,
  SOFT_WALL,
  STAGES,
  SETTLING,
  FRAME,
  ROCKING,
  PULSE,
  PIER,
  MODE,
  LOADED_MODE,
  BUCKLING,
  LIMIT,
  FIXED_POINTS,
  RESULT_COUNT
} Source;

static const struct {
  const char *example, *command, *set, *option;
} sources[RESULT_COUNT] = {
  [SLIDING] = { "01-sliding-block.quoin", "solve", NULL, NULL },
  [ARCH] = { "06-arch.quoin", "solve", NULL, NULL },
  [WALL] = { "ferris-tin-loi/wall3.quoin", "solve", NULL, NULL },
  [SOFT_WALL] = { "ferris-tin-loi/wall3.quoin", "solve",
                  "analysis.geometry=\"nonlinear\"", "--set=laws[0].kn=1e6" },
  [STAGES] = { "16-load-stages.quoin", "solve", NULL, NULL },
  [SETTLING] = { "18-spreading-arch.quoin", "solve", NULL, NULL },
  [FRAME] = { "32-frame-beams.quoin", "solve", NULL, NULL },
  [ROCKING] = { "40-rocking-in-time.quoin", "solve", NULL, NULL },
  [PULSE] = { "42-arch-pulse.quoin", "solve", "analysis.dynamic.duration=0.4", NULL },
  [PIER] = { "15-rubble-pier.quoin", "solve", NULL, NULL },
  [MODE] = { "11-vibrating-beam.quoin", "modal", NULL, "--mode=3" },
  [LOADED_MODE] = { "11-vibrating-beam.quoin", "modal", NULL, "--loaded" },
  [BUCKLING] = { "21-column-pinned.quoin", "stability", NULL, NULL },
  [FIXED_POINTS] = { "ferris-tin-loi/wall4.quoin", "limit",
                     "analysis.flow=\"non-associative\"", NULL },
  [LIMIT] = { "ferris-tin-loi/wall1.quoin", "limit", NULL, NULL },
};

typedef enum { ADD, TIMES, TEXT } Change;

/* A false statement: a number or a text of the result changed, and what the message must name. Indices
 * of lists may be negative: from the end. */
typedef struct {
  const char *name;
  Source source;
  const char *path;
  Change change;
  double number;
  const char *text, *message;
} Forgery;

static const Forgery forgeries[] = {
  { "hash", SLIDING, "model_sha256", TEXT, 0, "0123", "computed from another project" },
  { "block moved", SLIDING, "steps/2/displacements/1/0", ADD, 1e-5, NULL, "step 2" },
  { "block lifted", SLIDING, "steps/1/displacements/1/1", ADD, 1e-5, NULL,
    "the force is not the one" },
  { "block turned", ARCH, "steps/3/displacements/8/2", ADD, 1e-6, NULL, "step 3" },
  { "support moved", ARCH, "steps/4/displacements/0/0", ADD, 1e-3, NULL, "a support" },
  { "all moved twice as far", SLIDING, "steps/3/displacements/1/0", TIMES, 2, NULL,
    "the force is not the one" },
  { "force of the last step", ARCH, "contacts/5/normal_force", ADD, -20, NULL,
    "the force is not the one" },
  { "force of another step", ARCH, "steps/4/forces/10", TIMES, 1.01, NULL, "step 4" },
  { "shear of another step", WALL, "steps/-3/forces/33", ADD, 40, NULL, "step" },
  { "shear near collapse", WALL, "steps/-2/forces/33", ADD, 40, NULL, "step" },
  { "state of the last step", ARCH, "contacts/6/state", TEXT, 0, "open", "the state" },
  { "state of another step", WALL, "steps/5/states", TEXT, 0, NULL, "the state" },
  { "multiplier of a step", SLIDING, "steps/3/multiplier", ADD, 0.01, NULL,
    "out of balance" },
  { "multiplier of a wall's step", WALL, "steps/-2/multiplier", TIMES, 1.001, NULL,
    "out of balance" },
  { "first step under load", SLIDING, "steps/0/multiplier", ADD, 0.1, NULL, "step 0" },
  { "residual", ARCH, "steps/3/residual", ADD, 0.1, NULL, "step 3" },
  { "collapse multiplier", SLIDING, "collapse_multiplier", TIMES, 1.05, NULL,
    "collapse multiplier" },
  { "collapse too low", WALL, "collapse_multiplier", TIMES, 0.9, NULL,
    "collapse multiplier" },
  { "first limit point", WALL, "first_limit_multiplier", ADD, 0.5, NULL, "first limit" },
  { "outcome", SLIDING, "outcome", TEXT, 0, "target-reached", "outcome" },
  { "outcome of settlement", SETTLING, "outcome", TEXT, 0, "collapse", "outcome" },
  { "event", ARCH, "steps/5/event", TEXT, 0, "collapse", "outcome" },
  { "kind of an event", PIER, "events/0/kind", TEXT, 0, "local", "first limit" },
  { "snap at another step", PIER, "events/0/multiplier", TIMES, 1.01, NULL,
    "first limit" },
  { "first snap", PIER, "first_limit_multiplier", TIMES, 1.001, NULL, "first limit" },
  { "frequency", MODE, "vibration/omega", TIMES, 1.001, NULL, "the mode is not one" },
  { "number of a mode", MODE, "vibration/mode", ADD, 1, NULL, "the mode is not one" },
  { "shape of a mode", MODE, "mechanism/20/1", TIMES, 1.01, NULL, "the mode is not one" },
  { "state of a mode", MODE, "steps/0/displacements/20/1", ADD, 1e-6, NULL, "step 0" },
  { "frequency under load", LOADED_MODE, "vibration/omega", TIMES, 0.999, NULL,
    "the mode is not one" },
  { "critical multiplier", BUCKLING, "first_limit_multiplier", TIMES, 1.01, NULL,
    "first limit" },
  { "buckling mode", BUCKLING, "mechanism/9/0", ADD, 0.5, NULL, "the mode is not one" },
  { "stability", BUCKLING, "stability", TEXT, 0, "kept", "outcome" },
  { "mechanism overlaps", SLIDING, "mechanism/1/1", ADD, -0.5, NULL,
    "move into each other" },
  { "mechanism lifts", SLIDING, "mechanism/1/1", ADD, 0.5, NULL, "cannot yield" },
  { "mechanism backwards", SLIDING, "mechanism/1/0", TIMES, -1, NULL, "work" },
  { "mechanism of an arch", ARCH, "mechanism/9/2", ADD, 0.3, NULL, "mechanism" },
  { "mechanism of a wall", WALL, "mechanism/20/0", ADD, 0.3, NULL, "mechanism" },
  { "mechanism by work", SOFT_WALL, "mechanism/20/0", ADD, 0.3, NULL, "work" },
  { "mechanism by work backwards", SOFT_WALL, "mechanism/40/0", TIMES, -1, NULL, "work" },
  { "support in a mechanism by work", SOFT_WALL, "mechanism/0/0", ADD, 0.3, NULL,
    "cannot yield" },
  { "support in the mechanism", ARCH, "mechanism/0/0", ADD, 0.3, NULL, "cannot yield" },
  { "reaction", SLIDING, "steps/-1/reactions/0/0", ADD, 50, NULL, "reaction" },
  { "reaction of a settling support", SETTLING, "steps/6/reactions/0/1", TIMES, 1.01,
    NULL, "reaction" },
  { "settlement", SETTLING, "steps/8/displacements/1/0", ADD, 1e-3, NULL, "step 8" },
  { "stage of a step", STAGES, "steps/-1/stage", ADD, -1, NULL, "step" },
  { "load of an early stage", STAGES, "steps/2/multiplier", TIMES, 1.01, NULL,
    "out of balance" },
  { "moment of a beam", FRAME, "steps/5/beam_forces/1/2", ADD, 100, NULL,
    "section force" },
  { "node moved", FRAME, "steps/5/node_displacements/1/0", ADD, 1e-4, NULL,
    "section force" },
  { "node turned at collapse", FRAME, "steps/-1/node_displacements/2/2", ADD, 1e-4, NULL,
    "section force" },
  { "time", ROCKING, "steps/5/time", ADD, -1, NULL, "step 5" },
  { "block moved in time", ROCKING, "steps/40/displacements/1/1", ADD, 1e-6, NULL,
    "step 40" },
  { "energy", ROCKING, "history/energy/kinetic/30", ADD, 50, NULL, "history" },
  { "peak", ROCKING, "history/peak/1", TIMES, 0.5, NULL, "history" },
  { "velocity", ROCKING, "steps/30/velocities/1/0", ADD, 1e-3, NULL, "history" },
  { "speed of turning", ROCKING, "steps/40/velocities/1/2", TIMES, 1.001, NULL,
    "history" },
  { "last velocity", ROCKING, "steps/-1/velocities/1/1", ADD, 1e-2, NULL, "history" },
  { "velocity at the start", ROCKING, "steps/1/velocities/1/2", ADD, 0.1, NULL,
    "history" },
  { "input", ROCKING, "history/energy/input/30", TIMES, 1.01, NULL, "history" },
  { "elastic energy", ROCKING, "history/energy/elastic/20", ADD, 10, NULL, "history" },
  { "friction", ROCKING, "history/energy/friction/-1", ADD, 10, NULL, "history" },
  { "damped energy", ROCKING, "history/energy/damping/40", ADD, 10, NULL, "history" },
  { "numerical energy", ROCKING, "history/energy/numerical/40", ADD, 10, NULL,
    "history" },
  { "end in time", ROCKING, "history/end", ADD, 0.1, NULL, "history" },
  { "negative error of energy", ROCKING, "history/energy_error", TIMES, -1, NULL,
    "history" },
  { "time of a row", ROCKING, "history/time/20", ADD, -1, NULL, "history" },
  { "track", ROCKING, "history/tracks/0/values/50", ADD, 0.01, NULL, "history" },
  { "velocity of a voussoir", PULSE, "steps/10/velocities/10/0", ADD, 1e-2, NULL,
    "history" },
  { "velocity of a support", PULSE, "steps/10/velocities/0/2", ADD, 1e-1, NULL,
    "history" },
  { "kinetic energy under a pulse", PULSE, "history/energy/kinetic/100", TIMES, 1.01,
    NULL, "history" },
  { "elastic energy under a pulse", PULSE, "history/energy/elastic/100", ADD, 50, NULL,
    "history" },
  { "peak of a voussoir", PULSE, "history/peak/10", TIMES, 0.9, NULL, "history" },
  { "voussoir moved in time", PULSE, "steps/10/displacements/9/0", ADD, 1e-5, NULL,
    "step 10" },
  { "voussoir turned in time", PULSE, "steps/10/displacements/9/2", ADD, 1e-5, NULL,
    "step 10" },
  { "support moved in time", PULSE, "steps/10/displacements/0/1", ADD, 1e-5, NULL,
    "a support" },
  { "force in motion", PULSE, "steps/10/forces/21", TIMES, 1.05, NULL, "step 10" },
  { "last force in motion", PULSE, "contacts/21/normal_force", TIMES, 1.05, NULL,
    "the force" },
  { "reaction in motion", PULSE, "steps/10/reactions/0/1", TIMES, 1.05, NULL,
    "reaction" },
  { "residual in motion", PULSE, "steps/10/residual", ADD, 0.1, NULL, "step 10" },
  { "time of a step", PULSE, "steps/10/time", ADD, 0.5, NULL, "step" },
  { "multiplier in motion", PULSE, "steps/10/multiplier", ADD, 0.1, NULL, "step 10" },
  { "rest that is none", PULSE, "outcome", TEXT, 0, "rest", "outcome" },
  { "collapse in motion", PULSE, "outcome", TEXT, 0, "collapse", "outcome" },
  { "lower bound", LIMIT, "lower_bound", TIMES, 1.02, NULL, "lower bound" },
  { "upper bound", LIMIT, "upper_bound", TIMES, 1.02, NULL, "upper bound" },
  { "upper bound too low", LIMIT, "upper_bound", TIMES, 0.98, NULL, "upper bound" },
  { "forces of limit analysis", LIMIT, "contacts/20/normal_force", TIMES, 1.02, NULL,
    "out of balance" },
  { "mechanism of limit analysis", LIMIT, "mechanism/12/0", ADD, 0.2, NULL, "mechanism" },
  { "greatest fixed point", FIXED_POINTS, "upper_bound", TIMES, 1.05, NULL, "interval" },
  { "associative bound", FIXED_POINTS, "associative_bound", TIMES, 1.05, NULL,
    "upper bound" },
  { "least of a path", WALL, "collapse_interval/0", TIMES, 0.9, NULL,
    "collapse_interval[0]: this contradicts" },
  { "solutions of rigid blocks", FIXED_POINTS, "fixed_points/0", TIMES, 0.9, NULL,
    "fixed_points[0]: this contradicts" },
  { "bound of a path", WALL, "collapse_interval/1", TIMES, 1.05, NULL, "upper bound" },
  { "solution of a path", WALL, "solutions/0/displacement", TIMES, 1.01, NULL,
    "interval" },
  { "another way to a solution", WALL, "solutions/0/found_by", TEXT, 0, "limit",
    "interval" },
  { "load control beyond the peak", PIER, "solutions/0/found_by", TEXT, 0, "load",
    "interval" },
  { "end of the interval", WALL, "collapse_interval_ends/0", TEXT, 0, "limit",
    "collapse_interval_ends[0]: this contradicts" },
  { "solution of rigid blocks", LIMIT, "solutions/0/found_by", TEXT, 0, "work",
    "interval" },
  { "kind of mechanism", ARCH, "mechanism_facts/kind", TEXT, 0, "sliding",
    "mechanism_facts.kind: this contradicts" },
  { "hinge", ARCH, "mechanism_facts/joints/0/hinge/0", ADD, 0.1, NULL,
    "mechanism_facts.joints[0].hinge[0]: this contradicts" },
  { "rotation of a body", WALL, "mechanism_facts/bodies/0/rotation", ADD, 0.01, NULL,
    "mechanism_facts.bodies[0].rotation: this contradicts" },
  { "name of a stage", STAGES, "stages/0", TEXT, 0, "other",
    "stages[0]: this contradicts" },
  { "stage of the end", STAGES, "stage", ADD, -1, NULL, "" },
  { "element of a beam", FRAME, "elements/0/2", ADD, 1, NULL,
    "elements[0][2]: this contradicts" },
  { "name of a beam", FRAME, "beams/0", TEXT, 0, "other", "beams[0]: this contradicts" },
  { "tracked block", ROCKING, "history/tracks/0/block", TEXT, 0, "other",
    "history.tracks[0].block: this contradicts" },
  { "time that ran back", SLIDING, "timings/seconds", TIMES, -1, NULL,
    "timings.seconds" },
  { "negative residual", ARCH, "steps/3/residual", ADD, -1, NULL, "step 3" },
  { "row between two times", ROCKING, "history/time/21", ADD, 1e-3, NULL, "history" },
  { "time of a kept step", ROCKING, "steps/20/time", ADD, 1e-3, NULL, "history" },
  { "linear geometry", WALL, "beyond_linear_multiplier", TIMES, 0.9, NULL,
    "linear geometry" },
  { "place of a contact", ARCH, "contacts/3/point/0", ADD, 0.01, NULL, "contacts[3]" },
  { "direction of a contact", ARCH, "contacts/3/normal/0", ADD, 0.01, NULL,
    "contacts[3]" },
};

static char *folder;
static char *results[RESULT_COUNT]; /* their texts */

static char *
solve (Source source)
{
  g_autofree char *model = cli_example (sources[source].example);
  g_autofree char *path = g_build_filename (folder, "result.json", NULL);
  const char *set = sources[source].set, *option = sources[source].option;
  CliRun run = cli_run (sources[source].command, model, "-q", "-o", path,
                        set != NULL      ? "--set"
                        : option != NULL ? option
                                         : NULL,
                        set, option, NULL);
  cli_expect_done (run);
  run = cli_run ("check", model, "--result", path, NULL);
  g_test_message ("%s%s", sources[source].example, run.err);
  cli_assert_done (&run);
  g_assert_nonnull (strstr (run.out, "passes"));
  cli_run_clear (&run);
  return cli_read (path);
}

static cJSON *
find (cJSON *root, const char *path)
{
  g_auto (GStrv) keys = g_strsplit (path, "/", -1);
  cJSON *at = root;
  for (int i = 0; keys[i] != NULL; i++) {
    int index = (int) g_ascii_strtoll (keys[i], NULL, 10);
    at = !cJSON_IsArray (at)
           ? cJSON_GetObjectItem (at, keys[i])
           : cJSON_GetArrayItem (at, index < 0 ? cJSON_GetArraySize (at) + index : index);
    g_assert_nonnull (at);
  }
  return at;
}

/* Open where it stuck, and the other way about, by letters. */
static void
turn_states (char *states)
{
  for (char *at = states; *at != '\0'; at++)
    *at = *at == 'k' ? 'o' : 'k';
}

static char *
dup_forged (const Forgery *forgery)
{
  cJSON *root = cJSON_Parse (results[forgery->source]);
  cJSON *item = find (root, forgery->path);
  if (forgery->change == ADD && cJSON_IsNull (item)) {
    item->type = cJSON_Number;
    cJSON_SetNumberValue (item, forgery->number);
  } else if (forgery->change == ADD)
    cJSON_SetNumberValue (item, item->valuedouble + forgery->number);
  else if (forgery->change == TIMES)
    cJSON_SetNumberValue (item, item->valuedouble * forgery->number);
  else if (forgery->text == NULL)
    turn_states (item->valuestring);
  else if (cJSON_IsNull (item)) {
    item->type = cJSON_String;
    item->valuestring = strdup (forgery->text);
  } else
    cJSON_SetValuestring (item, forgery->text);
  char *text = cJSON_PrintUnformatted (root);
  cJSON_Delete (root);
  return text;
}

static void
test_forgery (gconstpointer data)
{
  const Forgery *forgery = data;
  g_autofree char *model = cli_example (sources[forgery->source].example);
  if (results[forgery->source] == NULL)
    results[forgery->source] = solve (forgery->source);
  char *forged = dup_forged (forgery);
  g_autofree char *path = cli_write (folder, "forged.json", forged);
  CliRun run = cli_run ("check", model, "--result", path, NULL);
  g_test_message ("%s", run.err);
  cli_assert_failed (&run, 3, forgery->message);
  free (forged);
}

/* A project with another friction, whatever else it has in common. */
static void
test_other_project (void)
{
  g_autofree char *model = cli_example (sources[SLIDING].example);
  g_autofree char *text = cli_read (model);
  g_autofree char *rough = cli_replace (text, "\"friction\": 0.4", "\"friction\": 0.5");
  g_autofree char *other = cli_write (folder, "rough.quoin", rough);
  g_autofree char *path = g_build_filename (folder, "result.json", NULL);
  cli_do ("solve", model, "-q", "-o", path, NULL);
  cli_fails (3, "computed from another project than", "check", other, "--result", path,
             NULL);
}

/* What is false is told in a form that programs read, too. */
static void
test_json (void)
{
  g_autofree char *model = cli_example (sources[SLIDING].example);
  g_autofree char *path = g_build_filename (folder, "result.json", NULL);
  cli_do ("solve", model, "-q", "-o", path, NULL);
  g_autofree char *text = cli_read (path);
  g_autofree char *forged =
    cli_replace (text, "\"collapse_multiplier\": ", "\"collapse_multiplier\": 1");
  g_autofree char *wrong = cli_write (folder, "wrong.json", forged);
  CliRun run = cli_run ("check", model, "--json", "--result", wrong, NULL);
  g_assert_cmpint (run.code, ==, 3);
  g_assert_nonnull (strstr (run.out, "\"passes\": false"));
  g_assert_nonnull (strstr (run.out, "\"claim\": \"collapse-multiplier\""));
  cli_run_clear (&run);
}

/* What falls under its dead load, and what carries any load, have no equilibrium, and are checked too. */
static void
check_without_steps (const char *command, const char *example, const char *set, int code,
                     const char *from, const char *to)
{
  g_autofree char *model = cli_example (example);
  g_autofree char *path = g_build_filename (folder, "none.json", NULL);
  CliRun run = cli_run (command, model, "-q", "-o", path, "--set", set, NULL);
  g_assert_cmpint (run.code, ==, code);
  cli_run_clear (&run);
  run = cli_run ("check", model, "--result", path, NULL);
  cli_assert_done (&run);
  g_assert_nonnull (strstr (run.out, "passes"));
  cli_run_clear (&run);
  g_autofree char *text = cli_read (path);
  g_autofree char *forged = cli_replace (text, from, to);
  g_autofree char *wrong = cli_write (folder, "wrong.json", forged);
  run = cli_run ("check", model, "--result", wrong, NULL);
  cli_assert_failed (&run, 3, "outcome");
}

static void
test_without_steps (void)
{
  const char *slope = "04-block-on-slope.quoin", *smooth = "laws[0].friction=0.1";
  const char *down = "loads.live=[{\"kind\":\"weight\",\"direction\":[0,-1]}]";
  check_without_steps ("solve", slope, smooth, 4, "\"unstable_blocks\": [1]",
                       "\"unstable_blocks\": [0]");
  check_without_steps ("limit", slope, smooth, 4, "\"collapse_multiplier\": null",
                       "\"collapse_multiplier\": 0.3");
  check_without_steps ("limit", "01-sliding-block.quoin", down, 0,
                       "\"outcome\": \"unbounded\"",
                       "\"outcome\": \"dead-load-unstable\", \"unstable_blocks\": [1]");
}

/* A block on elastic joints that is drawn away by 300 m: forces in eight digits have long arms. */
static void
test_drawn_far (void)
{
  const char *elastic = "laws=[{\"name\":\"dry joint\",\"kind\":\"elastic\","
                        "\"basis\":\"contact\",\"kn\":1e6,\"ks\":1e6}]";
  g_autofree char *model = cli_example (sources[SLIDING].example);
  g_autofree char *path = g_build_filename (folder, "far.json", NULL);
  CliRun run =
    cli_run ("solve", model, "-q", "-o", path, "--set", elastic, "--set",
             "blocks[1].vertices=[[0,0],[0.3,0],[0.3,3],[0,3]]", "--set",
             "analysis.geometry=nonlinear", "--set", "analysis.max_multiplier=1e8",
             "--set", "analysis.max_factorizations=14000", NULL);
  g_assert_cmpint (run.code, ==, 4);
  cli_run_clear (&run);
  run = cli_run ("check", model, "--result", path, NULL);
  cli_assert_done (&run);
  cli_run_clear (&run);
}

/* What nothing proves is told. */
static void
test_unproved (void)
{
  g_autofree char *model = cli_example (sources[SLIDING].example);
  g_autofree char *path = g_build_filename (folder, "result.json", NULL);
  CliRun run = cli_run ("solve", model, "-q", "-o", path, NULL);
  cli_assert_done (&run);
  cli_run_clear (&run);
  g_autofree char *text = cli_read (path);
  g_autofree char *more = cli_replace (text, "\"outcome\":", "\"mood\": 1, \"outcome\":");
  g_autofree char *other = cli_write (folder, "more.json", more);
  run = cli_run ("check", model, "--result", other, NULL);
  cli_assert_done (&run);
  g_assert_nonnull (strstr (run.out, "not proved by the file: generator, model,"));
  g_assert_nonnull (strstr (run.out, "mood"));
  cli_run_clear (&run);
  run = cli_run ("check", model, "--json", "--result", other, NULL);
  cli_assert_done (&run);
  g_assert_nonnull (strstr (run.out, "\"not_proved\": [\"generator\", \"model\""));
  cli_run_clear (&run);
}

/* Forces of joints that were not kept say nothing of the beams, which are checked all the same. */
static void
test_beams_without_forces (void)
{
  g_autofree char *model = cli_example ("34-frame-hybrid.quoin");
  g_autofree char *path = g_build_filename (folder, "hybrid.json", NULL);
  CliRun run = cli_run ("solve", model, "-q", "-o", path, NULL);
  cli_assert_done (&run);
  cli_run_clear (&run);
  g_autofree char *text = cli_read (path);
  cJSON *root = cJSON_Parse (text), *step;
  int count = 0;
  cJSON_ArrayForEach (step, cJSON_GetObjectItem (root, "steps"))
  {
    cJSON_DeleteItemFromObject (step, "forces");
    cJSON_DeleteItemFromObject (step, "states");
    if (count++ == 2)
      cJSON_AddTrueToObject (step, "relaxed");
  }
  cJSON *moment = find (root, "steps/3/beam_forces/1/2");
  cJSON_SetNumberValue (moment, 1.01 * moment->valuedouble + 1000);
  char *forged = cJSON_PrintUnformatted (root);
  g_autofree char *wrong = cli_write (folder, "wrong.json", forged);
  run = cli_run ("check", model, "--result", wrong, NULL);
  cli_assert_failed (&run, 3, "step 3: beam");
  free (forged);
  cJSON_Delete (root);
}

static void
forget (void)
{
  for (int i = 0; i < RESULT_COUNT; i++)
    g_free (results[i]);
  test_scratch_free (folder);
}

QN_TESTS
{
  folder = test_scratch_new ();
  atexit (forget);
  for (gsize i = 0; i < G_N_ELEMENTS (forgeries); i++) {
    g_autofree char *path = g_strdup_printf ("/cli/check-result/%s", forgeries[i].name);
    g_test_add_data_func (path, &forgeries[i], test_forgery);
  }
  g_test_add_func ("/cli/check-result/other project", test_other_project);
  g_test_add_func ("/cli/check-result/json", test_json);
  g_test_add_func ("/cli/check-result/without steps", test_without_steps);
  g_test_add_func ("/cli/check-result/drawn far", test_drawn_far);
  g_test_add_func ("/cli/check-result/unproved", test_unproved);
  g_test_add_func ("/cli/check-result/beams without forces", test_beams_without_forces);
}
