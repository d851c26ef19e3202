#include "io/project/project-masonry.h"
#include "io/text/io-error.h"

#include <cjson/cJSON.h>
#include <glib/gi18n-lib.h>

gboolean
qn_read_masonry (const QnJsonValue *root, QnProject *project)
{
  /* Its members have been moved into the extras. */
  QnJsonValue document = { .reader = root->reader, .json = project->extras };
  QnJsonValue list, place = { 0 };
  if (!qn_member_array (&document, QN_MASONRY_MEMBER, QN_OPTIONAL, &list))
    return FALSE;
  while (qn_json_value_next (&list, &place)) {
    QnMasonry masonry;
    if (!qn_read_masonry_object (&place, &project->model, &masonry))
      return FALSE;
    QnModel *model = &project->model;
    size_t first = model->block_count;
    QnDiag diag;
    QnStatus status = qn_masonry_expand (&masonry, (QnId) place.index, model, &diag);
    for (size_t i = first; i < model->block_count; i++)
      model->blocks[i].masonry = (QnId) place.index;
    qn_masonry_clear (&masonry);
    if (status != QN_OK) {
      qn_project_set_error (project, &diag, &root->reader->error);
      return FALSE;
    }
  }
  return TRUE;
}

gboolean
qn_project_get_masonry (const QnProject *project, QnMasonries *list, GError **error)
{
  *list = (QnMasonries){ 0 };
  QnReader reader = { .name = project->name };
  QnJsonValue root = qn_json_value_root (&reader, project->extras);
  QnJsonValue place = qn_json_value_member (&root, QN_MASONRY_MEMBER), element = { 0 };
  while (qn_json_value_next (&place, &element)) {
    QnMasonry masonry;
    if (!qn_read_masonry_object (&element, &project->model, &masonry)) {
      g_propagate_error (error, reader.error);
      qn_masonries_clear (list);
      return FALSE;
    }
    if (!qn_masonries_take (list, &masonry)) {
      qn_masonry_clear (&masonry);
      qn_masonries_clear (list);
      g_set_error_literal (error, QN_IO_ERROR, QN_IO_ERROR_NO_MEMORY,
                           _ ("not enough memory"));
      return FALSE;
    }
  }
  return TRUE;
}

void
qn_project_detach_masonry (QnProject *project, QnId index)
{
  QnModel *model = &project->model;
  for (size_t i = 0; i < model->block_count; i++)
    if (model->blocks[i].masonry == index)
      model->blocks[i].masonry = QN_NONE;
}

gboolean
qn_project_has_masonry (const QnProject *project, QnId index)
{
  const QnModel *model = &project->model;
  for (size_t i = 0; i < model->block_count; i++)
    if (model->blocks[i].masonry == index)
      return TRUE;
  return FALSE;
}

void
qn_project_drop_detached (QnProject *project)
{
  QnModel *model = &project->model;
  cJSON *list = cJSON_GetObjectItemCaseSensitive (project->extras, QN_MASONRY_MEMBER);
  gsize count = (gsize) cJSON_GetArraySize (list), kept = 0, index = 0;
  g_autofree QnId *numbers = g_new (QnId, count + 1);
  for (gsize i = 0; i < count; i++)
    numbers[i] = QN_NONE;
  for (size_t i = 0; i < model->block_count; i++)
    if (model->blocks[i].masonry != QN_NONE)
      numbers[model->blocks[i].masonry] = 0;

  for (cJSON *item = list != NULL ? list->child : NULL, *next; item != NULL;
       item = next) {
    next = item->next;
    if (numbers[index] == QN_NONE)
      cJSON_Delete (cJSON_DetachItemViaPointer (list, item));
    else
      numbers[index] = (QnId) kept++;
    index++;
  }
  for (size_t i = 0; i < model->block_count; i++)
    if (model->blocks[i].masonry != QN_NONE)
      model->blocks[i].masonry = numbers[model->blocks[i].masonry];
  if (kept == 0)
    cJSON_DeleteItemFromObjectCaseSensitive (project->extras, QN_MASONRY_MEMBER);
}
