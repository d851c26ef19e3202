/* The layers are strictly one way: what each folder of src/ may include. */
#include "source-tree.h"
#include "support/room.h"

#include <string.h>

/* Header families are named by prefixes of what stands between the quotes or brackets. Rooms are
 * the subfolders of a layer: each may include itself and those named before it. The file with
 * main() stands above the rooms of its layer and may include all of them. */
typedef struct Layer {
  const char *folder;
  const char *rooms[16];
  const char *own[8];      /* folders of ours that it may include */
  const char *foreign[12]; /* system headers it may include beside the C library's */
} Layer;

static const Layer layers[] = {
  { "core",
    { "base", "law", "model", "contact", "linalg", "result", "assembly", "equilibrium",
      "limit", "dynamics", "check", "path", "modal", "capacity" },
    { "core/" },
    { "klu.h", "cholmod.h", "amd.h", "colamd.h", "SuiteSparse_config.h" } },
  { "disk", { NULL }, { "disk/" }, { "glib" } },
  { "stereotomy", { NULL }, { "core/", "stereotomy/" }, { "geos_c.h", "glib" } },
  { "io",
    { "text", "json", "project", "result", "exchange" },
    { "core/", "stereotomy/", "disk/", "io/" },
    { "glib", "gio/", "cjson/", "libxml/" } },
  { "render",
    { "drawing", "scene", "backend", "figure", "movie" },
    { "core/", "disk/", "render/" },
    { "glib", "gio/", "gmodule.h", "cairo", "pango/", "gdk-pixbuf/", "GL/", "EGL/",
      "zlib.h", "gif_lib.h", "gst/" } },
  { "doc",
    { "text", "edit", "masonry", "document", "view" },
    { "core/", "stereotomy/", "io/", "render/", "doc/" },
    { "glib", "gio/", "gmodule.h", "cairo", "pthread.h" } },
  { "library",
    { NULL },
    { "core/", "stereotomy/", "io/", "render/", "doc/", "library/" },
    { "glib", "gio/" } },
  { "study",
    { "plan", "cases", "report", "cluster" },
    { "core/", "stereotomy/", "io/", "render/", "disk/", "study/" },
    { "glib", "gsl/", "sqlite3.h", "poll.h", "sys/file.h", "sys/prctl.h",
      "sys/wait.h" } },
  { "cli",
    { "base", "project", "analysis", "figure", "study", "verify" },
    { "core/", "stereotomy/", "io/", "render/", "doc/", "study/", "cli/", "config.h" },
    { "glib", "gio/" } },
  { "app",
    { "widgets", "canvas", "tools", "forms", "views", "dialogs", "pages", "window" },
    { "core/", "stereotomy/", "io/", "render/", "doc/", "study/", "app/", "config.h" },
    { "glib", "gio/", "gmodule.h", "cairo", "gtk/", "gdk/", "gsk/", "graphene", "pango",
      "dlfcn.h" } },
};

/* Of the C and POSIX libraries. What of them the core may call is another check. */
static const char *const everywhere[] = {
  "assert.h",   "ctype.h",        "errno.h",    "float.h",
  "inttypes.h", "limits.h",       "locale.h",   "math.h",
  "setjmp.h",   "signal.h",       "stdarg.h",   "stdint.h",
  "stdbool.h",  "stddef.h",       "stdio.h",    "stdlib.h",
  "string.h",   "time.h",         "unistd.h",   "fcntl.h",
  "sys/stat.h", "sys/resource.h", "sys/mman.h", "sys/file.h",
  "libintl.h",  "malloc.h",       NULL,         NULL,
};

static const Layer *
layer_of (const char *path)
{
  for (size_t i = 0; i < G_N_ELEMENTS (layers); i++) {
    g_autofree char *prefix = g_strdup_printf ("src/%s/", layers[i].folder);
    if (g_str_has_prefix (path, prefix))
      return &layers[i];
  }
  return NULL;
}

