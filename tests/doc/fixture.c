#include "fixture.h"

#include <string.h>

QnDocument *
open_example (const char *name)
{
  g_autofree char *path = g_build_filename (g_getenv ("QUOIN_EXAMPLES"), name, NULL);
  QnDocument *document = qn_document_new ();
  g_autoptr (GError) error = NULL;
  qn_document_load (document, path, &error);
  g_assert_no_error (error);
  return document;
}

QnDocument *
open_text (const char *text)
{
  QnDocument *document = qn_document_new ();
  g_autoptr (GError) error = NULL;
  qn_document_load_recovered (document, text, NULL, &error);
  g_assert_no_error (error);
  return document;
}

/* ---- a state against its text ---- */

static void
compare_loads (const QnLoad *a, const QnLoad *b, gsize count)
{
  for (gsize i = 0; i < count; i++) {
    g_assert_cmpint (a[i].kind, ==, b[i].kind);
    g_assert_cmpint (a[i].set, ==, b[i].set);
    if (a[i].kind == QN_LOAD_FORCE || a[i].kind == QN_LOAD_SETTLEMENT)
      g_assert_cmpint (a[i].block, ==, b[i].block);
    if (a[i].kind == QN_LOAD_NODE)
      g_assert_cmpint (a[i].node, ==, b[i].node);
    if (a[i].kind == QN_LOAD_LINE)
      g_assert_cmpint (a[i].beam, ==, b[i].beam);
  }
}

static void
compare_blocks (const QnModel *a, const QnModel *b)
{
  g_assert_cmpuint (a->block_count, ==, b->block_count);
  for (gsize i = 0; i < a->block_count; i++) {
    const QnBlock *x = &a->blocks[i], *y = &b->blocks[i];
    g_assert_cmpstr (x->name, ==, y->name);
    g_assert_cmpint (x->wall, ==, y->wall);
    g_assert_cmpint (x->masonry, ==, y->masonry);
    g_assert_cmpint (x->law, ==, y->law);
    g_assert_cmpint (x->vertex_count, ==, y->vertex_count);
    g_assert_cmpfloat (x->thickness, ==, y->thickness);
    g_assert_cmpfloat (x->weight, ==, y->weight);
    g_assert_cmpfloat (x->centroid.x, ==, y->centroid.x);
    g_assert_cmpfloat (x->centroid.y, ==, y->centroid.y);
    g_assert_cmpfloat (x->polar_moment, ==, y->polar_moment);
    g_assert_cmpmem (x->support, sizeof x->support, y->support, sizeof y->support);
    g_assert_cmpmem (
      qn_model_block_vertices (a, (QnId) i), (gsize) x->vertex_count * sizeof (QnVec2),
      qn_model_block_vertices (b, (QnId) i), (gsize) y->vertex_count * sizeof (QnVec2));
  }
}

static void
compare_beams (const QnModel *a, const QnModel *b)
{
  g_assert_cmpuint (a->node_count, ==, b->node_count);
  g_assert_cmpuint (a->beam_count, ==, b->beam_count);
  g_assert_cmpuint (a->element_count, ==, b->element_count);
  g_assert_cmpuint (a->section_count, ==, b->section_count);
  for (gsize i = 0; i < a->node_count; i++) {
    g_assert_cmpstr (a->nodes[i].name, ==, b->nodes[i].name);
    g_assert_cmpint (a->nodes[i].block, ==, b->nodes[i].block);
    g_assert_cmpfloat (a->nodes[i].at.x, ==, b->nodes[i].at.x);
    g_assert_cmpfloat (a->nodes[i].at.y, ==, b->nodes[i].at.y);
  }
  for (gsize i = 0; i < a->beam_count; i++) {
    g_assert_cmpint (a->beams[i].section, ==, b->beams[i].section);
    g_assert_cmpint (a->beams[i].nodes[0], ==, b->beams[i].nodes[0]);
    g_assert_cmpint (a->beams[i].nodes[1], ==, b->beams[i].nodes[1]);
  }
  for (gsize i = 0; i < a->section_count; i++) {
    g_assert_cmpfloat (a->sections[i].area, ==, b->sections[i].area);
    g_assert_cmpfloat (a->sections[i].unit_weight, ==, b->sections[i].unit_weight);
  }
}

