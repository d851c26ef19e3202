#include "io/exchange/import-work.h"
#include "io/text/io-error.h"
#include "support/room.h"

static void
assert_role (char **layers, const char *name, QnRole role, gboolean doubtful)
{
  QnImportSettings settings = QN_IMPORT_DEFAULTS;
  gboolean doubt;
  settings.layers = layers;
  g_test_message ("%s", name);
  g_assert_cmpint (qn_import_propose_role (&settings, name, &doubt), ==, role);
  g_assert_cmpint (doubt, ==, doubtful);
}

static void
test_names (void)
{
  static const struct {
    const char *layer;
    QnRole role;
  } cases[] = { { "SUPPORTS", QN_ROLE_SUPPORT },
                { "Ground", QN_ROLE_SUPPORT },
                { "foundations", QN_ROLE_SUPPORT },
                { "fixed", QN_ROLE_SUPPORT },
                { "Openings", QN_ROLE_OPENING },
                { "VOID", QN_ROLE_OPENING },
                { "A-HOLES", QN_ROLE_OPENING },
                { "windows", QN_ROLE_OPENING },
                { "DOOR 1", QN_ROLE_OPENING },
                { "DIMENSIONS", QN_ROLE_IGNORED },
                { "text", QN_ROLE_IGNORED },
                { "axis", QN_ROLE_IGNORED },
                { "Axes", QN_ROLE_IGNORED },
                { "hatch", QN_ROLE_IGNORED },
                { "Defpoints", QN_ROLE_IGNORED },
                { "QUOIN-CONTACTS", QN_ROLE_IGNORED },
                { "deformed", QN_ROLE_IGNORED },
                { "grid", QN_ROLE_IGNORED },
                { "0", QN_ROLE_BLOCK },
                { "bricks", QN_ROLE_BLOCK } };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++)
    assert_role (NULL, cases[i].layer, cases[i].role, FALSE);
}

/* The last word that is known counts; where others speak against it, or are unknown, it is a guess. */
static void
test_words (void)
{
  static const struct {
    const char *layer;
    QnRole role;
    gboolean doubtful;
  } cases[] = { { "GROUND FLOOR", QN_ROLE_BLOCK, TRUE },
                { "BASEMENT", QN_ROLE_BLOCK, FALSE },
                { "DATABASE", QN_ROLE_BLOCK, FALSE },
                { "BASE COURSE", QN_ROLE_BLOCK, TRUE },
                { "Fensteröffnungen", QN_ROLE_OPENING, TRUE },
                { "Wandaussparung", QN_ROLE_OPENING, TRUE },
                { "Streifenfundamente", QN_ROLE_SUPPORT, TRUE },
                { "BACKGROUND", QN_ROLE_BLOCK, FALSE },
                { "Gelände", QN_ROLE_SUPPORT, FALSE },
                { "Cracks", QN_ROLE_IGNORED, FALSE },
                { "Title block", QN_ROLE_BLOCK, TRUE },
                { "DIMENSION STONE", QN_ROLE_BLOCK, TRUE },
                { "STONE TEXTURE", QN_ROLE_BLOCK, FALSE },
                { "OUTDOOR WALL", QN_ROLE_BLOCK, FALSE },
                { "WINDOW ARCH", QN_ROLE_BLOCK, TRUE },
                { "Door-Jamb", QN_ROLE_BLOCK, TRUE },
                { "MUR", QN_ROLE_BLOCK, FALSE },
                { "wall base", QN_ROLE_SUPPORT, TRUE },
                { "WALL_OPENINGS", QN_ROLE_OPENING, TRUE },
                { "STONE TEXT", QN_ROLE_IGNORED, TRUE },
                { "DIM EXTERIOR", QN_ROLE_IGNORED, TRUE },
                { "FIXED BLOCKS", QN_ROLE_SUPPORT, TRUE },
                { "support left", QN_ROLE_SUPPORT, FALSE },
                { "Öffnungen", QN_ROLE_OPENING, FALSE },
                { "OEFFNUNG 2", QN_ROLE_OPENING, FALSE },
                { "Tür", QN_ROLE_OPENING, FALSE },
                { "Bemaßung", QN_ROLE_IGNORED, FALSE },
                { "Auflager", QN_ROLE_SUPPORT, FALSE },
                { "Fenêtres", QN_ROLE_OPENING, FALSE },
                { "Fondations", QN_ROLE_SUPPORT, FALSE },
                { "COTES", QN_ROLE_IGNORED, FALSE },
                { "finestre", QN_ROLE_OPENING, FALSE },
                { "Fondazione", QN_ROLE_SUPPORT, FALSE },
                { "quote", QN_ROLE_IGNORED, FALSE } };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++)
    assert_role (NULL, cases[i].layer, cases[i].role, cases[i].doubtful);
}

/* What the settings say of a layer wins over its name; case does not matter, the whole name does,
 * and it may contain an equals sign. */
static void
test_table (void)
{
  char *layers[] = { (char *) "Base=block", (char *) "a=b=opening",
                     (char *) "bricks=ignored", NULL };
  QnImportSettings settings = QN_IMPORT_DEFAULTS;
  settings.layers = layers;
  g_assert_true (qn_import_check_layers (&settings, NULL));
  assert_role (layers, "BASE", QN_ROLE_BLOCK, FALSE);
  assert_role (layers, "BASE 2", QN_ROLE_SUPPORT, FALSE);
  assert_role (layers, "A=B", QN_ROLE_OPENING, FALSE);
  assert_role (layers, "a", QN_ROLE_BLOCK, FALSE);
  assert_role (layers, "Bricks", QN_ROLE_IGNORED, FALSE);
  /* A pattern counts where no whole name does. */
  char *kept[] = { (char *) "*=ignored", (char *) "öffnung=opening",
                   (char *) "w?ll=block", NULL };
  assert_role (kept, "ÖFFNUNG", QN_ROLE_OPENING, FALSE);
  assert_role (kept, "base", QN_ROLE_IGNORED, FALSE);
  assert_role (kept, "Wall", QN_ROLE_IGNORED, FALSE);
}

static void
test_refuses (void)
{
  static const char *const wrong[] = { "walls", "walls=", "walls=brick", "walls=Block",
                                       "=" };
  for (gsize i = 0; i < G_N_ELEMENTS (wrong); i++) {
    char *layers[] = { (char *) "base=support", (char *) wrong[i], NULL };
    QnImportSettings settings = QN_IMPORT_DEFAULTS;
    settings.layers = layers;
    g_autoptr (GError) error = NULL;
    g_assert_false (qn_import_check_layers (&settings, &error));
    g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_OVERRIDE);
    g_assert_true (g_str_has_prefix (error->message, wrong[i]));
  }
}

QN_TESTS
{
  g_test_add_func ("/import-layers/names", test_names);
  g_test_add_func ("/import-layers/words", test_words);
  g_test_add_func ("/import-layers/table", test_table);
  g_test_add_func ("/import-layers/refuses", test_refuses);
}
