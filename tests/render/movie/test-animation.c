#include "render/backend/offscreen.h"
#include "render/fixture.h"
#include "render/movie/animation.h"
#include "support/room.h"

#include <gif_lib.h>
#include <glib/gstdio.h>
#include <string.h>

typedef struct Rig {
  Fixture fixture;
  QnAnimation animation;
  QnOutput output;
  QnMetadata metadata;
  char *folder;
} Rig;

static void
rig_init (Rig *rig, QnView view)
{
  fixture_init_wall (&rig->fixture, 3, 4);
  qn_animation_init (&rig->animation, &rig->fixture.model, &rig->fixture.contacts,
                     &rig->fixture.result, view);
  rig->animation.frames = 6;
  qn_output_init (&rig->output);
  rig->output.width = 240;
  rig->output.height = 180;
  qn_metadata_init (&rig->metadata);
  rig->folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
}

/* The folder must be empty by now: nothing was left behind. */
static void
rig_clear (Rig *rig)
{
  g_assert_cmpint (g_rmdir (rig->folder), ==, 0);
  g_free (rig->folder);
  fixture_clear (&rig->fixture);
}

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (Rig, rig_clear)

static void
test_gif (void)
{
  for (int view = QN_VIEW_DEFORMED; view <= QN_VIEW_MECHANISM; view++) {
    g_auto (Rig) rig;
    GError *error = NULL;
    int code;
    rig_init (&rig, (QnView) view);
    g_autofree char *path = g_build_filename (rig.folder, "a.gif", NULL);
    g_assert_true (
      qn_animation_export (&rig.animation, path, &rig.output, &rig.metadata, &error));
    g_assert_no_error (error);

    GifFileType *gif = DGifOpenFileName (path, &code);
    g_assert_nonnull (gif);
    g_assert_cmpint (DGifSlurp (gif), ==, GIF_OK);
    g_assert_cmpint (gif->ImageCount, ==, 6);
    g_assert_cmpint (gif->SWidth, ==, 240);
    g_assert_cmpint (gif->SHeight, ==, 180);
    /* The ground is exactly white. */
    GifColorType ground = gif->SColorMap->Colors[gif->SavedImages[0].RasterBits[0]];
    g_assert_cmpint (ground.Red, ==, 255);
    g_assert_cmpint (ground.Green, ==, 255);
    g_assert_cmpint (ground.Blue, ==, 255);
    DGifCloseFile (gif, &code);
    g_unlink (path);
  }
}

static void
test_gif_is_repeatable (void)
{
  g_auto (Rig) rig;
  GError *error = NULL;
  char *contents[2] = { NULL, NULL };
  gsize lengths[2];
  rig_init (&rig, QN_VIEW_MECHANISM);
  g_autofree char *path = g_build_filename (rig.folder, "a.gif", NULL);
  for (int i = 0; i < 2; i++) {
    g_assert_true (
      qn_animation_export (&rig.animation, path, &rig.output, &rig.metadata, &error));
    g_assert_true (g_file_get_contents (path, &contents[i], &lengths[i], NULL));
  }
  g_assert_cmpmem (contents[0], lengths[0], contents[1], lengths[1]);
  g_free (contents[0]);
  g_free (contents[1]);
  g_unlink (path);
}

static void
test_frames (void)
{
  g_auto (Rig) rig;
  GError *error = NULL;
  rig_init (&rig, QN_VIEW_MECHANISM);
  g_autofree char *inner = g_build_filename (rig.folder, "new", NULL);
  g_autofree char *path = g_strconcat (inner, "/", NULL);
  rig.animation.once = true;
  g_assert_true (
    qn_animation_export (&rig.animation, path, &rig.output, &rig.metadata, &error));
  g_assert_no_error (error);
  for (int i = 1; i <= 6; i++) {
    g_autofree char *name = g_strdup_printf ("%s/frame-%04d.png", inner, i);
    g_autofree char *content = NULL;
    g_assert_true (g_file_get_contents (name, &content, NULL, NULL));
    g_assert_cmpint (strncmp (content, "\x89PNG", 4), ==, 0);
    g_assert_cmpint (g_unlink (name), ==, 0);
  }
  g_assert_cmpint (g_rmdir (inner), ==, 0);
}

