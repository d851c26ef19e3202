/* Members of an object of a project or result file as a table: the keys, and how each is read into a
 * struct and written from it. Tables are read and written in their order, and end with { 0 }.
 */
#pragma once

#include "core/model/model.h"
#include "io/json/json-value.h"

#include <stddef.h>

typedef enum {
  QN_MEMBER_KNOWN,  /* read and written by code */
  QN_MEMBER_NUMBER, /* double */
  QN_MEMBER_COUNT,  /* int32_t from 1 on */
  QN_MEMBER_BOOL,   /* bool */
  QN_MEMBER_CHOICE, /* an enumeration, by its names */
  QN_MEMBER_SWITCH, /* bool, by two names: that of false first */
  QN_MEMBER_STRING, /* char *, owned; NULL: none */
  QN_MEMBER_ENTITY, /* QnId, by the name of the entity; QN_NONE: none */
  QN_MEMBER_SEED,   /* uint32_t */
  QN_MEMBER_ROWS,   /* up to so many rows of numbers, such as QnVec2 */
  QN_MEMBER_OBJECT, /* a struct by a table; left out where all its members are as usual */

  /* Lists of a length; none, or none but usual values: left out. */
  QN_MEMBER_FLAGS,   /* bool */
  QN_MEMBER_NUMBERS, /* double; two of them are a QnVec2, too */
  QN_MEMBER_NAMES,   /* two QnId, as ENTITY */
  QN_MEMBER_OBJECTS, /* structs by a table */

  /* Parts of several keys. */
  QN_MEMBER_WEIGHT, /* unit_weight and the density behind it, as in QnBlock: one of them */
  QN_MEMBER_LAW,    /* QnId, by `law` or its synonym `material`; QN_NONE: none */

  /* In results alone. */
  QN_MEMBER_MAYBE, /* double; null: NAN, or not `given` */
  QN_MEMBER_WHOLE, /* int32_t, not below `detail` */
  QN_MEMBER_BYTES, /* int64_t, not negative */
  QN_MEMBER_IDS,   /* two QnId by their numbers, which follow each other */
  QN_MEMBER_STAGE  /* int32_t from 1, which files count from 0; 0: none */
} QnMemberKind;

typedef enum {
  QN_USE_OPTIONAL, /* written if it is not the default */
  QN_USE_WRITTEN,  /* always written, optional when read */
  QN_USE_REQUIRED,
  QN_USE_READ /* optional; written by code */
} QnMemberUse;

/* Entities that members name. */
typedef enum {
  QN_NAMED_LAW,
  QN_NAMED_BLOCK,
  QN_NAMED_NODE,
  QN_NAMED_SECTION,
  QN_NAMED_BEAM,
  QN_NAMED_LOAD_SET,
  QN_NAMED_LOAD_CASE
} QnNamed;

typedef struct QnMember {
  const char *key;
  QnMemberKind kind;
  QnMemberUse use;
  gsize offset; /* in the struct */
  int detail;   /* QnRange, largest count, number of names or of values, or QnNamed */
  const char *const *names; /* of a choice or a switch; NULL among them: null */
  gsize given; /* offset of a bool that says whether the member is there; 0: none */
  gsize count; /* ROWS: offset of their number, int32_t; OBJECTS: size of one */
  gsize width; /* ROWS: numbers in each */
  const char
    *refusal; /* of a list of another length; translatable; NULL: of two numbers */
  const struct QnMember *members; /* of an OBJECT, and of OBJECTS */
} QnMember;

#define QN_KNOWN(name)                                                                   \
  {                                                                                      \
    .key = name                                                                          \
  }
#define QN_MEMBER_WITH(name, what, when, type, member, how, ...)                         \
  {                                                                                      \
    .key = name, .kind = QN_MEMBER_##what, .use = QN_USE_##when,                         \
    .offset = offsetof (type, member), .detail = how, __VA_ARGS__                        \
  }
#define QN_MEMBER(name, what, when, type, member, how, choices)                          \
  QN_MEMBER_WITH (name, what, when, type, member, how, .names = choices)
