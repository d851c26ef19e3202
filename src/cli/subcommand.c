#include "cli/subcommand.h"

#include "cli/message.h"

#include <glib/gi18n.h>

static gboolean
check_count (const QnSubcommand *self, int count, int least, int most)
{
  if (count >= least && count <= most)
    return TRUE;
  qn_cli_usage_error (self->name, count < least ? _ ("an argument is missing")
                                                : _ ("too many arguments"));
  return FALSE;
}

gboolean
qn_subcommand_parse (const QnSubcommand *self, const GOptionEntry *entries, int least,
                     int most, int *argc, char ***argv)
{
  g_autoptr (GOptionContext) context = g_option_context_new (self->arguments);
  g_autoptr (GError) error = NULL;
  g_autofree char *name = g_strconcat ("quoin-cli ", self->name, NULL);

  g_set_prgname (name);
  g_option_context_set_translation_domain (context, GETTEXT_PACKAGE);
  g_option_context_add_main_entries (context, entries, GETTEXT_PACKAGE);
  g_option_context_set_summary (context, _ (self->summary));
  if (self->help != NULL)
    g_option_context_set_description (context, _ (self->help));

  gboolean parsed = g_option_context_parse (context, argc, argv, &error);
  g_set_prgname ("quoin-cli");
  if (!parsed) {
    qn_cli_usage_error (self->name, error->message);
    return FALSE;
  }
  if (*argc > 1 && g_strcmp0 ((*argv)[1], "--") == 0) {
    (*argv)++;
    (*argc)--;
  }
  return check_count (self, *argc - 1, least, most);
}