/* A mechanism swings out and back; a path goes on from its first step to its last. */
static void
test_order_of_frames (void)
{
  for (int view = QN_VIEW_DEFORMED; view <= QN_VIEW_MECHANISM; view++) {
    g_auto (Rig) rig;
    char *contents[6];
    gsize lengths[6];
    rig_init (&rig, (QnView) view);
    g_autofree char *path = g_strconcat (rig.folder, "/frames/", NULL);
    g_assert_true (
      qn_animation_export (&rig.animation, path, &rig.output, &rig.metadata, NULL));
    for (int i = 0; i < 6; i++) {
      g_autofree char *name = g_strdup_printf ("%sframe-%04d.png", path, i + 1);
      g_assert_true (g_file_get_contents (name, &contents[i], &lengths[i], NULL));
      g_assert_cmpint (g_unlink (name), ==, 0);
    }
    GBytes *second = g_bytes_new_take (contents[1], lengths[1]);
    GBytes *third = g_bytes_new_take (contents[2], lengths[2]);
    GBytes *sixth = g_bytes_new_take (contents[5], lengths[5]);
    g_assert_false (g_bytes_equal (second, third));
    g_assert_cmpint (g_bytes_equal (second, sixth), ==, view == QN_VIEW_MECHANISM);
    g_bytes_unref (second);
    g_bytes_unref (third);
    g_bytes_unref (sixth);
    g_free (contents[0]);
    g_free (contents[3]);
    g_free (contents[4]);
    g_assert_cmpint (g_rmdir (path), ==, 0);
  }
}

/* A picture shows the step that is nearest to its place along the curve: of three steps at 0, 1/2 and 1 the
 * second picture of three is that of the second step, the fourth of five the one of the third. */
static void
test_nearest_step (void)
{
  for (int frames = 3; frames <= 5; frames += 2) {
    g_auto (Rig) rig;
    GBytes *pictures[5];
    rig_init (&rig, QN_VIEW_DEFORMED);
    QnResult *result = &rig.fixture.result;
    result->step_count = 3;
    for (int s = 0; s < 3; s++) {
      double *u = result->displacements + (size_t) s * result->block_count * QN_DOF_COUNT;
      result->steps[s] = (QnStep){ .multiplier = 0.1 * s };
      for (size_t i = 0; i < result->block_count * QN_DOF_COUNT; i++)
        u[i] = 5e-4 * s * result->mechanism[i];
    }
    rig.animation.frames = frames;
    rig.animation.curve = false;
    g_autofree char *path = g_strconcat (rig.folder, "/frames/", NULL);
    g_assert_true (
      qn_animation_export (&rig.animation, path, &rig.output, &rig.metadata, NULL));
    for (int i = 0; i < frames; i++) {
      g_autofree char *name = g_strdup_printf ("%sframe-%04d.png", path, i + 1);
      char *content;
      gsize length;
      g_assert_true (g_file_get_contents (name, &content, &length, NULL));
      pictures[i] = g_bytes_new_take (content, length);
      g_assert_cmpint (g_unlink (name), ==, 0);
    }
    int middle = (frames - 1) / 2;
    g_assert_false (g_bytes_equal (pictures[0], pictures[middle]));
    g_assert_false (g_bytes_equal (pictures[middle], pictures[frames - 1]));
    for (int i = 0; i < frames; i++)
      g_bytes_unref (pictures[i]);
    g_assert_cmpint (g_rmdir (path), ==, 0);
  }
}