static void
compare_rest (const QnModel *a, const QnModel *b)
{
  g_assert_cmpuint (a->wall_count, ==, b->wall_count);
  g_assert_cmpuint (a->law_count, ==, b->law_count);
  g_assert_cmpuint (a->override_count, ==, b->override_count);
  g_assert_cmpuint (a->bar_count, ==, b->bar_count);
  g_assert_cmpuint (a->dead_load_count, ==, b->dead_load_count);
  g_assert_cmpuint (a->live_load_count, ==, b->live_load_count);
  g_assert_cmpuint (a->load_set_count, ==, b->load_set_count);
  g_assert_cmpuint (a->stage_count, ==, b->stage_count);
  g_assert_cmpfloat (a->characteristic_length, ==, b->characteristic_length);
  g_assert_cmpint (a->contact.law, ==, b->contact.law);
  g_assert_cmpint (a->analysis.control.block, ==, b->analysis.control.block);
  g_assert_cmpint (a->analysis.control.node, ==, b->analysis.control.node);
  compare_loads (a->dead_loads, b->dead_loads, a->dead_load_count);
  compare_loads (a->live_loads, b->live_loads, a->live_load_count);
  for (gsize i = 0; i < a->override_count; i++) {
    g_assert_cmpint (a->overrides[i].block_a, ==, b->overrides[i].block_a);
    g_assert_cmpint (a->overrides[i].block_b, ==, b->overrides[i].block_b);
    g_assert_cmpint (a->overrides[i].law, ==, b->overrides[i].law);
  }
  for (gsize i = 0; i < a->stage_count; i++) {
    g_assert_cmpuint (a->stages[i].sets, ==, b->stages[i].sets);
    g_assert_cmpint (a->stages[i].control.block, ==, b->stages[i].control.block);
    g_assert_cmpint (a->stages[i].control.node, ==, b->stages[i].control.node);
  }
}

void
check_state (QnDocument *document)
{
  const char *text = document->text->text;
  const QnProject *state = qn_document_get_project (document);
  g_autoptr (GError) error = NULL;
  g_auto (QnProject) read;
  qn_project_parse (text, strlen (text), "text", NULL, &read, &error);
  g_assert_no_error (error);
  g_autofree char *again = qn_project_to_text (&read, NULL);
  g_assert_cmpstr (again, ==, text);
  g_autofree char *whole = qn_project_to_text (state, NULL);
  g_assert_cmpstr (whole, ==, text);
  compare_blocks (&state->model, &read.model);
  compare_beams (&state->model, &read.model);
  compare_rest (&state->model, &read.model);
}

const QnModel *
edit (QnDocument *document, ModelEdit func, gconstpointer data)
{
  g_autofree char *before = g_strdup (document->text->text);
  g_autoptr (GError) error = NULL;
  edit_model (document, "edit", NULL, func, (gpointer) data, &error);
  g_assert_no_error (error);
  check_state (document);
  g_autofree char *after = g_strdup (document->text->text);
  if (strcmp (before, after) != 0) {
    g_assert_true (qn_document_undo (document));
    g_assert_cmpstr (document->text->text, ==, before);
    g_assert_true (qn_document_redo (document));
    g_assert_cmpstr (document->text->text, ==, after);
  }
  return &document->project.model;
}

void
refuse (QnDocument *document, ModelEdit func, gconstpointer data)
{
  g_autofree char *before = g_strdup (document->text->text);
  g_autoptr (GError) error = NULL;
  g_assert_false (edit_model (document, "edit", NULL, func, (gpointer) data, &error));
  g_assert_nonnull (error);
  g_assert_cmpstr (document->text->text, ==, before);
}

void
wait_for_job (QnDocument *document)
{
  while (document->job != NULL)
    g_main_context_iteration (NULL, TRUE);
}

QnRun *
solve_example (QnDocument *document)
{
  g_autoptr (GError) error = NULL;
  qn_document_analyse (document, &error);
  g_assert_no_error (error);
  wait_for_job (document);
  g_assert_no_error (document->job_error);
  return document->run;
}
