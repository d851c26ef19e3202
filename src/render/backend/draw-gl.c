#include "render/backend/draw-gl.h"

#include "core/base/integer.h"
#include "render/backend/gl-batch.h"
#include "render/backend/gl-target.h"
#include "render/backend/output.h"

#include <glib/gi18n-lib.h>
#include <stddef.h>

struct QnGlRenderer {
  const QnGl *gl;
  GLuint program, array, vertices, indices;
  GLint scale, shift, pixel, metric, growth, smoothness, dash;
  QnGlBatch batch;
  QnGlTarget target; /* for pictures that are read back */
  uint64_t revision; /* of the scene in the buffers; 0: none */
  unsigned uploads;
  GArray *counts;  /* of GLsizei: indices of each run of visible commands */
  GArray *offsets; /* of const void *: where the run starts, bytes */
};

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
  "uniform float growth;\n"
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
  "                     + (offset * point + growth * grow) * pixel, 0.0, 1.0);\n"
  "}\n";

static const char fragment_source[] =
  "#version 330 core\n"
  "flat in vec4 paint;\n"
  "flat in float dashed;\n"
  "in vec4 edges;\n"
  "uniform float smoothness;\n"
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
  "    if (mix(step(0.5, within), within, smoothness) == 0.0)\n"
  "      discard;\n"
  "    cover *= within;\n"
  "  }\n"
  "  result = paint * mix(1.0, cover, smoothness);\n"
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
  r->growth = gl->GetUniformLocation (r->program, "growth");
  r->smoothness = gl->GetUniformLocation (r->program, "smoothness");
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

void
qn_gl_renderer_free (QnGlRenderer *r)
{
  if (r == NULL)
    return;
  qn_gl_target_clear (&r->target);
  r->gl->DeleteProgram (r->program);
  r->gl->DeleteVertexArrays (1, &r->array);
  r->gl->DeleteBuffers (1, &r->vertices);
  r->gl->DeleteBuffers (1, &r->indices);
  qn_gl_batch_clear (&r->batch);
  g_array_unref (r->counts);
  g_array_unref (r->offsets);
  g_free (r);
}

const QnGl *
qn_gl_renderer_api (const QnGlRenderer *renderer)
{
  return renderer->gl;
}

QnGlTarget *
qn_gl_renderer_target (QnGlRenderer *renderer)
{
  return &renderer->target;
}

unsigned
qn_gl_renderer_uploads (const QnGlRenderer *renderer)
{
  return renderer->uploads;
}

static void
upload (QnGlRenderer *r, const QnScene *scene)
{
  const QnGl *gl = r->gl;
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
  r->uploads++;
}

/* Gathers the index ranges of visible commands; neighbours become one run. */
static QnDrawCounts
collect_runs (QnGlRenderer *r, const QnScene *scene, const QnCamera *camera)
{
  QnBox visible = qn_camera_visible_box (camera);
  QnDrawCounts tally = { 0, 0 };
  uint32_t end = 0;
  g_array_set_size (r->counts, 0);
  g_array_set_size (r->offsets, 0);
  for (guint i = 0; i < scene->commands->len; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    QnGlRange range = r->batch.ranges[i];
    if (command->kind == QN_COMMAND_TEXT || command->kind == QN_COMMAND_IMAGE)
      continue;
    if (!qn_command_is_visible (command, camera, visible)) {
      tally.skipped++;
      continue;
    }
    tally.drawn++;
    if (range.count == 0)
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
  return tally;
}

static void
set_camera (const QnGlRenderer *r, const QnScene *scene, const QnCamera *camera,
            bool antialias)
{
  const QnGl *gl = r->gl;
  double sx = 2 * camera->scale / camera->width, sy = 2 * camera->scale / camera->height;
  QnVec2 off = qn_vec2_sub (r->batch.origin, camera->center);
  gl->Uniform2f (r->scale, (float) sx, (float) sy);
  gl->Uniform2f (r->shift, (float) (off.x * sx), (float) (off.y * sy));
  gl->Uniform2f (r->pixel, (float) (2 / camera->width), (float) (2 / camera->height));
  gl->Uniform3f (r->metric, (float) camera->scale, (float) camera->unit,
                 (float) (camera->unit * qn_scene_line_factor (scene, camera)));
  gl->Uniform1f (r->growth, antialias ? 1.0f / QN_GL_GROWTH_STEPS : 0.0f);
  gl->Uniform1f (r->smoothness, antialias ? 1 : 0);
  gl->Uniform2f (r->dash, (float) (6.5 * camera->unit), (float) (4 * camera->unit));
}

static GLint
whole (double px)
{
  return (GLint) qn_to_integer (round (px), G_MININT16, G_MAXINT16);
}

void
qn_gl_renderer_draw (QnGlRenderer *r, const QnScene *scene, const QnCamera *camera,
                     int framebuffer_height, bool antialias, QnDrawCounts *counts)
{
  const QnGl *gl = r->gl;
  gl->UseProgram (r->program);
  gl->BindVertexArray (r->array);
  gl->BindBuffer (GL_ARRAY_BUFFER, r->vertices);
  if (r->revision != scene->revision)
    upload (r, scene);

  GLint left = whole (camera->x);
  GLint bottom = framebuffer_height - whole (camera->y + camera->height);
  gl->Viewport (left, bottom, whole (camera->width), whole (camera->height));
  gl->Scissor (left, bottom, whole (camera->width), whole (camera->height));
  gl->Enable (GL_SCISSOR_TEST);
  gl->Disable (GL_DEPTH_TEST);
  gl->Enable (GL_BLEND);
  gl->BlendFunc (GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  set_camera (r, scene, camera, antialias);

  QnDrawCounts tally = collect_runs (r, scene, camera);
  if (r->counts->len > 0)
    gl->MultiDrawElements (
      GL_TRIANGLES, (const GLsizei *) (void *) r->counts->data, GL_UNSIGNED_INT,
      (const void *const *) (void *) r->offsets->data, (GLsizei) r->counts->len);
  gl->Disable (GL_SCISSOR_TEST);
  gl->BindVertexArray (0);
  gl->UseProgram (0);
  if (counts != NULL)
    *counts = tally;
}