#define QN_NUMBER(key, use, range, type, member)                                         \
  QN_MEMBER (key, NUMBER, use, type, member, QN_RANGE_##range, NULL)
#define QN_COUNT(key, use, most, type, member)                                           \
  QN_MEMBER (key, COUNT, use, type, member, most, NULL)
#define QN_BOOL(key, use, type, member) QN_MEMBER (key, BOOL, use, type, member, 0, NULL)
#define QN_TWO(key, use, type, member)                                                   \
  QN_MEMBER (key, NUMBERS, use, type, member, 2, NULL)
#define QN_CHOICE(key, use, names, type, member)                                         \
  QN_MEMBER (key, CHOICE, use, type, member, G_N_ELEMENTS (names), names)
#define QN_SWITCH(key, use, names, type, member)                                         \
  QN_MEMBER (key, SWITCH, use, type, member, 2, names)
#define QN_STRING(key, use, type, member)                                                \
  QN_MEMBER (key, STRING, use, type, member, 0, NULL)
#define QN_ENTITY(key, use, named, type, member)                                         \
  QN_MEMBER (key, ENTITY, use, type, member, QN_NAMED_##named, NULL)
#define QN_GIVEN(name, what, how, type, member, is_there)                                \
  QN_MEMBER_WITH (name, what, OPTIONAL, type, member, how,                               \
                  .given = offsetof (type, is_there))
#define QN_SEED(key, use, type, member) QN_MEMBER (key, SEED, use, type, member, 0, NULL)
#define QN_ROWS(name, when, most, columns, type, member, length)                         \
  QN_MEMBER_WITH (name, ROWS, when, type, member, most,                                  \
                  .count = offsetof (type, length), .width = columns)
#define QN_OBJECT(name, when, table, type, member)                                       \
  QN_MEMBER_WITH (name, OBJECT, when, type, member, 0, .members = table)
#define QN_LIST_OF(name, what, when, type, member, how, other)                           \
  QN_MEMBER_WITH (name, what, when, type, member, how, .refusal = other)
#define QN_WEIGHT(use, type)                                                             \
  QN_KNOWN ("density"), QN_MEMBER ("unit_weight", WEIGHT, use, type, unit_weight, 0, NULL)
#define QN_LAW(type)                                                                     \
  QN_KNOWN ("material"), QN_MEMBER ("law", LAW, OPTIONAL, type, law, 0, NULL)
#define QN_SUPPORT(type)                                                                 \
  QN_LIST_OF ("support", FLAGS, OPTIONAL, type, support, QN_DOF_COUNT,                   \
              N_ ("expected three values: ux, uy, rz fixed or not"))

/* Of projects, studies and results. */
#define QN_FORMAT_VERSION 1

/* Whether a document says that it is of this format and version; `refusal`: where it is of another. */
gboolean qn_read_format (const QnJsonValue *root, const char *format,
                         const char *refusal);

/* Reads an object; warns of keys that the table does not have. `model` may be NULL where no member
 * names an entity. FALSE with the reader's error set. */
gboolean qn_members_read (const QnJsonValue *object, const QnMember *members,
                          const QnModel *model, gpointer target);

/* The same in two steps, for an object with members of several tables: whether it is an object with
 * keys of these (the last two may be NULL), and the members of one. */
gboolean qn_members_check (const QnJsonValue *object, const QnMember *first,
                           const QnMember *second, const QnMember *third);
gboolean qn_members_take (const QnJsonValue *object, const QnMember *members,
                          const QnModel *model, gpointer target);

/* FALSE where an object has both members; the error is that of `key`. */
gboolean qn_members_exclude (const QnJsonValue *object, const char *key,
                             const char *other);

/* Appends the members to an object, without optional ones that are as in `usual`; NULL: without those that
 * name nothing. */
void qn_members_write (GString *json, const QnMember *members, const QnModel *model,
                       gconstpointer source, gconstpointer usual);

/* The same as an object, the member `key`. */
void qn_members_put (GString *json, const char *key, const QnMember *members,
                     const QnModel *model, gconstpointer source, gconstpointer usual);

/* A whole number from `least` on. */
gboolean qn_read_index (const QnJsonValue *place, int32_t least, int32_t *index);

/* Index of the entity whose name a value is; the same of a member: a missing optional one leaves *id
 * unchanged. */
gboolean qn_read_name_of (const QnJsonValue *place, const QnModel *model, QnNamed named,
                          QnId *id);
gboolean qn_read_name (const QnJsonValue *object, const char *key, QnNeed need,
                       const QnModel *model, QnNamed named, QnId *id);

/* ---- members that code writes ---- */

/* [x, y] as a member. */
void qn_json_put_vec2 (GString *json, const char *key, QnVec2 vector);

/* [[x, y], …] as a member. */
void qn_json_put_points (GString *json, const char *key, const QnVec2 *points,
                         gsize count);

/* A number, left out if it equals `usual`. */
void qn_json_put_unusual (GString *json, const char *key, double number, double usual);

/* [a, b, …], as a value or as a member. */
void qn_json_append_numbers (GString *json, const double *numbers, gsize count);
void qn_json_put_numbers (GString *json, const char *key, const double *numbers,
                          gsize count);

extern const char *const qn_placement_names[QN_PLACEMENT_COUNT];
extern const char *const qn_load_kind_names[QN_LOAD_KIND_COUNT];
extern const char *const qn_dispersal_names[QN_DISPERSAL_COUNT];
extern const char *const qn_earth_names[QN_EARTH_COUNT];
extern const char *const qn_procedure_names[QN_PROCEDURE_COUNT];
extern const char *const qn_bound_choice_names[QN_BOUND_CHOICE_COUNT];
extern const char *const qn_geometry_names[QN_GEOMETRY_COUNT];
extern const char *const qn_snap_names[QN_SNAP_THROUGH_COUNT];
extern const char *const qn_flow_names[QN_FLOW_COUNT];
extern const char *const qn_follow_names[2]; /* of contacts: that of false first */
