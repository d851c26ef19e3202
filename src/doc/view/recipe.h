/* Figure recipes: what a picture shows and where it goes, made again at any time, by the window and by the
 * command line alike: `figures` in data/project-format.md. */
#pragma once

#include "io/project/project.h"
#include "render/figure/figure.h"

typedef struct QnRecipe {
  char *name;   /* unique among the project's figures */
  char *file;   /* relative to the project's folder; NAME.png where the recipe has none */
  char *result; /* result file, relative to the project's folder, or NULL: solve again */
  char *title, *caption; /* or NULL: as the figure says by itself */
  char *digest; /* qn_model_digest() of the model that the figure was stored with, or
                   NULL */
  QnViewOptions view;
  QnOutput output;
} QnRecipe;

/* A recipe with the defaults of a view. */
QnRecipe *qn_recipe_new (const char *name, QnView view);
void qn_recipe_free (QnRecipe *recipe);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (QnRecipe, qn_recipe_free)

/* The project's recipes (of QnRecipe *, possibly none). On failure NULL with an error that
 * names file, line, column and key (QN_IO_ERROR). */
GPtrArray *qn_recipes_read (const QnProject *project, GError **error);

/* FALSE with an error where two of these recipes are the same file, so that one picture would take the
 * place of the other. `names` (nullable, NULL-terminated): only the recipes of these names. */
gboolean qn_recipes_check_files (const GPtrArray *recipes, const char *const *names,
                                 GError **error);

/* The value of `figures` as JSON text, for qn_document_edit_extra(). Values equal to their
 * defaults are left out. Free with g_free(). */
char *qn_recipes_to_json (const GPtrArray *recipes);

/* Whether the recipe needs a result to be drawn. */
bool qn_recipe_needs_result (const QnRecipe *recipe);

/* Fills a figure that borrows from everything given; `result` may be NULL. */
void qn_recipe_fill (const QnRecipe *recipe, const QnModel *model,
                     const QnContacts *contacts, const QnResult *result,
                     QnFigure *figure);

/* Whether the model is another than the one the figure was stored with. */
bool qn_recipe_is_stale (const QnRecipe *recipe, const QnProject *project);
