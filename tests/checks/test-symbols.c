/* What the core's object code may refer to: `nm` on the archive shows better than the source
 * what is called. No GLib, no output, no environment, no way out of the process, and no data
 * that can change between two calls. */
#include "source-tree.h"
#include "support/room.h"

#include <string.h>

/* A trailing '*' stands for any rest. The fortified names (__printf_chk) count as well. */
static const char *const forbidden[] = {
  "g_*",    "gtk_*",   "gdk_*",   "cairo_*",    "cJSON_*", "GEOS*",   "pthread_*",
  "printf", "vprintf", "fprintf", "vfprintf",   "puts",    "fputs",   "putchar",
  "putc",   "fputc",   "fwrite",  "fread",      "fopen",   "fclose",  "open",
  "read",   "write",   "close",   "perror",     "stdout",  "stderr",  "stdin",
  "exit",   "_exit",   "abort",   "quick_exit", "atexit",  "longjmp", "signal",
  "getenv", "setenv",  "putenv",  "system",     "popen",   "fork",    "setlocale",
  "strtod", "atof",    "sscanf",  "rand",       "srand",   "random",  "srandom",
  "dlopen", "dlsym",
};

/* `name` without the decoration that the compiler's fortification adds. */
static char *
plain_name (const char *name)
{
  if (g_str_has_prefix (name, "__") && g_str_has_suffix (name, "_chk"))
    return g_strndup (name + 2, strlen (name) - 6);
  return g_strdup (name);
}

static gboolean
is_forbidden (const char *symbol)
{
  g_autofree char *name = plain_name (symbol);
  for (size_t i = 0; i < G_N_ELEMENTS (forbidden); i++)
    if (g_pattern_match_simple (forbidden[i], name))
      return TRUE;
  return FALSE;
}

/* Whether a section's content can change at run time; .data.rel.ro holds constants with
 * addresses in them. */
static gboolean
is_changeable (const char *section)
{
  return g_str_has_prefix (section, "*COM*") || g_str_has_prefix (section, ".bss")
         || g_str_has_prefix (section, ".tbss") || g_str_has_prefix (section, ".tdata")
         || (g_str_has_prefix (section, ".data")
             && !g_str_has_prefix (section, ".data.rel.ro"));
}

/* Reads the output of `nm --format=sysv`: Name|Value|Class|Type|Size|Line|Section. */
static guint
check_symbols (const char *listing, GString *complaints)
{
  guint seen = 0;
  g_auto (GStrv) lines = g_strsplit (listing, "\n", -1);
  for (char **line = lines; *line != NULL; line++) {
    g_auto (GStrv) fields = g_strsplit (*line, "|", -1);
    if (g_strv_length (fields) != 7)
      continue;
    for (char **field = fields; *field != NULL; field++)
      g_strstrip (*field);
    seen++;
    if (strcmp (fields[6], "*UND*") == 0 && is_forbidden (fields[0]))
      complain (complaints, "the core refers to %s", fields[0]);
    if (is_changeable (fields[6]))
      complain (complaints, "the core has changeable data: %s", fields[0]);
  }
  return seen;
}

static void
test_core_archive (void)
{
  const char *archive = g_getenv ("QUOIN_CORE_ARCHIVE");
  g_assert_nonnull (archive);
  const char *command[] = { "nm", "--format=sysv", archive, NULL };
  g_autofree char *listing = NULL;
  g_autoptr (GError) error = NULL;
  int status = 0;
  g_spawn_sync (NULL, (char **) command, NULL, G_SPAWN_SEARCH_PATH, NULL, NULL, &listing,
                NULL, &status, &error);
  g_assert_no_error (error);
  g_spawn_check_wait_status (status, &error);
  g_assert_no_error (error);

  GString *complaints = g_string_new (NULL);
  g_assert_cmpuint (check_symbols (listing, complaints), >, 10);
  assert_no_complaints (complaints);
}

static void
expect (const char *name, const char *section, gboolean refused)
{
  g_autofree char *listing =
    g_strdup_printf ("%s |0000| U | NOTYPE|  |     |%s\n", name, section);
  GString *complaints = g_string_new (NULL);
  g_assert_cmpuint (check_symbols (listing, complaints), ==, 1);
  if (refused)
    assert_complaint (complaints, name);
  else
    assert_no_complaints (complaints);
}

static void
test_check_can_fail (void)
{
  expect ("printf", "*UND*", TRUE);
  expect ("__printf_chk", "*UND*", TRUE);
  expect ("g_malloc", "*UND*", TRUE);
  expect ("cairo_create", "*UND*", TRUE);
  expect ("exit", "*UND*", TRUE);
  expect ("getenv", "*UND*", TRUE);
  expect ("counter", ".bss", TRUE);
  expect ("counter", ".data", TRUE);
  expect ("counter", ".tbss", TRUE);
  expect ("malloc", "*UND*", FALSE);
  expect ("snprintf", "*UND*", FALSE);
  expect ("__assert_fail", "*UND*", FALSE);
  expect ("qn_model_init", ".text", FALSE);
  expect ("table", ".rodata", FALSE);
  expect ("table", ".data.rel.ro.local", FALSE);
}

QN_TESTS
{
  if (g_getenv ("QUOIN_CORE_ARCHIVE") != NULL)
    g_test_add_func ("/checks/symbols/core-archive", test_core_archive);
  g_test_add_func ("/checks/symbols/can-fail", test_check_can_fail);
}
