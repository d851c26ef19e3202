/* A study of one block that slides at its friction, in a folder of its own. */
#pragma once

#include "study/plan/study.h"
#include "support/scratch.h"

/* Two parameters, friction and weight (independent, uniform), `plan` as JSON, and what stands
 * before the last brace. The model is examples/01-sliding-block.quoin. */
char *fixture_study_text (const char *plan, const char *more);

/* Reads a text as a study file in `folder`; the error where it is none. */
gboolean fixture_read (const char *folder, const char *text, QnStudy *study,
                       GError **error);

/* The study of fixture_study_text(); fails where it does not read. */
void fixture_study (QnStudy *study, const char *plan, const char *more);
