/* Forms made of a file ui/<name>.ui, with fields that are bound to values.
 *
 * The .ui file has the widgets with labels, limits and tooltips. A form lists the ids of those that
 * show or take something, says what each shows, and does with a new value what is to be done. The
 * rest is the same for all forms: they follow the document and the selection; a new value becomes
 * one step of the history; where it is refused the field says why. The context menu of a field whose
 * step would change one number of the file offers to vary it in a study.
 *
 * How widgets show a value: QnQuantityEntry its number; GtkDropDown, GtkListBox the row; check
 * buttons, switches, toggle buttons whether they are on; scales and spin buttons their number;
 * entries the text, labels too where there is one; a vertical box has a check for each row, and a bit of the number
 * says whether it is on. Plain buttons and lists call with no value but the row. What was typed into an entry is taken by Enter, and where it loses the focus. */
#pragma once

#include "app/canvas/canvas.h"
#include "doc/document/selection.h"
#include "doc/masonry/masonry-field.h"

/* What a field shows, or what the user has entered. Zeroed to begin with. */
typedef struct QnValue {
  double number; /* in SI; row of a choice or a list, -1 for none; 1 for on */
  char *text;    /* owned */
  char **rows;   /* of a choice or a list, anew; owned; NULL: as they are in the file */
  guint row_count;
  const char *
    *icons; /* of the rows of a list; owned, the names are not; NULL: they have none */
  gboolean mixed;    /* a check or number that is not the same for all that is selected */
  gboolean disabled; /* shown, but not to be used now */
} QnValue;

/* The number as a whole one, of 0 or more; as a row, and whether it is on. */
int qn_value_int (const QnValue *value);

/* One more row of a choice or a list; `row` is taken over, or copied. */
void qn_value_take_row (QnValue *value, char *row);
void qn_value_add_row (QnValue *value, const char *row);
/* The icon of the last row; every row has one, or none has. */
void qn_value_set_icon (QnValue *value, const char *icon);

/* Names of laws as rows, with `first` (nullable) before them for none, and the row of `law`; the law
 * of such a row. */
void qn_value_set_laws (QnValue *value, const QnModel *model, const char *first,
                        QnId law);
QnId qn_value_get_law (const QnValue *value);

/* Names of sections likewise, without a row for none. */
void qn_value_set_sections (QnValue *value, const QnModel *model, QnId section);

/* What a field shows of where pairs lie on a face of a law; FALSE where the rule has no such number. */
typedef enum {
  QN_PAIRS_PLACEMENT,
  QN_PAIRS_OFFSET,
  QN_PAIRS_COUNT,
  QN_PAIRS_POSITIONS,
  QN_PAIRS_WEIGHTS
} QnPairField;
gboolean qn_value_set_pairs (QnValue *value, const QnModel *model, const QnPairRule *rule,
                             QnId law, QnPairField field);

/* Frees what it holds. */
void qn_value_clear (QnValue *value);

typedef struct QnFormField {
  const char *id; /* in the .ui file */
  /* Name of the undo step, to be translated; "%s" in it stands for the label of the row. NULL: a new
   * value is the form's own and changes no document. */
  const char *step;
  /* The member of the form's subject that it shows and changes, told apart by its size: a double, a flag
   * (bool), a whole number or a choice (int, enumeration); size 0: none. A text (char *) is shown alone: the
   * form takes it, for names may be refused. */
  gsize offset, size;
  gboolean is_text;
} QnFormField;

/* A source lists its fields once, in a macro FIELDS (FIELD, MEMBER) of lines FIELD (NUMBER, "id", step) and
 * MEMBER (NUMBER, "id", step, type, member). Of it this makes their numbers, behind them FIELD_COUNT, and
 * the array `fields`. */
#define QN_FORM_FIELDS                                                                   \
  enum { FIELDS (QN_FIELD_NUMBER, QN_MEMBER_NUMBER) FIELD_COUNT };                       \
  static const QnFormField fields[] = { FIELDS (QN_FIELD_ROW, QN_MEMBER_ROW) }
#define QN_FIELD_NUMBER(number, id, step)                number,
#define QN_MEMBER_NUMBER(number, id, step, type, member) number,
#define QN_FIELD_ROW(number, id, step)                   { id, step, 0, 0, FALSE },
#define QN_MEMBER_ROW(number, id, step, type, member)                                    \
  { id, step, offsetof (type, member), sizeof ((type *) NULL)->member,                   \
    _Generic (((type *) NULL)->member, char *: TRUE, default: FALSE) },

/* The list of a form whose subject is the selected item of an array of the model. Of it `show` and `take`
 * hear nothing. */
