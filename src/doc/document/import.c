#include "doc/document/import.h"

#include "doc/edit/edit.h"
#include "io/project/project.h"
#include <glib/gi18n-lib.h>
#include <string.h>

gsize
qn_ending_of (const char *path, const char *const *endings)
{
  g_autofree char *lower = g_ascii_strdown (path, -1);
  for (gsize i = 0; endings[i] != NULL; i++)
    if (g_str_has_suffix (lower, endings[i]))
      return strlen (endings[i]);
  return 0;
}

gboolean
qn_import_knows_file (const char *path)
{
  static const char *const endings[] = { ".dxf", ".svg", ".json", ".txt", NULL };
  return qn_ending_of (path, endings) > 0;
}

gboolean
qn_import_is_picture (const char *path)
{
  static const char *const endings[] = { ".png", ".jpg",  ".jpeg", ".tif",
                                         ".bmp", ".tiff", ".webp", NULL };
  return qn_ending_of (path, endings) > 0;
}

static gboolean
add_blocks (QnModel *model, const QnModel *imported, GError **error)
{
  for (gsize i = 0; i < imported->block_count; i++) {
    const QnBlock *from = &imported->blocks[i];
    g_autofree char *name =
      qn_model_find_block (model, from->name) == QN_NONE
        ? g_strdup (from->name)
        : qn_edit_dup_new_name (model, offsetof (QnModel, blocks), from->name, "-", 2);
    QnBlock *block =
      qn_model_add_block (model, name, qn_model_block_vertices (imported, (QnId) i),
                          (gsize) from->vertex_count);
    if (block == NULL)
      return qn_edit_no_memory (error);
    block->thickness = from->thickness;
    block->unit_weight = from->unit_weight;
    block->rigid = from->rigid;
    memcpy (block->support, from->support, sizeof block->support);
  }
  return TRUE;
}

/* What lies behind an empty drawing stays. */
static gboolean
take_over (QnProject *draft, gpointer data, GError **error)
{
  const QnProject *imported = data;
  QnModel copy;
  if (draft->model.block_count > 0)
    return add_blocks (&draft->model, &imported->model, error);
  if (qn_model_copy (&imported->model, &copy, NULL) != QN_OK)
    return qn_edit_no_memory (error);
  qn_model_clear (&draft->model);
  draft->model = copy;
  const cJSON *extra = imported->extras != NULL ? imported->extras->child : NULL;
  for (; extra != NULL; extra = extra->next)
    qn_project_put_extra (draft, extra->string, cJSON_Duplicate (extra, 1));
  return TRUE;
}

gboolean
qn_document_import (QnDocument *document, const char *step, const QnProject *imported,
                    GError **error)
{
  g_autofree char *base = g_path_get_basename (imported->name);
  g_autofree char *name = g_strdup_printf (_ ("Import %s"), base);
  return qn_document_edit (document, step != NULL ? step : name, NULL, take_over,
                           (gpointer) imported, error);
}
