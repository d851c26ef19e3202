/* What tells one model from another. */
#pragma once

#include "io/project/project.h"

/* Digest of the model and its settings alone, hexadecimal: neither the title nor views and
 * figures make a result or a figure stale. Free with g_free(). */
char *qn_model_digest (const QnProject *project);

/* The same, quicker where the project's text is at hand. */
char *qn_model_digest_like (const QnProject *project, const QnProjectText *text);

/* The same without the settings of the analysis. */
char *qn_structure_digest_like (const QnProject *project, const QnProjectText *text);
