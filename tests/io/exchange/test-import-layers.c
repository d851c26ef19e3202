#include "io/exchange/import-work.h"
#include "io/text/io-error.h"
#include "support/room.h"

static void
test_names (void)
{
  static const struct {
    const char *layer;
    QnRole role;
  } cases[] = { { "SUPPORTS", QN_ROLE_SUPPORT },
                { "wall base", QN_ROLE_SUPPORT },
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
  QnImportSettings settings = QN_IMPORT_DEFAULTS;
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_test_message ("%s", cases[i].layer);
    g_assert_cmpint (qn_import_role_of_layer (&settings, cases[i].layer), ==,
                     cases[i].role);
  }
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
  g_assert_cmpint (qn_import_role_of_layer (&settings, "BASE"), ==, QN_ROLE_BLOCK);
  g_assert_cmpint (qn_import_role_of_layer (&settings, "BASE 2"), ==, QN_ROLE_SUPPORT);
  g_assert_cmpint (qn_import_role_of_layer (&settings, "A=B"), ==, QN_ROLE_OPENING);
  g_assert_cmpint (qn_import_role_of_layer (&settings, "a"), ==, QN_ROLE_BLOCK);
  g_assert_cmpint (qn_import_role_of_layer (&settings, "Bricks"), ==, QN_ROLE_IGNORED);
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
  g_test_add_func ("/import-layers/table", test_table);
  g_test_add_func ("/import-layers/refuses", test_refuses);
}
