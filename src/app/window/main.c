#include "app/widgets/build-tree.h"
#include "app/window/application.h"

#include <glib/gi18n.h>
#include <glib/gstdio.h>
#include <locale.h>
#include <signal.h>
#include <unistd.h>

int
main (int argc, char **argv)
{
  setlocale (LC_ALL, "");
  g_autofree char *built = qn_build_tree_dup_folder ("po");
  bindtextdomain (GETTEXT_PACKAGE, built != NULL ? built : QN_LOCALE_DIR);
  bind_textdomain_codeset (GETTEXT_PACKAGE, "UTF-8");
  textdomain (GETTEXT_PACKAGE);

  /* Where nothing can be kept, settings last as long as the program. */
  if (g_access (g_get_user_runtime_dir (), W_OK) != 0)
    g_setenv ("GSETTINGS_BACKEND", "memory", FALSE);

  /* A file beyond what the user may write is an error like others, not a reason to die. */
  signal (SIGXFSZ, SIG_IGN);
  g_autoptr (GtkApplication) application = qn_application_new ();
  return g_application_run (G_APPLICATION (application), argc, argv);
}
