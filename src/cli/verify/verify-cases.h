/* The published and exact values that "quoin-cli verify" holds the program against.
 *
 * The models are the files of examples/, compiled into the program, so that it can be verified
 * wherever it is installed. */
#pragma once

#include "core/base/base.h"

#include <glib.h>

/* Prefix of the resources that hold the models. */
#define QN_VERIFY_RESOURCES "/io/github/quoin/verify/"

/* What a case compares. */
typedef enum {
  QN_VERIFY_COLLAPSE, /* the collapse multiplier */
  QN_VERIFY_DISPLACEMENT, /* of `block`, or a node of that name, component `dof`, at the end of stage `number` */
  QN_VERIFY_MULTIPLIER, /* at the end of stage `number` */
  QN_VERIFY_REACTION,   /* of the support `block`, component `dof`, at the last step */
  QN_VERIFY_CRITICAL,   /* the multiplier at which stability is lost */
  QN_VERIFY_FREQUENCY,  /* of mode `number`, rad/s */
  QN_VERIFY_BRANCH /* the multiplier where the upper right corner of `block` has moved by
                           `at` m along x for the first time */
} QnVerifyQuantity;

typedef struct QnVerifyCase {
  const char *name;  /* what the table calls it; translatable */
  const char *model; /* file below examples/ */
  double reference;  /* to be met */
  double
    tolerance;  /* relative to the reference, or to `scale`; INFINITY: only reported */
  double paper; /* what the paper's own HybriDFEM gives; 0 where it has no value */
  const char *block;
  QnVerifyQuantity quantity;
  QnDof dof;
  int number;   /* of a stage or mode, from 1; 0: the last step */
  double scale; /* what errors are relative to; 0: the reference */
  double at;
} QnVerifyCase;

typedef struct QnVerifyGroup {
  const char *name;         /* as on the command line */
  const char *title;        /* translatable */
  const char *source;       /* of the reference values; translatable */
  const char *overrides[4]; /* NULL-terminated "path=value" for all its models */
  const QnVerifyCase *cases;
  gsize case_count;
  gboolean bounded; /* whether the associative limit analysis is computed beside */
} QnVerifyGroup;

/* All groups; their number in *count. A static array. */
const QnVerifyGroup *qn_verify_groups (gsize *count);
