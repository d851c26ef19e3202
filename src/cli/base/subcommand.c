#include "cli/base/subcommand.h"

#include "cli/base/message.h"
#include "cli/base/shown-text.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>
#include <sys/stat.h>

static const char *
kind_of (const GOptionEntry *entry)
{
  if (entry->arg == G_OPTION_ARG_NONE)
    return "flag";
  return entry->arg == G_OPTION_ARG_FILENAME || entry->arg == G_OPTION_ARG_FILENAME_ARRAY
           ? "file"
           : "text";
}

static gboolean
is_repeated (const GOptionEntry *entry)
{
  return entry->arg == G_OPTION_ARG_STRING_ARRAY
         || entry->arg == G_OPTION_ARG_FILENAME_ARRAY;
}

/* Keeps the strings and lists that parsing has put where the entries say, and checks numbers. */
static void
take_values (const GOptionEntry *entries)
{
  for (; entries->long_name != NULL; entries++)
    if (entries->arg == G_OPTION_ARG_STRING || entries->arg == G_OPTION_ARG_FILENAME
        || is_repeated (entries))
      qn_cli_keep (*(void **) entries->arg_data);
    else if (entries->arg == G_OPTION_ARG_DOUBLE
             && !isfinite (*(double *) entries->arg_data))
      qn_cli_usage_error (_ ("--%s must be a finite number"), entries->long_name);
}

/* Whether two paths lead to one file, there or not. */
static gboolean
is_same_file (const char *path, const char *other)
{
  struct stat a, b;
  if (strcmp (path, "-") == 0 || strcmp (other, "-") == 0)
    return FALSE;
  if (stat (path, &a) == 0 && stat (other, &b) == 0)
    return a.st_dev == b.st_dev && a.st_ino == b.st_ino && S_ISREG (a.st_mode);
  g_autofree char *left = g_canonicalize_filename (path, NULL);
  g_autofree char *right = g_canonicalize_filename (other, NULL);
  return strcmp (left, right) == 0;
}

static gboolean
is_output (const GOptionEntry *entry)
{
  static const char *const names[] = { "output", "csv", "json", "plot", "keep", NULL };
  return entry->arg == G_OPTION_ARG_FILENAME && *(char **) entry->arg_data != NULL
         && g_strv_contains (names, entry->long_name);
}

/* No output may be a file that is read or another output: it would take that one's place, perhaps that
 * of the user's own project. */
static void
check_files (const GOptionEntry *entries, int count, char **arguments)
{
  g_autoptr (GPtrArray) files = g_ptr_array_new ();
  for (const GOptionEntry *e = entries; e->long_name != NULL; e++)
    if (e->arg == G_OPTION_ARG_FILENAME && *(char **) e->arg_data != NULL
        && !g_ptr_array_find (files, *(char **) e->arg_data, NULL)) /* two names of one */
      g_ptr_array_add (files, *(char **) e->arg_data);
  for (int i = 1; i < count; i++)
    g_ptr_array_add (files, arguments[i]);
  for (; entries->long_name != NULL; entries++)
    for (guint i = 0; is_output (entries) && i < files->len; i++) {
      const char *output = *(char **) entries->arg_data;
      if (files->pdata[i] != output && is_same_file (output, files->pdata[i]))
        qn_cli_usage_error (_ ("%s: another file of this command is the same file"),
                            output);
    }
}

/* GLib's own answer to --help ends the program with 0 where nobody can read it. */
static void
end_by_help (GOptionContext *context, int argc, char **argv)
{
  for (int i = 1; i < argc && strcmp (argv[i], "--") != 0; i++)
    if (strcmp (argv[i], "--help") == 0 || strcmp (argv[i], "-h") == 0
        || strcmp (argv[i], "-?") == 0) {
      char *help = g_option_context_get_help (context, TRUE, NULL);
      qn_print_text (help);
      g_free (help);
      qn_cli_stop (QN_EXIT_DONE);
    }
}

gboolean
qn_subcommand_parse (const QnSubcommand *self, const GOptionEntry *entries, int least,
                     int most, int *argc, char ***argv)
{
  g_autoptr (GOptionContext) context = g_option_context_new (self->arguments);
  g_autoptr (GError) error = NULL;
  g_autofree char *name = g_strconcat ("quoin-cli ", self->name, NULL);

  if (*argc == 2 && strcmp ((*argv)[1], QN_DESCRIBE) == 0) {
    /* One line for the subcommand, one for each option, fields parted by tabs; in
     * English, since manual pages and completions are made from it. */
    qn_print ("subcommand\t%s\t%s\t%s\t%s\n", self->name, self->arguments, self->summary,
              self->help != NULL ? self->help : "");
    for (; entries->long_name != NULL; entries++)
      qn_print ("option\t%s\t%c\t%s\t%s\t%s\t%s\n", entries->long_name,
                entries->short_name != 0 ? entries->short_name : '-', kind_of (entries),
                is_repeated (entries) ? "many" : "once",
                entries->arg_description != NULL ? entries->arg_description : "",
                entries->description);
    return FALSE;
  }
  qn_cli_set_subcommand (self->name);
  g_set_prgname (name);
  g_option_context_set_translation_domain (context, GETTEXT_PACKAGE);
  g_option_context_add_main_entries (context, entries, GETTEXT_PACKAGE);
  g_option_context_set_summary (context, _ (self->summary));
  if (self->help != NULL)
    g_option_context_set_description (context, _ (self->help));

  for (const GOptionEntry *e = entries; e->long_name != NULL; e++)
    if (strcmp (e->long_name, "allow-outside") == 0)
      qn_cli_offer_outside ();
  end_by_help (context, *argc, *argv);
  gboolean parsed = g_option_context_parse (context, argc, argv, &error);
  g_set_prgname ("quoin-cli");
  if (!parsed)
    qn_cli_usage_error ("%s", error->message);
  if (*argc > 1 && g_strcmp0 ((*argv)[1], "--") == 0) {
    (*argv)++;
    (*argc)--;
  }
  if (*argc <= least)
    qn_cli_usage_error (_ ("an argument is missing: expected %s"), self->arguments);
  if (*argc - 1 > most)
    qn_cli_usage_error (_ ("too many arguments: expected %s"), self->arguments);
  take_values (entries);
  check_files (entries, *argc, *argv);
  return TRUE;
}
