/* The picture behind a document's drawing: laid there, moved, scaled and taken away, each as a
 * step that can be undone. Where it is kept and shown: underlay.h, view-state.h. */
#pragma once

#include "doc/document/document.h"
#include "doc/document/underlay.h"
#include "render/drawing/camera.h"

/* Lays a picture behind the drawing, in place of the one that is there: over the width of the
 * drawing where there is one and of `view` otherwise, its foot at that of the drawing. Refused
 * where the file is no picture. */
gboolean qn_document_insert_picture (QnDocument *document, const char *path, QnBox view,
                                     GError **error);

/* Another place, size or opacity for the same picture; `name` and `key` as of
 * qn_document_edit(). */
gboolean qn_document_place_picture (QnDocument *document, const char *name,
                                    const char *key, const QnUnderlay *underlay,
                                    GError **error);

/* Takes the picture away; its file stays. */
gboolean qn_document_remove_picture (QnDocument *document, GError **error);

/* Before the document is saved as `path`: names the picture as seen from there. */
gboolean qn_document_carry_picture (QnDocument *document, const char *path,
                                    GError **error);

/* Path of a file that the project names, which the caller frees. NULL with QN_IO_ERROR_OUTSIDE where
 * it lies outside the project's folder and the user has not allowed it in this session. */
char *qn_document_dup_file (QnDocument *document, const char *file, GError **error);

/* The user allows this file, wherever it is, until the document is closed. */
void qn_document_allow_file (QnDocument *document, const char *file);

/* The same for the picture behind the drawing, if there is one. */
void qn_document_allow_picture (QnDocument *document);