/* All frames of an animation are drawn in one OpenGL context. */
static void
test_one_context (void)
{
  g_auto (Rig) rig;
  GError *error = NULL;
  unsigned before = qn_offscreen_count ();
  rig_init (&rig, QN_VIEW_MECHANISM);
  rig.output.backend = QN_BACKEND_GL;
  g_autofree char *path = g_build_filename (rig.folder, "a.gif", NULL);
  bool done =
    qn_animation_export (&rig.animation, path, &rig.output, &rig.metadata, &error);
  if (g_error_matches (error, QN_RENDER_ERROR, QN_RENDER_ERROR_UNAVAILABLE)) {
    g_test_skip (error->message);
  } else {
    g_assert_no_error (error);
    g_assert_true (done);
    g_assert_cmpuint (qn_offscreen_count (), ==, before + 1);
    g_unlink (path);
  }
  g_clear_error (&error);
}

static bool
cancel_at_third (int done, int total, void *user_data)
{
  int *seen = user_data;
  g_assert_cmpint (total, ==, 6);
  *seen = done;
  return done < 3;
}

static void
test_cancel_leaves_nothing (void)
{
  const char *const names[] = { "a.gif", "frames/", "a.webm" };
  for (size_t i = 0; i < G_N_ELEMENTS (names); i++) {
    g_auto (Rig) rig;
    GError *error = NULL;
    int seen = 0;
    rig_init (&rig, QN_VIEW_MECHANISM);
    g_autofree char *path = g_build_filename (rig.folder, names[i], NULL);
    rig.animation.progress = cancel_at_third;
    rig.animation.user_data = &seen;
    if (qn_animation_check_path (path, &error)) {
      g_assert_false (
        qn_animation_export (&rig.animation, path, &rig.output, &rig.metadata, &error));
      g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_CANCELLED);
      g_assert_cmpint (seen, ==, 3);
    } else {
      g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_UNAVAILABLE);
    }
    g_clear_error (&error);
  }
}

static void
test_webm (void)
{
  g_auto (Rig) rig;
  GError *error = NULL;
  rig_init (&rig, QN_VIEW_MECHANISM);
  g_autofree char *path = g_build_filename (rig.folder, "a.webm", NULL);
  if (!qn_animation_check_path (path, &error)) {
    g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_UNAVAILABLE);
    g_assert_null (strchr (error->message, '\n'));
    g_clear_error (&error);
  } else {
    g_autofree char *content = NULL;
    g_assert_true (
      qn_animation_export (&rig.animation, path, &rig.output, &rig.metadata, &error));
    g_assert_true (g_file_get_contents (path, &content, NULL, NULL));
    g_assert_cmpint (strncmp (content, "\x1a\x45\xdf\xa3", 4), ==, 0);
    g_unlink (path);
  }
}

static void
test_refusals (void)
{
  g_auto (Rig) rig;
  GError *error = NULL;
  rig_init (&rig, QN_VIEW_MECHANISM);
  g_assert_false (
    qn_animation_export (&rig.animation, "a.mp4", &rig.output, &rig.metadata, &error));
  g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE);
  g_clear_error (&error);
  rig.animation.frames = 1;
  g_assert_false (
    qn_animation_export (&rig.animation, "a.gif", &rig.output, &rig.metadata, &error));
  g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE);
  g_clear_error (&error);
  rig.animation.frames = 3;
  g_autofree char *lost = g_build_filename (rig.folder, "none", "a.gif", NULL);
  g_assert_false (
    qn_animation_export (&rig.animation, lost, &rig.output, &rig.metadata, &error));
  g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FILE);
  g_clear_error (&error);
  rig.animation.figure.result = NULL;
  g_assert_false (
    qn_animation_export (&rig.animation, "a.gif", &rig.output, &rig.metadata, &error));
  g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE);
  g_clear_error (&error);
}

QN_TESTS
{
  g_test_add_func ("/render/animation/gif", test_gif);
  g_test_add_func ("/render/animation/repeatable", test_gif_is_repeatable);
  g_test_add_func ("/render/animation/frames", test_frames);
  g_test_add_func ("/render/animation/order", test_order_of_frames);
  g_test_add_func ("/render/animation/nearest-step", test_nearest_step);
  g_test_add_func ("/render/animation/one-context", test_one_context);
  g_test_add_func ("/render/animation/cancel", test_cancel_leaves_nothing);
  g_test_add_func ("/render/animation/webm", test_webm);
  g_test_add_func ("/render/animation/refusals", test_refusals);
}
