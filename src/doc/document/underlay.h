/* The photo or survey behind a structure, as the project keeps it: `underlay` in data/project-format.md.
 * Where it was taken at an angle it is shown as seen from the front (render/drawing/rectify.h). */
#pragma once

#include "doc/document/document.h"
#include "io/project/project.h"
#include "render/scene/view-options.h"

/* Fills the underlay with the project's; the image is owned by the caller
 * (cairo_surface_destroy) and NULL where the project has none. FALSE with an error that names
 * the key (QN_IO_ERROR) or the file (QN_RENDER_ERROR; QN_IO_ERROR_OUTSIDE where it lies outside the
 * project's folder and that is not allowed). */
gboolean qn_underlay_read (const QnProject *project, gboolean allow_outside,
                           QnUnderlay *underlay, GError **error);

/* The same of a document; files outside its folder are those that the user has allowed. */
gboolean qn_document_read_picture (QnDocument *document, QnUnderlay *underlay,
                                   GError **error);

/* The same as qn_underlay_read() without the image: its path, owned by the caller, or NULL where the project has no
 * underlay. `folder` (nullable) is what a relative path starts from. */
gboolean qn_underlay_locate (const QnProject *project, const char *folder, char **path,
                             QnUnderlay *underlay, GError **error);

/* The value of `underlay` as JSON text, for qn_document_edit_extra(). Free with g_free(). */
char *qn_underlay_to_json (const char *image, const QnUnderlay *underlay);

/* Moves, turns and scales the underlay so that two places on it, given where they are shown
 * now, come to lie on two model points: scaling by two picked points. False where the places
 * or the points coincide. */
bool qn_underlay_match (QnUnderlay *underlay, const QnVec2 shown[2],
                        const QnVec2 wanted[2]);

/* Rectifies the underlay by four places on it, given where they are shown now: they become the corners
 * of an upright rectangle of this width and height, m, whose lower left one stays where it is. False
 * where they are no corners of a convex quadrilateral, or beyond the photo's horizon. */
bool qn_underlay_rectify (QnUnderlay *underlay, const QnVec2 shown[4], double width,
                          double height);

/* Shows the photo as it was taken again, so wide that the foot of the rectangle on it keeps its length. */
void qn_underlay_show_as_taken (QnUnderlay *underlay);

/* Lays a picture behind the drawing, in place of the one that is there: over the width of the
 * drawing, its foot at that of the drawing; 5 m wide from the origin on where nothing is drawn.
 * Refused where the file is no picture. */
gboolean qn_document_insert_picture (QnDocument *document, const char *path,
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
