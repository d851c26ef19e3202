/* Names of outputs for readers; files have keys (collapse_multiplier, overturning). */
#pragma once

#include "study/plan/study.h"

/* Name with its unit, translated: "Largest displacement (m)". */
const char *qn_study_output_text (QnStudyOutput output);

/* The word for a kind of mechanism, translated; `kind` itself where it is none that is known. */
const char *qn_study_mechanism_text (const char *kind);
