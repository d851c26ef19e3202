/* Names of outputs for readers; files have keys (collapse_multiplier, overturning). */
#pragma once

#include "study/plan/study.h"

/* Name with its unit, translated: "Largest displacement (m)". */
const char *qn_study_output_text (QnStudyOutput output);

/* The word for an outcome or kind of mechanism, translated; `name` itself where it is neither. */
const char *qn_study_word (const char *name);
