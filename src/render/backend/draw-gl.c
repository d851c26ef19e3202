#include "render/backend/draw-gl.h"

#include "core/base/integer.h"
#include "render/backend/gl-batch.h"
#include "render/backend/output.h"

#include <glib/gi18n-lib.h>
#include <stddef.h>
#include <string.h>

/* Larger pictures are drawn in tiles, so that no driver's limit and no great memory matters. */
#define TILE 2048

struct QnGlRenderer {
  const QnGl *gl;
  GLuint program, array, vertices, indices;
  GLint scale, shift, pixel, metric, dash;
  QnGlBatch batch;
  GLuint framebuffer, renderbuffer; /* for pictures that are read back, of this size: */
  int width, height;                /* px; 0: there is none yet */
  uint64_t revision;                /* of the scene in the buffers; 0: none */
  GArray *counts;  /* of GLsizei: indices of each run of visible commands */
  GArray *offsets; /* of const void *: where the run starts, bytes */
};

bool
qn_gl_load (QnGl *gl, QnGlGetAddress get_address)
{
#define QN_GL_LOAD(type, name)                                                           \
  gl->name = (type) get_address ("gl" #name);                                            \
  if (gl->name == NULL)                                                                  \
    return false;
  QN_GL_FUNCTIONS (QN_GL_LOAD)
#undef QN_GL_LOAD
  return true;
}

bool
qn_gl_is_software (const QnGl *gl)
{
  static const char *const names[] = { "llvmpipe", "softpipe", "swrast", "SWR",
                                       "Software" };
  const char *renderer = (const char *) gl->GetString (GL_RENDERER);
  for (size_t i = 0; renderer != NULL && i < G_N_ELEMENTS (names); i++) {
    if (strstr (renderer, names[i]) != NULL)
      return true;
  }
  return false;
}

static const char vertex_source[] =
  "#version 330 core\n"
  "layout(location = 0) in vec2 place;\n"
  "layout(location = 1) in vec2 offset;\n"
  "layout(location = 2) in vec4 reach;\n"
  "layout(location = 3) in vec4 color;\n"
  "layout(location = 4) in vec4 flags;\n"
  "layout(location = 5) in vec2 grow;\n"
  "layout(location = 6) in vec4 rim;\n"
  "uniform vec2 scale, shift, pixel;\n"
  "uniform vec3 metric;\n" /* px per m, px per pt, px per pt of thinned lines */
  "const float growth = 1.0 / " G_STRINGIFY (
    QN_GL_GROWTH_STEPS) ".0;\n" /* px */
                        "flat out vec4 paint;\n"
                        "flat out float dashed;\n"
                        "out vec4 edges;\n" /* px */
                        "void main() {\n"
                        "  float point = mix(metric.y, metric.z, flags.x);\n"
                        "  vec2 units = mix(metric.xx, vec2(point), flags.yz);\n"
                        "  paint = vec4(color.rgb * color.a, color.a);\n"
                        "  dashed = flags.w;\n"
                        "  edges = reach * units.xyxy + growth * rim;\n"
                        "  gl_Position = vec4(place * scale + shift\n"
                        "                     + (offset * point + growth * grow) * "
                        "pixel, 0.0, 1.0);\n"
                        "}\n";

static const char fragment_source[] =
  "#version 330 core\n"
  "flat in vec4 paint;\n"
  "flat in float dashed;\n"
  "in vec4 edges;\n"
  "uniform vec2 dash;\n" /* period and length of a dash, px */
  "out vec4 result;\n"
  "void main() {\n"
  "  vec4 inside = clamp(edges + 0.5, 0.0, 1.0);\n"
  "  vec2 strip = max(inside.xy + inside.zw - 1.0, 0.0);\n"
  "  float cover = strip.x * strip.y;\n"
  "  if (dashed > 0.5) {\n"
  "    float away = abs(mod(edges.y - 0.5 * dash.y + 0.5 * dash.x, dash.x)\n"
  "                     - 0.5 * dash.x);\n"
  "    float within = clamp(0.5 * dash.y - away + 0.5, 0.0, 1.0);\n"
  "    if (within == 0.0)\n"
  "      discard;\n"
  "    cover *= within;\n"
  "  }\n"
  "  result = paint * cover;\n"
  "}\n";

static GLuint
compile (const QnGl *gl, GLenum kind, const char *source)
{
  GLuint shader = gl->CreateShader (kind);
  gl->ShaderSource (shader, 1, &source, NULL);
  gl->CompileShader (shader);
  return shader;
}

static bool
link_program (QnGlRenderer *r)
{
  const QnGl *gl = r->gl;
  GLint linked = 0;
  GLuint vertex = compile (gl, GL_VERTEX_SHADER, vertex_source);
  GLuint fragment = compile (gl, GL_FRAGMENT_SHADER, fragment_source);
  r->program = gl->CreateProgram ();
  gl->AttachShader (r->program, vertex);
  gl->AttachShader (r->program, fragment);
  gl->LinkProgram (r->program);
  gl->DeleteShader (vertex);
  gl->DeleteShader (fragment);
  gl->GetProgramiv (r->program, GL_LINK_STATUS, &linked);
  r->scale = gl->GetUniformLocation (r->program, "scale");
  r->shift = gl->GetUniformLocation (r->program, "shift");
  r->pixel = gl->GetUniformLocation (r->program, "pixel");
  r->metric = gl->GetUniformLocation (r->program, "metric");
  r->dash = gl->GetUniformLocation (r->program, "dash");
  return linked != 0;
}

QnGlRenderer *
qn_gl_renderer_new (const QnGl *gl, GError **error)
{
  QnGlRenderer *r = g_new0 (QnGlRenderer, 1);
  r->gl = gl;
  r->counts = g_array_new (FALSE, FALSE, sizeof (GLsizei));
  r->offsets = g_array_new (FALSE, FALSE, sizeof (const void *));
  gl->GenVertexArrays (1, &r->array);
  gl->GenBuffers (1, &r->vertices);
  gl->GenBuffers (1, &r->indices);
  gl->BindVertexArray (r->array);
  gl->BindBuffer (GL_ARRAY_BUFFER, r->vertices);
  gl->BindBuffer (GL_ELEMENT_ARRAY_BUFFER, r->indices);
  const struct {
    GLint size;
    GLenum type;
    GLboolean normalized;
    size_t offset;
  } attributes[] = {
    { 2, GL_FLOAT, GL_FALSE, offsetof (QnGlVertex, place) },
    { 2, GL_FLOAT, GL_FALSE, offsetof (QnGlVertex, offset) },
    { 4, GL_FLOAT, GL_FALSE, offsetof (QnGlVertex, reach) },
    { 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof (QnGlVertex, color) },
    { 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof (QnGlVertex, flags) },
    { 2, GL_BYTE, GL_FALSE, offsetof (QnGlVertex, grow) },
    { 4, GL_BYTE, GL_FALSE, offsetof (QnGlVertex, rim) },
  };
  for (GLuint i = 0; i < G_N_ELEMENTS (attributes); i++) {
    gl->EnableVertexAttribArray (i);
    gl->VertexAttribPointer (i, attributes[i].size, attributes[i].type,
                             attributes[i].normalized, sizeof (QnGlVertex),
                             (const void *) attributes[i].offset);
  }
  gl->BindVertexArray (0);
  if (!link_program (r)) {
    g_set_error_literal (error, QN_RENDER_ERROR, QN_RENDER_ERROR_UNAVAILABLE,
                         _ ("the OpenGL driver refuses the program's shaders"));
    qn_gl_renderer_free (r);
    return NULL;
  }
  return r;
}

static void
clear_target (QnGlRenderer *r)
{
  if (r->framebuffer == 0)
    return;
  r->gl->BindFramebuffer (GL_FRAMEBUFFER, 0);
  r->gl->DeleteFramebuffers (1, &r->framebuffer);
  r->gl->DeleteRenderbuffers (1, &r->renderbuffer);
  r->framebuffer = r->renderbuffer = 0;
  r->width = r->height = 0;
}

void
qn_gl_renderer_free (QnGlRenderer *r)
{
  if (r == NULL)
    return;
  clear_target (r);
  r->gl->DeleteProgram (r->program);
  r->gl->DeleteVertexArrays (1, &r->array);
  r->gl->DeleteBuffers (1, &r->vertices);
  r->gl->DeleteBuffers (1, &r->indices);
  qn_gl_batch_clear (&r->batch);
  g_array_unref (r->counts);
  g_array_unref (r->offsets);
  g_free (r);
}

/* Gathers the index ranges of visible commands; neighbours become one run. */
static void
collect_runs (QnGlRenderer *r, const QnScene *scene, const QnCamera *camera)
{
  QnBox visible = qn_camera_visible_box (camera);
  uint32_t end = 0;
  g_array_set_size (r->counts, 0);
  g_array_set_size (r->offsets, 0);
  for (guint i = 0; i < scene->commands->len; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    QnGlRange range = r->batch.ranges[i];
    if (range.count == 0 || !qn_command_is_visible (command, camera, visible))
      continue;
    if (r->counts->len > 0 && range.first == end) {
      g_array_index (r->counts, GLsizei, r->counts->len - 1) += (GLsizei) range.count;
    } else {
      GLsizei count = (GLsizei) range.count;
      const void *offset = (const void *) ((uintptr_t) range.first * sizeof (uint32_t));
      g_array_append_val (r->counts, count);
      g_array_append_val (r->offsets, offset);
    }
    end = range.first + range.count;
  }
}

static GLint
whole (double px)
{
  return (GLint) qn_to_integer (round (px), G_MININT16, G_MAXINT16);
}

void
qn_gl_renderer_draw (QnGlRenderer *r, const QnScene *scene, const QnCamera *camera,
                     int framebuffer_height)
{
  const QnGl *gl = r->gl;
  gl->UseProgram (r->program);
  gl->BindVertexArray (r->array);
  gl->BindBuffer (GL_ARRAY_BUFFER, r->vertices);
  if (r->revision != scene->revision) {
    qn_gl_batch_clear (&r->batch);
    qn_gl_batch_init (&r->batch, scene);
    gl->BufferData (GL_ARRAY_BUFFER,
                    (GLsizeiptr) (r->batch.vertices->len * sizeof (QnGlVertex)),
                    r->batch.vertices->data, GL_STATIC_DRAW);
    gl->BufferData (GL_ELEMENT_ARRAY_BUFFER,
                    (GLsizeiptr) (r->batch.indices->len * sizeof (uint32_t)),
                    r->batch.indices->data, GL_STATIC_DRAW);
    /* The triangles live with the driver now; the ranges stay here. */
    g_array_set_size (r->batch.vertices, 0);
    g_array_set_size (r->batch.indices, 0);
    r->revision = scene->revision;
  }

  GLint left = whole (camera->x);
  GLint bottom = framebuffer_height - whole (camera->y + camera->height);
  gl->Viewport (left, bottom, whole (camera->width), whole (camera->height));
  gl->Scissor (left, bottom, whole (camera->width), whole (camera->height));
  gl->Enable (GL_SCISSOR_TEST);
  gl->Disable (GL_DEPTH_TEST);
  gl->Enable (GL_BLEND);
  gl->BlendFunc (GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  double sx = 2 * camera->scale / camera->width, sy = 2 * camera->scale / camera->height;
  QnVec2 off = qn_vec2_sub (r->batch.origin, camera->center);
  gl->Uniform2f (r->scale, (float) sx, (float) sy);
  gl->Uniform2f (r->shift, (float) (off.x * sx), (float) (off.y * sy));
  gl->Uniform2f (r->pixel, (float) (2 / camera->width), (float) (2 / camera->height));
  gl->Uniform3f (r->metric, (float) camera->scale, (float) camera->unit,
                 (float) (camera->unit * qn_scene_line_factor (scene, camera)));
  gl->Uniform2f (r->dash, (float) (6.5 * camera->unit), (float) (4 * camera->unit));

  collect_runs (r, scene, camera);
  if (r->counts->len > 0)
    gl->MultiDrawElements (
      GL_TRIANGLES, (const GLsizei *) (void *) r->counts->data, GL_UNSIGNED_INT,
      (const void *const *) (void *) r->offsets->data, (GLsizei) r->counts->len);
  gl->Disable (GL_SCISSOR_TEST);
  gl->BindVertexArray (0);
  gl->UseProgram (0);
}

/* ---- images: a framebuffer that is read back tile by tile ---- */

/* Makes a framebuffer of this size unless it is there; false where the driver cannot. */
static bool
prepare_target (QnGlRenderer *r, int width, int height)
{
  const QnGl *gl = r->gl;
  if (r->width == width && r->height == height)
    return true;
  clear_target (r);
  gl->GenFramebuffers (1, &r->framebuffer);
  gl->GenRenderbuffers (1, &r->renderbuffer);
  gl->BindRenderbuffer (GL_RENDERBUFFER, r->renderbuffer);
  gl->RenderbufferStorage (GL_RENDERBUFFER, GL_RGBA8, width, height);
  gl->BindFramebuffer (GL_FRAMEBUFFER, r->framebuffer);
  gl->FramebufferRenderbuffer (GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                               r->renderbuffer);
  if (gl->CheckFramebufferStatus (GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    clear_target (r);
    return false;
  }
  r->width = width;
  r->height = height;
  return true;
}

/* Copies what was drawn into the image at (left, top), upside down as GL has it. */
static void
read_back (const QnGlRenderer *r, cairo_surface_t *image, int left, int top, int width,
           int height, guint8 *rows)
{
  const QnGl *gl = r->gl;
  gl->PixelStorei (GL_PACK_ALIGNMENT, 4);
  /* Cairo's ARGB32 is a native 32-bit word with alpha on top. */
  gl->ReadPixels (0, r->height - height, width, height, GL_BGRA,
                  GL_UNSIGNED_INT_8_8_8_8_REV, rows);
  int stride = cairo_image_surface_get_stride (image);
  guint8 *data = cairo_image_surface_get_data (image);
  for (int y = 0; y < height; y++)
    memcpy (data + (size_t) (top + y) * stride + (size_t) left * 4,
            rows + (size_t) (height - 1 - y) * width * 4, (size_t) width * 4);
}

/* The camera that shows one tile of another's viewport. */
static QnCamera
tile_camera (const QnCamera *whole, int left, int top, int width, int height)
{
  QnCamera tile = *whole;
  tile.x = tile.y = 0;
  tile.width = width;
  tile.height = height;
  tile.center.x += (left + 0.5 * width - 0.5 * whole->width) / whole->scale;
  tile.center.y -= (top + 0.5 * height - 0.5 * whole->height) / whole->scale;
  return tile;
}

static void
draw_tiles (QnGlRenderer *r, const QnScene *scene, const QnCamera *camera,
            cairo_surface_t *image, guint8 *rows)
{
  const QnGl *gl = r->gl;
  int width = cairo_image_surface_get_width (image);
  int height = cairo_image_surface_get_height (image);
  for (int top = 0; top < height; top += r->height) {
    for (int left = 0; left < width; left += r->width) {
      int w = MIN (r->width, width - left), h = MIN (r->height, height - top);
      QnCamera tile = tile_camera (camera, left, top, w, h);
      gl->BindFramebuffer (GL_FRAMEBUFFER, r->framebuffer);
      gl->Disable (GL_SCISSOR_TEST);
      gl->ClearColor (0, 0, 0, 0);
      gl->Clear (GL_COLOR_BUFFER_BIT);
      qn_gl_renderer_draw (r, scene, &tile, r->height);
      read_back (r, image, left, top, w, h, rows);
    }
  }
}

cairo_surface_t *
qn_gl_renderer_draw_image (QnGlRenderer *r, const QnScene *scene, const QnCamera *camera,
                           GError **error)
{
  int width = (int) qn_to_integer (ceil (camera->width), 1, G_MAXINT16);
  int height = (int) qn_to_integer (ceil (camera->height), 1, G_MAXINT16);
  int tile_width = MIN (width, TILE), tile_height = MIN (height, TILE);
  cairo_surface_t *image =
    cairo_image_surface_create (CAIRO_FORMAT_ARGB32, width, height);
  g_autofree guint8 *rows = g_try_malloc ((gsize) tile_width * tile_height * 4);
  if (prepare_target (r, tile_width, tile_height) && rows != NULL
      && cairo_surface_status (image) == CAIRO_STATUS_SUCCESS) {
    QnCamera whole = *camera;
    whole.width = width;
    whole.height = height;
    whole.center.x += 0.5 * (width - camera->width) / camera->scale;
    whole.center.y -= 0.5 * (height - camera->height) / camera->scale;
    cairo_surface_flush (image);
    draw_tiles (r, scene, &whole, image, rows);
    cairo_surface_mark_dirty (image);
  } else {
    g_clear_pointer (&image, cairo_surface_destroy);
    g_set_error_literal (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FAILED,
                         _ ("the OpenGL driver cannot draw a picture of this size"));
  }
  return image;
}
