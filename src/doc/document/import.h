/* Drawings of other programs taken into a document, as one step that can be undone. */
#pragma once

#include "doc/document/document.h"

/* Takes over what was imported: an empty drawing becomes it, with its laws and loads; to
 * another its blocks are added, with their supports and names where these are free, and get the
 * joints of the drawing. Refused, with the reason, where it would not be a valid model. `step`: its
 * name, NULL: that of an import. */
gboolean qn_document_import (QnDocument *document, const char *step,
                             const QnProject *imported, GError **error);

/* How long the ending of a path is that is one of these, in small letters; 0: it has none. */
gsize qn_ending_of (const char *path, const char *const *endings);

/* Whether the program imports a file of that name, rather than opening it. */
gboolean qn_import_knows_file (const char *path);

/* Whether it is a picture that can lie behind a drawing. */
gboolean qn_import_is_picture (const char *path);
