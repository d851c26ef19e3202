/* Ties of a project file. */
#include "io/project/project-members.h"
#include "io/project/project-parts.h"
#include "io/text/json-text.h"

#include <glib/gi18n-lib.h>

static const QnMember end_members[] = {
  QN_ENTITY ("block", OPTIONAL, BLOCK, QnTieEnd, block),
  QN_TWO ("at", REQUIRED, QnTieEnd, at),
  { 0 },
};

static const QnMember plate_members[] = {
  QN_NUMBER ("diameter", REQUIRED, POSITIVE, QnTiePlate, diameter),
  QN_NUMBER ("wall", OPTIONAL, NOT_NEGATIVE, QnTiePlate, wall),
  QN_NUMBER ("shear", OPTIONAL, NOT_NEGATIVE, QnTiePlate, shear),
  QN_NUMBER ("compression", OPTIONAL, NOT_NEGATIVE, QnTiePlate, compression),
  { 0 },
};

static const QnMember strip_members[] = {
  QN_NUMBER ("width", REQUIRED, POSITIVE, QnTieStrip, width),
  QN_NUMBER ("fracture_energy", OPTIONAL, NOT_NEGATIVE, QnTieStrip, fracture_energy),
  { 0 },
};

static const QnMember tie_members[] = {
  QN_KNOWN ("name"),
  QN_KNOWN ("ends"),
  QN_NUMBER ("area", REQUIRED, POSITIVE, QnTie, area),
  QN_NUMBER ("elasticity", REQUIRED, POSITIVE, QnTie, elasticity),
  QN_NUMBER ("yield", OPTIONAL, POSITIVE, QnTie, yield),
  QN_NUMBER ("prestress", OPTIONAL, NOT_NEGATIVE, QnTie, prestress),
  QN_NUMBER ("slack", OPTIONAL, NOT_NEGATIVE, QnTie, slack),
  QN_NUMBER ("anchor", OPTIONAL, POSITIVE, QnTie, anchor),
  QN_OBJECT ("plate", OPTIONAL, plate_members, QnTie, plate),
  QN_OBJECT ("strip", OPTIONAL, strip_members, QnTie, strip),
  { 0 },
};

static gboolean
read_ends (const QnJsonValue *place, const QnModel *model, QnTie *tie)
{
  QnJsonValue ends, end = { 0 };
  if (!qn_member_array (place, "ends", QN_REQUIRED, &ends))
    return FALSE;
  if (cJSON_GetArraySize (ends.json) != 2)
    return qn_json_value_fail (&ends, _ ("expected two values, one for each end"));
  while (qn_json_value_next (&ends, &end))
    if (!qn_members_read (&end, end_members, model, &tie->ends[end.index]))
      return FALSE;
  return TRUE;
}

static gboolean
read_tie (const QnJsonValue *place, QnModel *model)
{
  char text[QN_NAME_TEXT_SIZE];
  const char *name;
  if (!qn_json_value_object (place) || !qn_read_own_name (place, "t", text, &name))
    return FALSE;
  QnTie *tie = qn_model_add_tie (model, name);
  if (tie == NULL)
    return qn_json_value_no_memory (place);
  return qn_members_read (place, tie_members, model, tie)
         && read_ends (place, model, tie);
}

static void
append_tie (GString *json, const QnModel *model, size_t index)
{
  static const QnTie usual = { 0 };
  const QnTie *tie = &model->ties[index];
  qn_json_put_string (json, "name", tie->name);
  qn_json_begin_member (json, "ends");
  for (int end = 0; end < 2; end++) {
    g_string_append (json, end == 0 ? "[{" : " }, {");
    qn_members_write (json, end_members, model, &tie->ends[end], NULL);
  }
  g_string_append (json, " }]");
  qn_members_write (json, tie_members, model, tie, &usual);
}

const QnList qn_tie_list =
  QN_LIST ("ties", read_tie, append_tie, NULL, QnTie, ties, tie_count);
