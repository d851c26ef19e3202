#include "io/json/json-value.h"
#include "io/project/project-masonry.h"
#include "io/project/project-members.h"
#include "io/project/project-parts.h"
#include "io/project/project.h"
#include "io/text/file-read.h"

#include <glib/gi18n-lib.h>
#include <string.h>

/* Members of the document: those that become part of the model, and behind them those that it does
 * not hold, which are kept and written back as they are. */
#define MODEL_KEYS 16
static const char *const project_keys[] = {
  "format",          "version",  "title",   "gravity",  "laws",   "blocks",
  "walls",           "contact",  "loads",   "bars",     "ties",   "vehicles",
  "analysis",        "sections", "nodes",   "beams",    "view",   "figures",
  "guides",          "underlay", "history", "capacity", "report", "run_names",
  QN_MASONRY_MEMBER, "envelope"
};

/* Keys of those that the layers above read, where their values are checked when they are needed. */
static const char *const capacity_keys[] = {
  "control",     "spectrum",        "ag",
  "soil",        "damping",         "unit",
  "mechanism",   "confidence",      "tie_strain",
  "part_period", "height",          "building_height",
  "storeys",     "building_period", "building_damping"
};
static const char *const report_keys[] = { "sections", "paper",  "every_joint",
                                           "demand",   "author", "text" };
static const char *const envelope_keys[] = { "vehicles", "from", "to",
                                             "step",     "ways", "method" };
static const char *const underlay_keys[] = { "image", "origin",  "width",
                                             "angle", "opacity", "rectangle" };
static const char *const figure_keys[] = {
  "name",  "view",       "file",    "result",      "title",      "caption",
  "field", "diagram",    "step",    "scale",       "ghost",      "symbols",
  "loads", "dimensions", "names",   "values",      "legend",     "titles",
  "size",  "dpi",        "backend", "transparent", "monochrome", "model_digest"
};

/* Tells unknown keys of what the model does not hold: a demand misspelt is a report without verdict. */
static gboolean
check_extra (const QnJsonValue *place)
{
  static const struct {
    const char *member;
    const char *const *keys;
    gsize count;
  } tables[] = { { "capacity", capacity_keys, G_N_ELEMENTS (capacity_keys) },
                 { "report", report_keys, G_N_ELEMENTS (report_keys) },
                 { "underlay", underlay_keys, G_N_ELEMENTS (underlay_keys) },
                 { "envelope", envelope_keys, G_N_ELEMENTS (envelope_keys) },
                 { "figures", figure_keys, G_N_ELEMENTS (figure_keys) } };
  gsize t = 0;
  while (t < G_N_ELEMENTS (tables) && strcmp (place->key, tables[t].member) != 0)
    t++;
  QnJsonValue element = { 0 };
  if (t == G_N_ELEMENTS (tables))
    return TRUE;
  place->reader->keeps_unknown = FALSE; /* they are kept with the rest of the member */
  bool fine = qn_json_value_check_keys (place, tables[t].keys, tables[t].count);
  if (fine && tables[t].keys == capacity_keys) {
    /* Numbers of a capacity curve that only a mechanism has. */
    static const char *const keys[] = { "tie_strain", "part_period" };
    for (gsize i = 0; i < G_N_ELEMENTS (keys); i++) {
      QnJsonValue value = qn_json_value_member (place, keys[i]);
      if (value.json != NULL
          && !cJSON_IsTrue (cJSON_GetObjectItem (place->json, "mechanism")))
        qn_json_value_warn (&value, _ ("changes nothing without \"mechanism\": true"));
    }
  }
  while (fine && cJSON_IsArray (place->json) && qn_json_value_next (place, &element))
    fine = qn_json_value_check_keys (&element, tables[t].keys, tables[t].count);
  place->reader->keeps_unknown = TRUE;
  return fine;
}

/* Moves the top-level members that the model does not hold out of the tree, with a warning for
 * those that no layer knows. */
static gboolean
keep_extras (const QnJsonValue *root, cJSON *document, QnProject *project)
{
  cJSON *next;
  for (cJSON *child = document->child; child != NULL; child = next) {
    next = child->next;
    gsize key = 0;
    while (key < G_N_ELEMENTS (project_keys)
           && strcmp (child->string, project_keys[key]) != 0)
      key++;
    if (key < MODEL_KEYS)
      continue;
    QnJsonValue place = qn_json_value_child (root, child);
    if (key == G_N_ELEMENTS (project_keys)
          ? !qn_json_value_unknown (&place, project_keys, key)
          : !check_extra (&place))
      return FALSE;
    cJSON_DetachItemViaPointer (document, child);
    if (project->extras == NULL)
      project->extras = cJSON_CreateObject ();
    cJSON_AddItemToObject (project->extras, child->string,
                           child); /* no key comes twice */
  }
  return TRUE;
}

/* A status of the core as the reader's error. */
static gboolean
take_status (const QnJsonValue *root, const QnProject *project, QnStatus status,
             const QnDiag *diag)
{
  if (status != QN_OK && root->reader->error == NULL)
    qn_project_set_error (project, diag, &root->reader->error);
  return status == QN_OK;
}

