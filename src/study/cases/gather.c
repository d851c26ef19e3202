#include "study/cases/gather.h"

#include "io/text/io-error.h"
#include "study/cases/store.h"

#include <errno.h>
#include <glib/gi18n-lib.h>
#include <string.h>
#include <unistd.h>

static int
compare_names (gconstpointer a, gconstpointer b)
{
  return strcmp (*(const char *const *) a, *(const char *const *) b);
}

/* Paths of the slices' databases, in the order of their names; NULL where the folder cannot be
 * read. */
static GPtrArray *
find_slices (const char *folder, GError **error)
{
  const char *name;
  g_autoptr (GDir) dir = g_dir_open (folder, 0, NULL);
  if (dir == NULL) {
    qn_io_error_set_errno (error, folder, _ ("cannot be read"), errno);
    return NULL;
  }
  GPtrArray *paths = g_ptr_array_new_with_free_func (g_free);
  while ((name = g_dir_read_name (dir)) != NULL)
    if (g_str_has_prefix (name, "shard-") && g_str_has_suffix (name, ".db"))
      g_ptr_array_add (paths, g_build_filename (folder, name, NULL));
  g_ptr_array_sort (paths, compare_names);
  return paths;
}

gboolean
qn_study_gather (const QnStudy *study, const char *folder, QnGathered *gathered,
                 GError **error)
{
  g_autofree char *database = qn_folder_dup_database (folder, (QnShard){ 0, 1 });
  g_autoptr (GPtrArray) slices = find_slices (folder, error);
  *gathered = (QnGathered){ .count = qn_study_case_count (study) };
  int lock = slices != NULL ? qn_folder_lock (database, error) : -1;
  if (lock < 0)
    return FALSE;
  QnStore *store = qn_store_open (database, study, TRUE, error);
  gboolean ok = store != NULL;
  for (guint i = 0; ok && i < slices->len; i++) {
    gsize added = 0;
    ok = qn_store_merge (store, g_ptr_array_index (slices, i), &added, error);
    gathered->added += added;
  }
  ok = ok && qn_store_count (store, &gathered->present, &gathered->failed, error);
  qn_store_close (store);
  close (lock);
  return ok;
}
