/* WebM (VP8) through GStreamer, where the build found it and the machine has the encoder. */
#include "core/base/integer.h"
#include "render/movie/movie.h"

#include <glib/gi18n-lib.h>

#ifdef QN_HAVE_GSTREAMER

#include "disk/whole-file.h"
#include "render/drawing/paint.h"

#include <gst/app/gstappsrc.h>
#include <gst/gst.h>

/* Frames that may wait for the encoder, and how often it is looked whether it has stopped. */
#define WAITING_FRAMES 4
#define POLL_INTERVAL  (5 * GST_MSECOND)

/* Of smaller pictures the encoder makes no stream. */
#define LEAST_SIDE 16

typedef struct WebmMovie {
  const char *path;
  QnWholeFile file;
  GstElement *pipeline, *source;
  GstMessage *stopped; /* why the pipeline has, the first reason of several */
  int width, height;
  GstClockTime frame_time, time;
} WebmMovie;

/* Whether this machine can write WebM. */
static bool
is_available (GError **error)
{
  static const char *const needed[] = { "appsrc", "videoconvert", "vp8enc", "webmmux",
                                        "fdsink" };
  g_autoptr (GError) cause = NULL;
  bool ready = gst_init_check (NULL, NULL, &cause);
  for (size_t i = 0; ready && i < G_N_ELEMENTS (needed); i++) {
    GstElementFactory *factory = gst_element_factory_find (needed[i]);
    if (factory == NULL) {
      g_set_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_UNAVAILABLE,
                   _ ("WebM needs GStreamer's element \"%s\", which is not installed"),
                   needed[i]);
      return false;
    }
    gst_object_unref (factory);
  }
  if (!ready)
    g_set_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_UNAVAILABLE,
                 _ ("WebM needs GStreamer, which does not start: %s"), cause->message);
  return ready;
}

static void
webm_free (WebmMovie *movie)
{
  if (movie->pipeline != NULL) {
    gst_element_set_state (movie->pipeline, GST_STATE_NULL);
    g_clear_pointer (&movie->source, gst_object_unref);
    gst_object_unref (movie->pipeline);
  }
  g_clear_pointer (&movie->stopped, gst_message_unref);
  g_free (movie);
}

static void
webm_abandon (void *state)
{
  WebmMovie *movie = state;
  if (movie->pipeline != NULL)
    gst_element_set_state (movie->pipeline, GST_STATE_NULL);
  qn_whole_file_discard (&movie->file);
  webm_free (movie);
}

/* Waits for the end of the stream or an error, for so long; an error is kept. */
static bool
wait_for_message (WebmMovie *movie, GstClockTime longest, GstMessageType type)
{
  GstBus *bus = gst_element_get_bus (movie->pipeline);
  GstMessage *message =
    gst_bus_timed_pop_filtered (bus, longest, type | GST_MESSAGE_ERROR);
  gst_object_unref (bus);
  if (message == NULL || GST_MESSAGE_TYPE (message) != GST_MESSAGE_ERROR) {
    g_clear_pointer (&message, gst_message_unref);
    return true;
  }
  g_clear_pointer (&movie->stopped, gst_message_unref);
  movie->stopped = message;
  return false;
}

static void
set_pipeline_error (WebmMovie *movie, GError **error)
{
  g_autoptr (GError) cause = NULL;
  if (movie->stopped != NULL)
    gst_message_parse_error (movie->stopped, &cause, NULL);
  g_set_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FILE,
               _ ("%s: cannot be written: %s"), movie->path,
               cause != NULL ? cause->message : _ ("the encoder stopped"));
}