static gboolean
read_laws (const QnJsonValue *root, QnNeed need, QnModel *model)
{
  if (!qn_read_list (root, &qn_law_list, need, model))
    return FALSE;
  QnJsonValue laws = qn_json_value_member (root, "laws");
  return model->law_count > 0 || need == QN_OPTIONAL
         || qn_json_value_fail (&laws, _ ("there must be at least one law"));
}

static gboolean
read_document (const QnJsonValue *root, cJSON *document, QnProject *project)
{
  static const QnMember head[] = {
    QN_STRING ("title", OPTIONAL, QnModel, title),
    QN_NUMBER ("gravity", OPTIONAL, NOT_NEGATIVE, QnModel, gravity),
    { 0 },
  };
  QnModel *model = &project->model;
  QnDiag diag;
  /* With walls, parametric masonry or beams, no block of its own is needed. */
  gboolean others = cJSON_HasObjectItem (document, "walls")
                    || cJSON_HasObjectItem (document, QN_MASONRY_MEMBER);
  gboolean beams = cJSON_HasObjectItem (document, "beams");
  QnNeed blocks = others || beams ? QN_OPTIONAL : QN_REQUIRED;
  /* Beams alone have no joints. */
  gboolean joints =
    others || cJSON_GetArraySize (cJSON_GetObjectItem (document, "blocks")) > 0;
  QnNeed laws = beams && !joints ? QN_OPTIONAL : QN_REQUIRED;
  return qn_read_format (root, "quoin",
                         _ ("this is not a Quoin project: expected \"quoin\""))
         && keep_extras (root, document, project)
         && qn_members_take (root, head, NULL, model) && read_laws (root, laws, model)
         && qn_read_list (root, &qn_block_list, blocks, model)
         && qn_read_masonry (root, project)
         && qn_read_list (root, &qn_wall_list, QN_OPTIONAL, model)
         && take_status (root, project, qn_model_expand_walls (model, &diag), &diag)
         && qn_read_list (root, &qn_section_list, QN_OPTIONAL, model)
         && qn_read_list (root, &qn_node_list, QN_OPTIONAL, model)
         && qn_read_list (root, &qn_beam_list, QN_OPTIONAL, model)
         && take_status (root, project, qn_model_expand_beams (model, &diag), &diag)
         && qn_read_list (root, &qn_bar_list, QN_OPTIONAL, model)
         && qn_read_list (root, &qn_tie_list, QN_OPTIONAL, model)
         && qn_read_list (root, &qn_vehicle_list, QN_OPTIONAL, model)
         && qn_read_contact (root, model) && qn_read_loads (root, model)
         && qn_read_analysis (root, model)
         && take_status (root, project, qn_model_prepare (model, &diag), &diag);
}

/* Fills an initialised project whose name and text are set. */
static gboolean
read_project (QnProject *project, GError **error)
{
  QnReader reader = { .name = project->name,
                      .keeps_unknown = TRUE,
                      .text = project->text,
                      .length = project->text_length,
                      .overrides = (const char *const *) project->overrides,
                      .warnings = project->warnings };
  /* The tree of the project's text with the overrides applied, or NULL. */
  cJSON *document =
    qn_json_parse (reader.text, reader.length, reader.name, &reader.error);
  for (gsize i = 0; document != NULL && reader.overrides != NULL && reader.overrides[i];
       i++) {
    if (!qn_json_override (document, reader.overrides[i], &reader.error)) {
      g_prefix_error (&reader.error, "%s: ", reader.name);
      g_clear_pointer (&document, cJSON_Delete);
    }
  }
  if (document != NULL) {
    QnJsonValue root = qn_json_value_root (&reader, document);
    read_document (&root, document, project);
    qn_project_keep_inner (project, &reader);
    cJSON_Delete (document);
    if (reader.dropped_warnings > 0)
      g_ptr_array_add (
        reader.warnings,
        g_strdup_printf (ngettext ("%s: %u more warning", "%s: %u more warnings",
                                   reader.dropped_warnings),
                         reader.name, reader.dropped_warnings));
  }
  if (reader.error == NULL) {
    project->sha256 = g_compute_checksum_for_data (
      G_CHECKSUM_SHA256, (const guchar *) project->text, project->text_length);
    return TRUE;
  }
  g_propagate_error (error, reader.error);
  qn_project_clear (project);
  return FALSE;
}

gboolean
qn_project_parse (const char *text, gsize length, const char *name,
                  const char *const *overrides, QnProject *project, GError **error)
{
  qn_project_init (project);
  project->name = g_strdup (name);
  project->overrides = g_strdupv ((char **) overrides);
  project->text = g_strndup ("", length + 1);
  if (length > 0)
    memcpy (project->text, text, length);
  project->text_length = length;
  return read_project (project, error);
}

gboolean
qn_project_load (const char *path, const char *const *overrides, QnProject *project,
                 GError **error)
{
  gsize length;
  *project = (QnProject){ 0 };
  g_autofree char *text = qn_file_read (path, &length, error);
  if (text == NULL || !qn_project_parse (text, length, path, overrides, project, error))
    return FALSE;
  project->path = g_strdup (path);
  return TRUE;
}
