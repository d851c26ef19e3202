/* One structure of the scaling benchmark, and what is measured on it. */
#pragma once

#include "core/contact/contacts.h"
#include "core/model/model.h"

#include <glib.h>

/* Processor time that the parts may take, s, and how the path is led. */
typedef struct ScalingLimits {
  double path, limit, peers;
  QnProcedure procedure;
} ScalingLimits;

/* What one part took; NAN where it was not run. */
typedef struct ScalingPart {
  gboolean done; /* it ended, and not because its time was over */
  const char *outcome;
  double seconds, kernels, megabytes, multiplier;
  int factorizations;
} ScalingPart;

typedef struct ScalingCase {
  const char *kind;
  QnModel model;
  QnContacts contacts;
  size_t blocks, faces; /* without the base */
  double factorization; /* s, of the elastic stiffness matrix */
  double first_limit;   /* multiplier, of the path */
  ScalingPart detection, elastic, limit, path, clp, highs;
} ScalingCase;

/* About `blocks` blocks, as wide as high; a façade has an opening for every 60 of them. */
void scaling_case_init (ScalingCase *c, int blocks, gboolean facade);
void scaling_case_clear (ScalingCase *c);

/* Contact detection; first of all. */
void scaling_case_detect (ScalingCase *c);

/* The displacements under the dead load with every joint stuck, from nothing: numbering, pattern,
 * ordering, tangent, factorisation, solution. */
void scaling_case_elastic (ScalingCase *c);

void scaling_case_limit (ScalingCase *c, const ScalingLimits *limits);
void scaling_case_path (ScalingCase *c, const ScalingLimits *limits);

/* The best methods of Clp and of HiGHS on the linear program of limit analysis, whose optimum must be
 * the same to 1e-6; methods that do not end in time do not count. What is not there is not run. */
void scaling_case_peers (ScalingCase *c, const ScalingLimits *limits);
