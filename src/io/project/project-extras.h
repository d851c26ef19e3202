/* Top-level members of a project file that the model does not hold (view, figures, …). */
#pragma once

#include "io/json/json-value.h"
#include "io/project/project.h"

/* A reader of these members: its messages name the project's file, line and column; warnings are
 * not kept. */
QnReader qn_project_reader (const QnProject *project);

/* The members of `project` with one replaced or, where `json` is NULL, removed, as an object
 * that the caller owns (cJSON_Delete). Not changed itself, `project` may share its parts with
 * others. NULL with an error in the domain QN_IO_ERROR where `json` is not JSON. */
cJSON *qn_project_extras_with (const QnProject *project, const char *member,
                               const char *json, GError **error);
void qn_project_extras_free (cJSON *extras);

/* Value of a member as JSON text, or NULL. Free with g_free(). */
char *qn_project_dup_extra (const QnProject *project, const char *member);