static void *
webm_open (const char *path, const QnPage *page, double rate, const QnMetadata *metadata,
           GError **error)
{
  if (page->width < LEAST_SIDE || page->height < LEAST_SIDE) {
    g_set_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE,
                 _ ("%s: pictures of a WebM file have at least %d pixels each way"), path,
                 LEAST_SIDE);
    return NULL;
  }
  WebmMovie *movie = g_new0 (WebmMovie, 1);
  movie->path = path;
  movie->width = (int) qn_to_integer (page->width, 1, G_MAXINT16);
  movie->height = (int) qn_to_integer (page->height, 1, G_MAXINT16);
  movie->frame_time = (GstClockTime) qn_to_integer ((double) GST_SECOND / rate, 1,
                                                    3600 * (gint64) GST_SECOND);
  int trouble = qn_whole_file_open (&movie->file, path);
  if (trouble != 0) {
    qn_render_error_set_unwritten (error, movie->path, trouble);
    webm_free (movie);
    return NULL;
  }
  g_autoptr (GError) cause = NULL;
  movie->pipeline = gst_parse_launch (
    "appsrc name=source format=time max-bytes=0 ! videoconvert ! "
    "vp8enc deadline=1000000 threads=1 end-usage=cq cq-level=10 min-quantizer=2 "
    "max-quantizer=40 target-bitrate=8000000 ! webmmux name=mux ! fdsink name=sink",
    &cause);
  if (movie->pipeline == NULL) {
    g_set_error_literal (error, QN_RENDER_ERROR, QN_RENDER_ERROR_UNAVAILABLE,
                         cause->message);
    webm_abandon (movie);
    return NULL;
  }
  GstElement *sink = gst_bin_get_by_name (GST_BIN (movie->pipeline), "sink");
  GstElement *mux = gst_bin_get_by_name (GST_BIN (movie->pipeline), "mux");
  g_object_set (sink, "fd", movie->file.fd, NULL);
  if (metadata->generator != NULL)
    g_object_set (mux, "writing-app", metadata->generator, NULL);
  gst_object_unref (sink);
  gst_object_unref (mux);
  movie->source = gst_bin_get_by_name (GST_BIN (movie->pipeline), "source");
  GstCaps *caps = gst_caps_new_simple (
    "video/x-raw", "format", G_TYPE_STRING,
    G_BYTE_ORDER == G_LITTLE_ENDIAN ? "BGRx" : "xRGB", "width", G_TYPE_INT, movie->width,
    "height", G_TYPE_INT, movie->height, "framerate", GST_TYPE_FRACTION,
    (gint) qn_to_integer (rate * 1000 + 0.5, 1, G_MAXINT), 1000, NULL);
  gst_app_src_set_caps (GST_APP_SRC (movie->source), caps);
  gst_caps_unref (caps);
  gst_element_set_state (movie->pipeline, GST_STATE_PLAYING);
  return movie;
}

/* Waits until the encoder has taken most of what it was given; false where it has stopped, of
 * which a source that blocks by itself would never hear. */
static bool
wait_for_encoder (WebmMovie *movie)
{
  guint64 most = (guint64) WAITING_FRAMES * movie->width * movie->height * 4;
  while (gst_app_src_get_current_level_bytes (GST_APP_SRC (movie->source)) >= most)
    if (!wait_for_message (movie, POLL_INTERVAL, GST_MESSAGE_UNKNOWN))
      return false;
  return true;
}

static bool
webm_add (void *state, cairo_surface_t *frame, GError **error)
{
  WebmMovie *movie = state;
  if (!wait_for_encoder (movie)) {
    set_pipeline_error (movie, error);
    return false;
  }
  gsize row = (gsize) movie->width * 4, length = row * movie->height;
  GstBuffer *buffer = gst_buffer_new_allocate (NULL, length, NULL);
  for (int y = 0; y < movie->height; y++)
    gst_buffer_fill (buffer, (gsize) y * row, qn_image_row (frame, y), row);
  GST_BUFFER_PTS (buffer) = movie->time;
  GST_BUFFER_DURATION (buffer) = movie->frame_time;
  movie->time += movie->frame_time;
  if (gst_app_src_push_buffer (GST_APP_SRC (movie->source), buffer) == GST_FLOW_OK)
    return true;
  wait_for_message (movie, 0, GST_MESSAGE_UNKNOWN);
  set_pipeline_error (movie, error);
  return false;
}

static bool
webm_finish (void *state, GError **error)
{
  WebmMovie *movie = state;
  gst_app_src_end_of_stream (GST_APP_SRC (movie->source));
  bool done = wait_for_message (movie, GST_CLOCK_TIME_NONE, GST_MESSAGE_EOS);
  if (!done)
    set_pipeline_error (movie, error);
  gst_element_set_state (movie->pipeline, GST_STATE_NULL);
  if (!done) {
    webm_abandon (movie);
    return false;
  }
  int trouble = qn_whole_file_commit (&movie->file);
  if (trouble != 0)
    qn_render_error_set_unwritten (error, movie->path, trouble);
  webm_free (movie);
  return trouble == 0;
}

const QnMovieFormat *
qn_movie_webm (GError **error)
{
  static const QnMovieFormat format = {
    .open = webm_open, .add = webm_add, .finish = webm_finish, .abandon = webm_abandon
  };
  return is_available (error) ? &format : NULL;
}

#else

const QnMovieFormat *
qn_movie_webm (GError **error)
{
  g_set_error_literal (error, QN_RENDER_ERROR, QN_RENDER_ERROR_UNAVAILABLE,
                       _ ("WebM needs GStreamer, which this build does not include"));
  return NULL;
}

#endif
