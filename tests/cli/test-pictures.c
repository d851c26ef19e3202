/* Every view of every kind of result, coloured by every field, with every decoration: drawn where
 * the result has what the picture needs, refused in one line where it has not. */
#include "cli-run.h"
#include "support/room.h"

#include <string.h>

typedef enum {
  HAS_NOTHING = 0,
  HAS_STEPS = 1,
  HAS_FORCES = 2, /* between blocks, of the last step */
  HAS_MECHANISM = 4,
  HAS_BEAMS = 8, /* and their section forces */
} Has;

/* A result, and how it is made; without a subcommand there is none. */
typedef struct Kind {
  const char *name, *example, *subcommand, *setting;
  Has has;
} Kind;

static const Kind kinds[] = {
  { "collapse", "06-arch.quoin", "solve", NULL, HAS_STEPS | HAS_FORCES | HAS_MECHANISM },
  { "target-reached", "06-arch.quoin", "solve", "analysis.max_multiplier=0.01",
    HAS_STEPS | HAS_FORCES },
  { "nonlinear", "06-arch.quoin", "solve", "analysis.geometry=nonlinear",
    HAS_STEPS | HAS_FORCES | HAS_MECHANISM },
  { "stages", "16-load-stages.quoin", "solve", NULL,
    HAS_STEPS | HAS_FORCES | HAS_MECHANISM },
  { "limit", "06-arch.quoin", "limit", NULL, HAS_STEPS | HAS_FORCES | HAS_MECHANISM },
  { "limit-interval", "06-arch.quoin", "limit", "analysis.flow=non-associative",
    HAS_STEPS | HAS_FORCES | HAS_MECHANISM },
  { "modes", "06-arch.quoin", "modal", NULL, HAS_STEPS | HAS_FORCES | HAS_MECHANISM },
  { "modes-of-beams", "37-beam-vibrating.quoin", "modal", NULL,
    HAS_STEPS | HAS_MECHANISM | HAS_BEAMS },
  { "buckling", "22-column-clamped.quoin", "stability", NULL,
    HAS_STEPS | HAS_FORCES | HAS_MECHANISM },
  { "in-time", "41-column-impulse.quoin", "solve", "analysis.dynamic.duration=1",
    HAS_STEPS | HAS_FORCES },
  { "overturned", "41-column-impulse.quoin", "solve",
    "analysis.dynamic.ground[0].pulse.amplitude=2",
    HAS_STEPS | HAS_FORCES | HAS_MECHANISM },
  { "beams", "30-beam-cantilever.quoin", "solve", NULL, HAS_STEPS | HAS_BEAMS },
  /* Contacts that follow their blocks; then none, for nothing stands or nothing falls. */
  { "found", "29-block-over-an-edge.quoin", "solve", NULL,
    HAS_STEPS | HAS_FORCES | HAS_MECHANISM },
  { "unstable", "04-block-on-slope.quoin", "solve", "laws[0].friction=0.1",
    HAS_MECHANISM },
  { "unbounded", "01-sliding-block.quoin", "solve", "loads.live[0].direction=[0,-1]",
    HAS_STEPS | HAS_FORCES },
  { "unbounded-limit", "01-sliding-block.quoin", "limit",
    "loads.live[0].direction=[0,-1]", HAS_NOTHING },
  { "blocks-and-beams", "36-mast-on-block.quoin", "solve", NULL,
    HAS_STEPS | HAS_FORCES | HAS_MECHANISM | HAS_BEAMS },
};

static const char *const views[] = { "model",     "contacts", "deformed",
                                     "mechanism", "forces",   "diagrams" };
static const char *const fields[] = {
  "none",    "displacement", "displacement-x", "displacement-y", "rotation",
  "stress",  "stress-x",     "stress-y",       "stress-xy",      "principal",
  "opening", "sliding",      "crack",          "bodies",
};
/* None, each alone, all; test_known() holds them to the program's own list, as the others. */
#define ALL_DECORATIONS                                                                  \
  "ghost,symbols,loads,dimensions,names,values,legend,titles,monochrome"