static gboolean
has_one_of (const char *name, const char *const *prefixes, size_t count)
{
  for (size_t i = 0; i < count && prefixes[i] != NULL; i++)
    if (g_str_has_prefix (name, prefixes[i]))
      return TRUE;
  return FALSE;
}

/* The place of the room that a path "room/file" begins with in the list of a layer; -1: none. */
static int
room_of (const Layer *layer, const char *path)
{
  for (int i = 0; i < (int) G_N_ELEMENTS (layer->rooms) && layer->rooms[i]; i++) {
    size_t length = strlen (layer->rooms[i]);
    if (strncmp (path, layer->rooms[i], length) == 0 && path[length] == '/')
      return i;
  }
  return -1;
}

/* A header of the same layer stands in the room of the file itself or in an earlier one. */
static void
check_room (const Layer *layer, const char *path, const char *header, GString *complaints)
{
  g_autofree char *prefix = g_strconcat (layer->folder, "/", NULL);
  if (layer->rooms[0] == NULL || !g_str_has_prefix (header, prefix))
    return;
  const char *inside = path + strlen ("src/") + strlen (prefix);
  int own = room_of (layer, inside), other = room_of (layer, header + strlen (prefix));
  if (strcmp (inside, "main.c") == 0)
    own = (int) G_N_ELEMENTS (layer->rooms);
  if (own < 0 || other < 0)
    complain (complaints, "%s: %s is in no room of layer '%s'", path,
              own < 0 ? "it" : header, layer->folder);
  else if (other > own)
    complain (complaints, "%s: room '%s' may not include %s", path, layer->rooms[own],
              header);
}

/* Checks one line of a source file. */
static void
check_line (const char *path, const char *line, GString *complaints)
{
  g_autofree char *text = g_strdup (line);
  char *at = g_strchug (text);
  if (*at++ != '#')
    return;
  at = g_strchug (at);
  if (!g_str_has_prefix (at, "include"))
    return;

  at = g_strchug (at + strlen ("include"));
  char opening = *at++;
  char *end = strchr (at, opening == '<' ? '>' : '"');
  const Layer *layer = layer_of (path);
  if (end == NULL || layer == NULL) {
    complain (complaints, "%s: cannot judge %s", path, line);
    return;
  }
  *end = '\0';

  gboolean allowed =
    opening == '"' ? has_one_of (at, layer->own, G_N_ELEMENTS (layer->own))
                   : g_strv_contains (everywhere, at)
                       || has_one_of (at, layer->foreign, G_N_ELEMENTS (layer->foreign));
  if (!allowed)
    complain (complaints, "%s: layer '%s' may not include %s", path, layer->folder, at);
  else if (opening == '"')
    check_room (layer, path, at, complaints);
}

static void
test_layers (void)
{
  static const char *const suffixes[] = { ".c", ".h", NULL };
  g_autoptr (GPtrArray) files = source_tree_files ("src", suffixes);
  g_assert_cmpuint (files->len, >, 5);

  GString *complaints = g_string_new (NULL);
  for (guint i = 0; i < files->len; i++) {
    const char *path = g_ptr_array_index (files, i);
    g_auto (GStrv) lines = source_tree_lines (path);
    for (char **line = lines; *line != NULL; line++)
      check_line (path, *line, complaints);
  }
  assert_no_complaints (complaints);
}

static void
expect (const char *path, const char *line, gboolean refused)
{
  GString *complaints = g_string_new (NULL);
  check_line (path, line, complaints);
  if (refused)
    assert_complaint (complaints, path);
  else
    assert_no_complaints (complaints);
}

