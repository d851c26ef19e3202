#include "cli/base/subcommand.h"

#include "cli/base/message.h"
#include "cli/base/progress.h"

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

static gboolean to_stdout; /* some output goes there */

gboolean
qn_subcommand_prints (void)
{
  return !qn_cli_quiet && !to_stdout;
}

/* No output may be a file that is read or another output: it would take that one's place, perhaps that
 * of the user's own project. */
static void
check_files (const GOptionEntry *entries, int count, char **arguments)
{
  static const char *const outputs[] = { "output", "csv", "json", "plot", "keep", NULL };
  g_autoptr (GPtrArray) files = g_ptr_array_new ();
  for (const GOptionEntry *e = entries; e->long_name != NULL; e++)
    if (e->arg == G_OPTION_ARG_FILENAME && *(char **) e->arg_data != NULL
        && !g_ptr_array_find (files, *(char **) e->arg_data, NULL)) /* two names of one */
      g_ptr_array_add (files, *(char **) e->arg_data);
  for (int i = 1; i < count; i++)
    g_ptr_array_add (files, arguments[i]);
  for (; entries->long_name != NULL; entries++) {
    const char *output = entries->arg == G_OPTION_ARG_FILENAME
                             && g_strv_contains (outputs, entries->long_name)
                           ? *(char **) entries->arg_data
                           : NULL;
    for (guint i = 0; output != NULL && i < files->len; i++) {
      to_stdout |= strcmp (output, "-") == 0;
      if (files->pdata[i] != output && is_same_file (output, files->pdata[i]))
        qn_cli_usage_error (_ ("%s: another file of this command is the same file"),
                            output);
    }
  }
}

/* One line for the subcommand, one for each option, fields parted by tabs; in English, since manual pages and
 * completions are made from it. */
static void
describe (const QnSubcommand *self)
{
  qn_print ("subcommand\t%s\t%s\t%s\t%s\n", self->name, self->arguments, self->summary,
            self->help != NULL ? self->help : "");
  for (const GOptionEntry *e = self->options; e != NULL && e->long_name != NULL; e++)
    qn_print ("option\t%s\t%c\t%s\t%s\t%s\t%s\n", e->long_name,
              e->short_name != 0 ? e->short_name : '-', kind_of (e),
              is_repeated (e) ? "many" : "once",
              e->arg_description != NULL ? e->arg_description : "", e->description);
  for (gsize i = 0; self->actions != NULL && self->actions[i] != NULL; i++)
    describe (self->actions[i]);
}

void
qn_subcommand_run (const QnSubcommand *self, int argc, char **argv)
{
  static const GOptionEntry none[] = { G_OPTION_ENTRY_NULL };
  const GOptionEntry *options = self->options != NULL ? self->options : none;

  if (argc == 2 && strcmp (argv[1], QN_DESCRIBE) == 0) {
    describe (self);
    return;
  }
  qn_cli_set_subcommand (self->name);
  if (self->actions != NULL) {
    self->run (argv + 1);
    return;
  }
  g_autoptr (GOptionContext) context = g_option_context_new (self->arguments);
  g_autoptr (GError) error = NULL;
  g_autofree char *name = g_strconcat ("quoin-cli ", self->name, NULL);
  g_set_prgname (name);
  g_option_context_set_translation_domain (context, GETTEXT_PACKAGE);
  g_option_context_add_main_entries (context, options, GETTEXT_PACKAGE);
  g_option_context_set_summary (context, _ (self->summary));
  g_option_context_set_ignore_unknown_options (context, self->keys);
  if (self->help != NULL)
    g_option_context_set_description (context, _ (self->help));

  for (const GOptionEntry *e = options; e->long_name != NULL; e++)
    if (strcmp (e->long_name, "allow-outside") == 0)
      qn_cli_offer_outside ();
  /* GLib's own answer to --help ends the program with 0 where nobody can read it. */
  for (int i = 1; i < argc && strcmp (argv[i], "--") != 0; i++)
    if (strcmp (argv[i], "--help") == 0 || strcmp (argv[i], "-h") == 0
        || strcmp (argv[i], "-?") == 0) {
      char *help = g_option_context_get_help (context, TRUE, NULL);
      qn_print_text (help);
      g_free (help);
      qn_cli_stop (QN_EXIT_DONE);
    }
  gboolean parsed = g_option_context_parse (context, &argc, &argv, &error);
  g_set_prgname ("quoin-cli");
  if (!parsed)
    qn_cli_usage_error ("%s", error->message);
  if (argc > 1 && g_strcmp0 (argv[1], "--") == 0) {
    argv++;
    argc--;
  }
  if (argc < 2 && !self->optional)
    qn_cli_usage_error (_ ("an argument is missing: expected %s"), self->arguments);
  if (argc > 2 && !self->many)
    qn_cli_usage_error (_ ("too many arguments: expected %s"), self->arguments);
  /* What parsing has put where the entries say: strings and lists are kept, numbers checked. */
  for (const GOptionEntry *e = options; e->long_name != NULL; e++)
    if (e->arg == G_OPTION_ARG_STRING || e->arg == G_OPTION_ARG_FILENAME
        || is_repeated (e))
      qn_cli_keep (*(void **) e->arg_data);
    else if (e->arg == G_OPTION_ARG_DOUBLE && !isfinite (*(double *) e->arg_data))
      qn_cli_usage_error (_ ("--%s must be a finite number"), e->long_name);
  check_files (options, argc, argv);
  argv[argc] = NULL;
  self->run (argv + 1);
}
