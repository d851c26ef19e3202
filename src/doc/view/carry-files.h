/* The files that a project names by relative paths go with it when it is saved elsewhere. */
#pragma once

#include "doc/document/document.h"

/* Before the document is saved as `path`: copies records of ground motion and results of figures
 * into the new folder, and the picture of a document that was opened as a copy; other pictures are
 * named as seen from there. FALSE with an error where a file of the name is there that says
 * something else: nothing is written over. */
gboolean qn_document_carry_files (QnDocument *document, const char *path, GError **error);