typedef struct QnFormList {
  guint list,
    empty; /* fields: of the list, of the label that is there instead where it has no items */
  gsize items, count; /* members of QnModel */
  gsize size;         /* of an item */
  /* Empty: the item has no row of its own. */
  char *(*dup_row) (const QnModel *model, gsize index);
  QnPickKind
    kind; /* the selected one is the selection's of this kind; NOTHING: the form has its own */
} QnFormList;

#define QN_FORM_LIST(list, empty, array, number, row, kind)                              \
  {                                                                                      \
    list, empty, offsetof (QnModel, array), offsetof (QnModel, number),                  \
      sizeof *((QnModel *) NULL)->array, row, kind                                       \
  }

typedef struct QnForm QnForm;

typedef enum {
  QN_FOLLOW_SELECTION = 1 << 0,
  QN_FOLLOW_RUNS = 1 << 1, /* and the analysis that runs */
  QN_FOLLOW_VIEW = 1 << 2, /* what the view state shows, such as the step */
  QN_FOLLOW_TOOL = 1 << 3
} QnFollow;

typedef struct QnFormKind {
  const char *name; /* of the file */
  gsize size;       /* of the struct that begins with a QnForm */
  const QnFormField *fields;
  guint field_count;
  /* Numbers behind these fields, each with a row in the box "rows" of the file: how many, and what they are. */
  guint row_count;
  QnFieldInfo (*row_info) (guint row);
  const QnFormList *list;       /* or NULL */
  QnFollow follows;             /* besides the model */
  void (*init) (QnForm *form);  /* NULL, or fills the struct before anything is shown */
  void (*clear) (QnForm *form); /* NULL, or frees what it holds */
  /* `model` is the one that a step changes, or else the document's, which stays; NULL in dialogs. */
  /* Looks at what the form is about; FALSE: nothing, the form hides. NULL: always shown. */
  gboolean (*look) (QnForm *form, const QnModel *model);
  /* The struct of the members that fields have; NULL: there is none, as where nothing is selected. Without
   * this, the item of the list, or where there is none the form itself. */
  gpointer (*subject) (QnForm *form, QnModel *model, guint field);
  /* What a field shows, its member already; FALSE: its row hides. */
  gboolean (*show) (QnForm *form, const QnModel *model, guint field, QnValue *value);
  /* Takes a new value, which its member has already, into the model, or, for fields without a step, into the
   * form. FALSE with an error refuses it; without one it is silently as before. */
  gboolean (*take) (QnForm *form, QnModel *model, guint field, const QnValue *value,
                    GError **error);
} QnFormKind;

/* One with the functions `show`, `take` and the array `fields` of its source, and with what else is given. */
#define QN_FORM_KIND(file, type, ...)                                                    \
  {                                                                                      \
    .name = file, .size = sizeof (type), .fields = fields,                               \
    .field_count = G_N_ELEMENTS (fields), .show = show, .take = take, __VA_ARGS__        \
  }

struct QnForm {
  const QnFormKind *kind;
  QnCanvas *canvas;  /* NULL in dialogs */
  GtkWidget *root;   /* "form" of the .ui file */
  GtkExpander *card; /* that the form lies in, or NULL */
  GtkWidget **widgets;
  QnPartSet parts;      /* the selected blocks and beams, of the canvas */
  int selected;         /* item of the list; -1: none */
  int wanted;           /* to be selected once an edit has added it; -1: none */
  const char *told;     /* once the step is made; NULL: nothing */
  QnProject *draft;     /* that a step changes, while it does */
  const QnValue *taken; /* the value that it takes, of the field … */
  guint taken_field;
  gboolean showing; /* values are being shown: nobody has entered them */
  gboolean closed;  /* its widgets are gone; work that has not ended keeps the struct */
  guint frames;     /* that it takes to bring the form into view, so far; 0: it stays */
};

/* A form of that kind; its root, of which it is the object data, as of its fields, keeps the struct, as does
 * whoever g_rc_box_acquire()s it. `canvas` is NULL for dialogs, whose fields have no steps. Shows nothing before qn_form_show(). */
#define QN_FORM "qn-form"
gpointer qn_form_new (const QnFormKind *kind, QnCanvas *canvas);
void qn_form_unref (gpointer form);

/* Makes all fields show their values. Returns the root. */
GtkWidget *qn_form_show (gpointer form);

/* Unfolds a form and brings it into view, because what it is about was chosen elsewhere; where the
 * focus is in it, it is in view already. */
void qn_form_reveal (gpointer form);

/* The selected item of its list, in `model`; NULL: there is none. */
gpointer qn_form_item (gconstpointer form, const QnModel *model);

/* As entered by the user: the number of a field, or its text; while a step takes a value, that. */
double qn_form_get_number (gpointer form, guint field);
char *qn_form_dup_text (gpointer form, guint field); /* the caller frees it */