static const char *const decorations[] = {
  "",       "ghost",  "symbols", "loads",      "dimensions",    "names",
  "values", "legend", "titles",  "monochrome", ALL_DECORATIONS,
};

static const char *const diagrams[] = { "M", "V", "N" };

/* What a picture is drawn of. */
static Has
needs (const char *view, const char *field)
{
  gboolean coloured = !g_str_equal (field, "none");
  gboolean mechanism = g_str_equal (view, "mechanism");
  Has needed = HAS_NOTHING;
  if (mechanism)
    needed |= HAS_MECHANISM;
  else if (coloured || !(g_str_equal (view, "model") || g_str_equal (view, "contacts")))
    needed |= HAS_STEPS;
  if (g_str_equal (field, "bodies"))
    needed |= HAS_MECHANISM;
  if (g_str_equal (view, "forces") || g_str_has_prefix (field, "stress")
      || g_str_equal (field, "principal") || g_str_equal (field, "crack"))
    needed |= HAS_FORCES;
  if (g_str_equal (view, "diagrams"))
    needed |= HAS_BEAMS;
  return needed;
}

/* The words that an option takes are told where another is given: the table has all of them. */
static char *
dup_known (const char *option)
{
  g_autofree char *model = cli_example ("06-arch.quoin");
  CliRun run = cli_run ("render", model, option, "nonsense", "-o", "never.svg", NULL);
  const char *known = strstr (run.err, "is not one of ");
  g_assert_nonnull (known);
  char *names = g_strndup (known + strlen ("is not one of "),
                           strcspn (known + strlen ("is not one of "), "(\n") - 1);
  cli_assert_failed (&run, 2, "nonsense");
  return names;
}

static void
test_known (void)
{
  const struct {
    const char *option, *const *names;
    size_t count;
  } lists[] = {
    { "--view", views, G_N_ELEMENTS (views) },
    { "--field", fields, G_N_ELEMENTS (fields) },
    { "--show", decorations + 1, G_N_ELEMENTS (decorations) - 2 },
    { "--diagram", diagrams, G_N_ELEMENTS (diagrams) },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (lists); i++) {
    g_autofree char *known = dup_known (lists[i].option);
    g_autoptr (GString) ours = g_string_new (NULL);
    for (size_t k = 0; k < lists[i].count; k++)
      g_string_append_printf (ours, "%s%s", k > 0 ? ", " : "", lists[i].names[k]);
    g_assert_cmpstr (known, ==, ours->str);
  }
}

/* The decorations that are not in a list of them. */
static char *
dup_others (const char *shown)
{
  g_auto (GStrv) all = g_strsplit (ALL_DECORATIONS, ",", -1);
  g_auto (GStrv) on = g_strsplit (shown, ",", -1);
  g_autoptr (GStrvBuilder) others = g_strv_builder_new ();
  for (char **name = all; *name != NULL; name++)
    if (!g_strv_contains ((const char *const *) on, *name))
      g_strv_builder_add (others, *name);
  g_auto (GStrv) names = g_strv_builder_end (others);
  return g_strjoinv (",", names);
}

/* Draws one picture; whether it was drawn. */
static gboolean
draw (const char *model, const char *result, const char *view, const char *field,
      const char *shown, const char *picture)
{
  g_autofree char *hidden = dup_others (shown);
  const char *arguments[18] = { "render", model,    "--view",  view, "--field",
                                field,    "--size", "200x150", "-o", picture };
  size_t count = 10;
  const char *const given[][2] = { { "--result", result },
                                   { "--show", shown },
                                   { "--hide", hidden } };
  for (size_t i = 0; i < G_N_ELEMENTS (given); i++)
    if (given[i][1] != NULL && *given[i][1] != '\0') {
      arguments[count++] = given[i][0];
      arguments[count++] = given[i][1];
    }
  CliRun run = cli_run_with (arguments, NULL, NULL);
  if (run.code != 0) {
    cli_assert_failed (&run, run.code == 3 ? 3 : 2, NULL);
    return FALSE;
  }
  cli_assert_done (&run);
  cli_run_clear (&run);
  g_autofree char *text = cli_read (picture);
  g_assert_nonnull (strstr (text, "</svg>"));
  g_assert_null (strstr (text, "<symbol")); /* letters that are no text */
  return TRUE;
}

