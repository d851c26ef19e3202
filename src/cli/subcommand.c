#include "cli/subcommand.h"

#include "cli/message.h"

#include <glib/gi18n.h>
#include <stdio.h>
#include <string.h>

static const char *
kind_of (const GOptionEntry *entry)
{
  if (entry->arg == G_OPTION_ARG_NONE)
    return "flag";
  return entry->arg == G_OPTION_ARG_FILENAME ? "file" : "text";
}

/* One line for the subcommand, one for each option, fields parted by tabs; in English, since manual
 * pages and completions are made from it. */
static void
describe (const QnSubcommand *self, const GOptionEntry *entries)
{
  printf ("subcommand\t%s\t%s\t%s\t%s\n", self->name, self->arguments, self->summary,
          self->help != NULL ? self->help : "");
  for (; entries->long_name != NULL; entries++)
    printf ("option\t%s\t%c\t%s\t%s\t%s\t%s\n", entries->long_name,
            entries->short_name != 0 ? entries->short_name : '-', kind_of (entries),
            entries->arg == G_OPTION_ARG_STRING_ARRAY ? "many" : "once",
            entries->arg_description != NULL ? entries->arg_description : "",
            entries->description);
}

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

  if (*argc == 2 && strcmp ((*argv)[1], QN_DESCRIBE) == 0) {
    describe (self, entries);
    return FALSE;
  }
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
