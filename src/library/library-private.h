/* Private to the library: what its files share. */
#pragma once

#include "io/project/project.h"
#include "io/result/result-file.h"
#include "library/quoin.h"

struct QuoinModel {
  gatomicrefcount references;
  QnProject project;
  QnContacts contacts;
  GPtrArray *warnings; /* of char *: of the file, then of detection */
  GError
    *unread; /* why the records of an analysis in time are not there; NULL: they are */
};

struct QuoinResult {
  gatomicrefcount references;
  QuoinModel *model;
  QnResult result;
  double *multipliers; /* steps */
  double *forces;      /* pairs x 2, last step */
  char *name;          /* of its file, without folders, or "result" */
  bool changed;        /* read of a file whose project had other bytes */
};

QuoinResult *quoin_library_result_ref (QuoinResult *result);

/* A function that tells a value of an object `of`, or `none` where there is no object; and the same of an
 * item of one of its lists. */
#define QUOIN_GET(type, name, Object, none, value)                                       \
  type name (const Object *of)                                                           \
  {                                                                                      \
    return of != NULL ? (value) : (none);                                                \
  }
#define QUOIN_GET_ITEM(type, name, Object, count, none, value)                           \
  type name (const Object *of, size_t item)                                              \
  {                                                                                      \
    return of != NULL && item < (size_t) (count) ? (value) : (none);                     \
  }

/* A caller's callback as the core's, and what it has been told last. */
typedef struct QuoinCaller {
  QuoinProgressFunc func; /* or NULL */
  void *data;
  const QnModel *model; /* of an analysis */
  const char *all;      /* what the whole analysis is of; NULL: its parts are told */
  int calls;
  double done, reached; /* 0 to 1; multiplier, or s */
  int32_t steps;
  const char *what;
  bool cancelled; /* it has returned false */
} QuoinCaller;

/* Calls it; false cancels. */
bool quoin_library_tell (QuoinCaller *caller, double done, int32_t iterations);

/* False, with an error, where an argument that must be given is NULL. */
bool quoin_library_given (const void *argument, const char *name, QuoinError **error);

G_DEFINE_AUTOPTR_CLEANUP_FUNC (QuoinModel, quoin_model_unref)
G_DEFINE_AUTOPTR_CLEANUP_FUNC (QuoinFigure, quoin_figure_free)
G_DEFINE_AUTOPTR_CLEANUP_FUNC (QuoinModes, quoin_modes_free)

/* Each sets *error (nullable) unless it is set already, and returns NULL. The first takes the GError; `name`
 * (nullable) is the file that its message may begin with. */
void *quoin_library_take_error (QuoinError **error, const char *name, GError *cause);
void *quoin_library_take_diag (QuoinError **error, const QnProject *project,
                               const QnDiag *diag);
void *quoin_library_set_error (QuoinError **error, QuoinErrorKind kind,
                               const char *format, ...) G_GNUC_PRINTF (3, 4);

/* The model of the same text with more overrides, before and after its own; both nullable. */
QuoinModel *quoin_library_model_with (const QuoinModel *model, const char *const *before,
                                      const char *const *after, QuoinError **error);
