/* Project files (*.quoin): a model with the other members of its file.
 *
 * The format is described key by key in data/project-format.md. Required: `format`,
 * `version`; `laws` and `contact.law`; `blocks` or `walls`; of a law `name`, `kind`, `kn`, `ks`
 * and, for coulomb, `friction`; of a block `vertices`, `thickness` and `unit_weight` or
 * `density`; of a wall `unit`, `courses`, `thickness` and `unit_weight` or `density`; of a load
 * what its kind needs. Everything else has the default that the format's description gives.
 */
#pragma once

#include "core/contact/contacts.h"
#include "core/model/model.h"
#include "io/json/json-value.h"

#include <glib.h>

struct cJSON;

typedef struct QnProject {
  QnModel model;        /* prepared: walls are expanded behind the blocks of the file */
  char *name;           /* what messages call the file: its path as given */
  char *path;           /* where it was read from, or NULL for a project from memory */
  char *sha256;         /* of the file's bytes, hexadecimal; overrides do not change it */
  char **overrides;     /* "path=value", NULL-terminated; NULL where there were none */
  GPtrArray *warnings;  /* of char *: "wall.quoin:3:5: colour: unknown key" */
  struct cJSON *extras; /* object with the top-level members that the model does not hold
                           (view, figures, …), in file order; written back as they are. NULL
                           where there are none */
  char *text; /* the file's bytes, to find lines and columns; NULL when unknown */
  gsize text_length;
} QnProject;

/* Reads a project file. `overrides` (nullable, NULL-terminated) are "path=value" strings as of
 * the command line's --set: each replaces or adds one value before anything is interpreted,
 * value being JSON or else a plain string. `project` is overwritten without being cleared and
 * holds nothing on failure. Errors: QN_IO_ERROR. */
gboolean qn_project_load (const char *path, const char *const *overrides,
                          QnProject *project, GError **error);

/* The same from memory; `name` stands for the file in messages. */
gboolean qn_project_parse (const char *text, gsize length, const char *name,
                           const char *const *overrides, QnProject *project,
                           GError **error);

/* An empty project with the format's defaults, not prepared. */
void qn_project_init (QnProject *project);

/* A new project, prepared and without blocks: one law of this name, of dry-jointed stone, for all contacts;
 * the weights of the blocks as dead load, and sideways as live load;
 * load control in large displacements. */
gboolean qn_project_begin (QnProject *project, const char *law, GError **error);

void qn_project_clear (QnProject *project);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnProject, qn_project_clear)

/* Writes the project in the canonical layout, which reads back as the same model. Overrides are part of
 * the model, and so of the written file. */
gboolean qn_project_save (const QnProject *project, const char *path, GError **error);

/* The same as a string; free with g_free(). */
char *qn_project_to_text (const QnProject *project, gsize *length);

/* A project's text in the canonical layout, with the places of its blocks: the text of a project
 * that differs little is written from it. */
typedef struct QnProjectText {
  char *text;
  gsize length;
  gsize (
    *blocks)[2]; /* start and end of every block of the model, equal for those that are
                         not listed one by one; NULL when unknown */
} QnProjectText;

/* Writes a project. Blocks that are equal in `like`, whose text is `like_text`, are copied from
 * there (both nullable). */
QnProjectText *qn_project_write (const QnProject *project, const QnProject *like,
                                 const QnProjectText *like_text);
void qn_project_text_free (QnProjectText *text);

/* ---- editing ---- */

/* A copy of the model and of the members besides it, without text and digest. It shares the
 * warnings. `copy` is overwritten without being cleared and holds nothing on failure. */
gboolean qn_project_copy (const QnProject *project, QnProject *copy, GError **error);

/* Completes a project that was changed: parametric masonry that has no blocks any more is left
 * out, and the model is prepared. FALSE with an error that names the key and the blocks. */
gboolean qn_project_prepare (QnProject *project, GError **error);

/* ---- messages ---- */

/* Path of the key that an entity of the model comes from: "blocks[3]", "walls[0].courses[2][1]"
 * for a block of a wall, "loads.live[0]". `index` may be QN_NONE. Free with g_free(). */
char *qn_project_dup_key_path (const QnProject *project, QnEntity entity, QnId index);

/* Makes of a diagnostic of the core an error with file, line, column, key path and the names of the blocks
 * concerned. */
void qn_project_set_error (const QnProject *project, const QnDiag *diag, GError **error);

/* The same for a refusal of a layer above: the value at a key path ("analysis.geometry"), which may be
 * missing. `message` is translated. */
void qn_project_set_key_error (const QnProject *project, const char *path,
                               const char *message, GError **error);

/* The number of a finding as text: a width in `unit` (value times `factor`), or a multiple of the right value
 * with the remedy; NULL: no number. Free with g_free(). */
char *qn_project_dup_finding_value (const QnFinding *finding, const char *unit,
                                    double factor);

/* Text of a finding about a range: the number, the range and the
 * probable error. Free with g_free(). */
char *qn_range_dup_text (const QnFinding *finding);

/* The findings of contact detection, each as one line in the same form as an error message: an array
 * of char *, free with g_ptr_array_unref(). */
GPtrArray *qn_project_dup_finding_texts (const QnProject *project,
                                         const QnFindings *findings);

/* A reader of these members: its messages name the project's file, line and column; warnings are
 * not kept. */
QnReader qn_project_reader (const QnProject *project);

/* Replaces a member or, where the value is NULL, removes it; the first takes the value over. FALSE
 * with an error in the domain QN_IO_ERROR, that starts with the member's name, where `json` is not
 * JSON. */
void qn_project_put_extra (QnProject *project, const char *member, cJSON *value);
gboolean qn_project_set_extra (QnProject *project, const char *member, const char *json,
                               GError **error);

/* Value of a member as JSON text, or NULL. Free with g_free(). */
char *qn_project_dup_extra (const QnProject *project, const char *member);

/* Digest of the model and its settings alone, hexadecimal: neither the title nor views and
 * figures make a result or a figure stale. Free with g_free(). It is quicker where the project's
 * text is at hand. */
char *qn_model_digest (const QnProject *project, const QnProjectText *text);

/* The same without the settings of the analysis. */
char *qn_structure_digest (const QnProject *project, const QnProjectText *text);
