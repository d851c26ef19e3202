#include "io/exchange/import-work.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <string.h>

static const struct {
  const char *word;
  QnRole role;
} role_words[] = {
  { "SUPPORT", QN_ROLE_SUPPORT }, { "BASE", QN_ROLE_SUPPORT },
  { "GROUND", QN_ROLE_SUPPORT },  { "FOUND", QN_ROLE_SUPPORT },
  { "FIXED", QN_ROLE_SUPPORT },   { "OPENING", QN_ROLE_OPENING },
  { "VOID", QN_ROLE_OPENING },    { "HOLE", QN_ROLE_OPENING },
  { "WINDOW", QN_ROLE_OPENING },  { "DOOR", QN_ROLE_OPENING },
  { "DIM", QN_ROLE_IGNORED },     { "TEXT", QN_ROLE_IGNORED },
  { "AXIS", QN_ROLE_IGNORED },    { "AXES", QN_ROLE_IGNORED },
  { "HATCH", QN_ROLE_IGNORED },   { "DEFPOINT", QN_ROLE_IGNORED },
  { "CONTACT", QN_ROLE_IGNORED }, { "DEFORMED", QN_ROLE_IGNORED },
  { "GRID", QN_ROLE_IGNORED },
};

static gboolean
find_role (const char *word, QnRole *role)
{
  static const char *const names[] = { "block", "support", "opening", "ignored" };
  for (int i = 0; i < QN_ROLE_COUNT; i++)
    if (strcmp (names[i], word) == 0) {
      *role = (QnRole) i;
      return TRUE;
    }
  return FALSE;
}

gboolean
qn_import_check_layers (const QnImportSettings *settings, GError **error)
{
  for (char **layer = settings->layers; layer != NULL && *layer != NULL; layer++) {
    const char *equals = strrchr (*layer, '=');
    QnRole role;
    if (equals == NULL || !find_role (equals + 1, &role)) {
      g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_OVERRIDE,
                   _ ("%s: expected NAME=block, support, opening or ignored"), *layer);
      return FALSE;
    }
  }
  return TRUE;
}

QnRole
qn_import_role_of_layer (const QnImportSettings *settings, const char *layer)
{
  QnRole role = QN_ROLE_BLOCK;
  for (char **given = settings->layers; given != NULL && *given != NULL; given++) {
    const char *equals = strrchr (*given, '=');
    gsize length = (gsize) (equals - *given);
    if (strlen (layer) == length && g_ascii_strncasecmp (*given, layer, length) == 0
        && find_role (equals + 1, &role))
      return role;
  }
  g_autofree char *upper = g_ascii_strup (layer, -1);
  for (gsize i = 0; i < G_N_ELEMENTS (role_words); i++)
    if (strstr (upper, role_words[i].word) != NULL)
      return role_words[i].role;
  return QN_ROLE_BLOCK;
}
