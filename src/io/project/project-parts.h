/* Private to reading and writing project files: a list of entities, or two functions, per
 * part of the document. One reads the part from `root`, the document, into the model and returns FALSE with
 * the reader's error set; the other appends the part in the canonical layout, with unknown members
 * (`inner`, which may be NULL).
 *
 * Members that no layer uses are kept inside laws, blocks, loads, stages …, contact, loads and analysis. The
 * note of an entity is the number of its members, so that they follow the entity.
 */
#pragma once

#include "core/model/model.h"
#include "io/project/project-members.h"
#include "io/project/project.h"

/* Where the project's extras keep unknown members; no member of a document may be called that. */
#define QN_INNER_MEMBER "\x01inner"

/* The note of an entity that has just been read; 0: it has no unknown members. */
int32_t qn_read_note (const QnJsonValue *place);

/* Takes over the unknown members of the reader, of entities that were given a note and of objects that there
 * is one of. */
void qn_project_keep_inner (QnProject *project, QnReader *reader);

/* Adds the unknown members of an owner ("contact", "analysis", …), or of the entity with this note,
 * to its object, the end of which was just written. */
void qn_json_append_inner (GString *json, GHashTable *inner, const char *owner);
void qn_json_append_note (GString *json, GHashTable *inner, int32_t note);

typedef enum {
  QN_NAMING_NONE,
  QN_NAMING_OPTIONAL, /* NULL where the file has none */
  QN_NAMING_NUMBERED, /* else b1, b2 … by the letter that the path begins with */
  QN_NAMING_REQUIRED  /* and not empty */
} QnNaming;

/* A list of entities: its path in the file ("analysis.stages") and place in the model, whether the entities
 * have names, and their members, which are read behind the name. All functions may be NULL. */
typedef struct QnList {
  const char *path;
  QnNaming naming;
  const QnMember *members; /* NULL: `read` reads and checks all of them */
  gconstpointer usual;     /* of qn_members_write() */
  /* Adds an element; NULL with the error set. Without: as most lists do. */
  gpointer (*add) (const QnJsonValue *place, QnModel *model, const char *name);
  /* Reads what the table does not. */
  gboolean (*read) (const QnJsonValue *place, QnModel *model, gpointer entity);
  /* Writes all members behind the name. Without: those of the table. */
  void (*append) (GString *json, const QnModel *model, size_t index);
  bool (*is_left_out) (const QnModel *model, size_t index); /* when written */
  gsize items, count; /* offsets in QnModel, of the array and its number of elements */
  gsize size, note;   /* of an element, and the offset in it */
} QnList;

#define QN_LIST(where, type, all, number)                                                \
  .path = where, .items = offsetof (QnModel, all), .count = offsetof (QnModel, number),  \
  .size = sizeof (type), .note = offsetof (type, note)

extern const QnList qn_law_list, qn_block_list, qn_wall_list, qn_section_list,
  qn_node_list, qn_beam_list, qn_bar_list, qn_tie_list, qn_vehicle_list, qn_face_list,
  qn_stage_list, qn_ground_list, qn_initial_list, qn_track_list;

/* Reads a list of `owner`, the object that holds it. */
gboolean qn_read_list (const QnJsonValue *owner, const QnList *list, QnNeed need,
                       QnModel *model);

/* Appends a list, one entity a line, with unknown members; nothing for an empty list. */
void qn_json_append_list (GString *json, const QnModel *model, GHashTable *inner,
                          const QnList *list);

/* The note of an entity. */
int32_t *qn_list_note (const QnModel *model, const QnList *list, size_t index);

/* In project-contact.c; the walls must be expanded, so that their blocks have names. */
gboolean qn_read_contact (const QnJsonValue *root, QnModel *model);
void qn_project_append_contact (GString *json, const QnModel *model, GHashTable *inner);

/* In project-loads.c; likewise. */
gboolean qn_read_loads (const QnJsonValue *root, QnModel *model);
void qn_project_append_loads (GString *json, const QnModel *model, GHashTable *inner);

/* In project-analysis.c; after the loads. */
gboolean qn_read_analysis (const QnJsonValue *root, QnModel *model);
void qn_project_append_analysis (GString *json, const QnModel *model, GHashTable *inner);

/* Place in the file's list of a stage, of which a cyclic protocol has one. */
gsize qn_project_stage_entry (const QnModel *model, gsize index);

/* `courses`: lists of lengths. */
gboolean qn_read_courses (const QnJsonValue *place, QnWall *wall);