static char *
solve (const Kind *kind, const char *model, const char *folder)
{
  if (kind->subcommand == NULL)
    return NULL;
  char *path = g_build_filename (folder, "result.json", NULL);
  g_auto (CliRun) run =
    kind->setting != NULL
      ? cli_run (kind->subcommand, model, "-q", "--set", kind->setting, "-o", path, NULL)
      : cli_run (kind->subcommand, model, "-q", "-o", path, NULL);
  if (g_str_equal (kind->name, "unstable"))
    g_assert_cmpint (run.code, ==, 4); /* no answer, and yet a result */
  else
    cli_assert_done (&run);
  return path;
}

/* First, middle and last step, automatic and true scale and a factor, every section force. */
static void
draw_steps (const Kind *kind, const char *model, const char *result, const char *picture)
{
  static const char *const steps[] = { "0", "1", "last" };
  static const char *const scales[] = { "auto", "true", "25" };
  for (size_t v = 0; v < G_N_ELEMENTS (views); v++)
    for (size_t s = 0; s < G_N_ELEMENTS (steps); s++)
      for (size_t k = 0; k < G_N_ELEMENTS (scales); k++) {
        if ((needs (views[v], "none") & ~kind->has) != 0 || needs (views[v], "none") == 0)
          continue;
        CliRun run = cli_run ("render", model, "--result", result, "--view", views[v],
                              "--step", steps[s], "--scale", scales[k], "--diagram",
                              diagrams[(s + k) % 3], "-o", picture, NULL);
        if (run.code == 0)
          cli_assert_done (&run), cli_run_clear (&run);
        else /* a result of one step has no step 1 */
          cli_assert_failed (&run, 2, "step");
      }
}

static void
test_kind (gconstpointer data)
{
  const Kind *kind = data;
  g_autofree char *folder = test_scratch_new ();
  g_autofree char *model = cli_example (kind->example);
  g_autofree char *result = solve (kind, model, folder);
  g_autofree char *picture = g_build_filename (folder, "picture.svg", NULL);
  for (size_t v = 0; v < G_N_ELEMENTS (views); v++)
    for (size_t f = 0; f < G_N_ELEMENTS (fields); f++)
      for (size_t d = 0; d < G_N_ELEMENTS (decorations); d++) {
        Has needed = needs (views[v], fields[f]);
        gboolean possible = (needed & ~kind->has) == 0;
        /* What is refused is refused before decorations matter: none, and all of them. Of those
         * between, every third is drawn, another one with every view, field and kind. */
        gboolean between = d > 0 && d + 1 < G_N_ELEMENTS (decorations);
        if (between && (!possible || (d + v + f + (size_t) (kind - kinds)) % 3 != 0))
          continue;
        gboolean drawn =
          draw (model, result, views[v], fields[f], decorations[d], picture);
        if (drawn != possible)
          g_test_fail_printf ("%s: view %s, field %s, showing \"%s\" was %s", kind->name,
                              views[v], fields[f], decorations[d],
                              drawn ? "drawn" : "refused");
      }
  if (result != NULL)
    draw_steps (kind, model, result, picture);
  test_scratch_free (g_steal_pointer (&folder));
}

QN_TESTS
{
  g_test_add_func ("/cli/pictures/known", test_known);
  for (size_t i = 0; i < G_N_ELEMENTS (kinds); i++) {
    g_autofree char *path = g_strconcat ("/cli/pictures/", kinds[i].name, NULL);
    g_test_add_data_func (path, &kinds[i], test_kind);
  }
}