static void
test_check_can_fail (void)
{
  expect ("src/core/law/a.c", "#include <glib.h>", TRUE);
  expect ("src/core/law/a.c", "#include \"io/project/project-read.h\"", TRUE);
  expect ("src/core/law/a.c", "# include <gtk/gtk.h>", TRUE);
  expect ("src/core/path/a.c", "#include \"core/model/model.h\"", FALSE);
  expect ("src/core/law/a.c", "#include \"core/model/model.h\"", TRUE);
  expect ("src/core/law/a.c", "#include \"core/elsewhere.h\"", TRUE);
  expect ("src/core/a.c", "#include \"core/law/law.h\"", TRUE);
  expect ("src/core/law/a.c", "#include <cholmod.h>", FALSE);
  expect ("src/io/json/a.c", "#include \"render/drawing/scene.h\"", TRUE);
  expect ("src/io/json/a.c", "#include <cairo.h>", TRUE);
  expect ("src/render/scene/a.c", "#include \"io/project/project-read.h\"", TRUE);
  expect ("src/render/scene/a.c", "#include <cairo-svg.h>", FALSE);
  expect ("src/doc/edit/a.c", "#include <gtk/gtk.h>", TRUE);
  expect ("src/study/cases/a.c", "#include \"doc/document/run.h\"", TRUE);
  expect ("src/study/plan/a.c", "#include \"study/cases/store.h\"", TRUE);
  expect ("src/study/plan/a.c", "#include <gsl/gsl_cdf.h>", FALSE);
  expect ("src/doc/edit/a.c", "#include \"study/plan/study.h\"", TRUE);
  expect ("src/cli/base/a.c", "#include <gtk/gtk.h>", TRUE);
  expect ("src/cli/base/a.c", "#include \"app/window/window.h\"", TRUE);
  expect ("src/cli/base/a.c", "#include \"cli/study/cmd-study.h\"", TRUE);
  expect ("src/cli/main.c", "#include \"cli/study/cmd-study.h\"", FALSE);
  expect ("src/cli/main.c", "#include \"cli/cmd-study.h\"", TRUE);
  expect ("src/app/window/a.c", "#include \"cli/command.h\"", TRUE);
  expect ("src/app/window/a.c", "#include <gtk/gtk.h>", FALSE);
  expect ("src/elsewhere/a.c", "#include <math.h>", TRUE);
}

/* Every layer has its line in src/meson.build, in an order in which nobody can name a library
 * of a later one. */
static void
check_subdirs (const char *build_file, GString *complaints)
{
  const char *last = build_file;
  for (size_t i = 0; i < G_N_ELEMENTS (layers); i++) {
    g_autofree char *call = g_strdup_printf ("subdir('%s')", layers[i].folder);
    const char *found = strstr (build_file, call);
    g_autofree char *path =
      g_build_filename (source_tree_root (), "src", layers[i].folder, NULL);
    if (found == NULL) {
      if (g_file_test (path, G_FILE_TEST_IS_DIR))
        complain (complaints, "src/meson.build does not build %s", layers[i].folder);
      continue;
    }
    if (found < last)
      complain (complaints, "src/meson.build: %s comes too early", layers[i].folder);
    last = found;
  }
}

static void
test_subdir_order (void)
{
  g_autofree char *text = source_tree_read ("src/meson.build");
  GString *complaints = g_string_new (NULL);
  check_subdirs (text, complaints);
  assert_no_complaints (complaints);
}

static void
test_subdir_check_can_fail (void)
{
  GString *complaints = g_string_new (NULL);
  check_subdirs ("subdir('io')\nsubdir('core')\n", complaints);
  assert_complaint (complaints, "io comes too early");

  complaints = g_string_new (NULL);
  check_subdirs ("subdir('io')\n", complaints);
  assert_complaint (complaints, "does not build core");
}

QN_TESTS
{
  g_test_add_func ("/checks/includes/layers", test_layers);
  g_test_add_func ("/checks/includes/can-fail", test_check_can_fail);
  g_test_add_func ("/checks/includes/subdir-order", test_subdir_order);
  g_test_add_func ("/checks/includes/subdir-can-fail", test_subdir_check_can_fail);
}
