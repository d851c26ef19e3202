/* Files that ask for much more work or memory than their size lets expect: each is refused, or takes
 * work in proportion to its size. Work is counted in instructions, which are the same however busy
 * the machine is, and memory is limited for the program. */
#include "cli/cli-run.h"
#include "support/instructions.h"
#include "support/room.h"

#include <errno.h>
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

/* What every input of the table has to do with: 500 MB, and so many instructions as a core of 2 GHz
 * executes in 2 s. */
#define MOST_MEMORY       ((rlim_t) 500 << 20)
#define MOST_INSTRUCTIONS 4e9

/* Growth of the work with the size of files that are accepted. */
#define MOST_GROWTH 1.1

static char *folder;

/* --- Makers of files: their paths, to be freed with g_free() ---------------------------------- */

#define PROJECT_LAWS                                                                     \
  "{ \"format\": \"quoin\", \"version\": 1, \"laws\": [ { \"name\": \"j\", \"kind\": "   \
  "\"coulomb\", \"kn\": 1e7, \"ks\": 1e7, \"friction\": 0.6 }, { \"name\": \"s\", "      \
  "\"kind\": \"elastic\", \"basis\": \"surface\", \"kn\": 1e9, \"ks\": 1e9 } ], "        \
  "\"contact\": { \"law\": \"j\" }, "
#define PROJECT_HEAD                                                                     \
  PROJECT_LAWS "\"loads\": { \"dead\": [ { \"kind\": \"weight\", \"direction\": "        \
               "[0, -1] } ] }, \"blocks\": [ "

static void
add_block (GString *text, int index, double x, double y, double tilt)
{
  g_string_append_printf (
    text,
    "%s{ \"name\": \"b%d\", \"thickness\": 1, \"unit_weight\": 1, \"vertices\": "
    "[[%.9g, %.9g], [%.9g, %.9g], [%.9g, %.9g], [%.9g, %.9g]], \"support\": [%s] }",
    index > 0 ? ",\n" : "", index, x, y, x + 1, y + tilt, x + 1, y + tilt + 1, x, y + 1,
    index == 0 ? "true, true, true" : "false, false, false");
}

static char *
make_same_blocks (int count)
{
  g_autoptr (GString) text = g_string_new (PROJECT_HEAD);
  for (int i = 0; i < count; i++)
    add_block (text, i, 0, 0, 0);
  g_string_append (text, " ] }");
  return cli_write (folder, "same.quoin", text->str);
}

/* Slabs at an angle one above the other: all boxes meet, no blocks overlap. */
static char *
make_slabs (int count)
{
  g_autoptr (GString) text = g_string_new (PROJECT_HEAD);
  for (int i = 0; i < count; i++)
    add_block (text, i, 0, i, 1e5);
  g_string_append (text, " ] }");
  return cli_write (folder, "slabs.quoin", text->str);
}

/* Stones too far apart to touch: each is told of with its line. */
static char *
make_apart (int count)
{
  g_autoptr (GString) text = g_string_new (PROJECT_HEAD);
  for (int i = 0; i < count; i++)
    add_block (text, i, 2 * (i % 100), 2 * (i / 100), 0);
  g_string_append (text, " ] }");
  return cli_write (folder, "apart.quoin", text->str);
}

/* A stack-bonded wall: every stone meets up to four others. */
static char *
make_wall (int count)
{
  g_autoptr (GString) text = g_string_new (PROJECT_HEAD);
  for (int i = 0; i < count; i++)
    add_block (text, i, i % 50, i / 50, 0);
  g_string_append (text, " ] }");
  return cli_write (folder, "wall.quoin", text->str);
}

/* A list of so many in a project with a stone, or a wall of so many stones. */
static char *
make_list (const char *name, int stones, const char *before, int from, int count,
           void (*add) (GString *text, int index), const char *after)
{
  g_autoptr (GString) text = g_string_new (PROJECT_LAWS "\"blocks\": [ ");
  for (int i = 0; i < stones; i++)
    add_block (text, i, i % 50, i / 50, 0);
  g_string_append_printf (text, " ], %s", before);
  for (int i = from; i < count; i++) {
    g_string_append (text, i > from ? ",\n" : "");
    add (text, i);
  }
  g_string_append_printf (text, "%s }", after);
  return cli_write (folder, name, text->str);
}

/* Each through one bed joint. */
static void
add_bar (GString *text, int i)
{
  double x = i % 50 + 0.5, y = i / 50;
  g_string_append_printf (text,
                          "{ \"law\": \"s\", \"area\": 1e-4, \"start\": [%g, %g], "
                          "\"end\": [%g, %g] }",
                          x, y - 0.4, x, y + 0.4);
}

static char *
make_bars (int count)
{
  return make_list ("bars.quoin", count, "\"bars\": [", 50, count, add_bar, "]");
}

static void
add_tie (GString *text, int i)
{
  double x = i % 50 + 0.5, y = i / 50 + 0.5;
  g_string_append_printf (
    text,
    "{ \"name\": \"t%d\", \"area\": 1e-4, \"elasticity\": 2e11, "
    "\"ends\": [{ \"block\": \"b%d\", \"at\": [%g, %g] }, { \"at\": "
    "[%g, -9] }] }",
    i, i, x, y, x);
}

static char *
make_ties (int count)
{
  return make_list ("ties.quoin", count, "\"ties\": [", 1, count, add_tie, "]");
}

static void
add_arch (GString *text, int i)
{
  g_string_append_printf (
    text,
    "{ \"kind\": \"arch\", \"name\": \"a%d\", \"origin\": [%d, 5], \"span\": 3, "
    "\"rise\": 1, "
    "\"ring\": 0.3, \"voussoirs\": 7, \"thickness\": 1, \"unit_weight\": 1, "
    "\"foundation\": 0.2 }",
    i, 5 * i);
}

static char *
make_arches (int count)
{
  return make_list ("arches.quoin", 1, "\"masonry\": [", 0, count, add_arch, "]");
}

static void
add_stage (GString *text, int i)
{
  g_string_append_printf (
    text, "{ \"name\": \"s%d\", \"loads\": \"push\", \"target\": %d }", i, i + 1);
}

static char *
make_stages (int count)
{
  return make_list ("stages.quoin", 100,
                    "\"loads\": { \"dead\": [], \"sets\": { \"push\": [ { \"kind\": "
                    "\"force\", \"block\": \"b9\", \"value\": [1, 0] } ] } }, "
                    "\"analysis\": { \"stages\": [",
                    0, count, add_stage, "] }");
}

static void
add_case (GString *text, int i)
{
  g_string_append_printf (text, "\"c%d\": 1.%d", i, i);
}

static char *
make_cases (int count)
{
  return make_list ("cases.quoin", 100, "\"loads\": { \"dead\": [], \"cases\": {", 0,
                    count, add_case, "} }");
}

static void
add_motion (GString *text, int i)
{
  g_string_append_printf (text,
                          "{ \"direction\": [1, 0], \"pulse\": { \"kind\": \"sine\", "
                          "\"amplitude\": %d, \"duration\": 1 } }",
                          i % 9 + 1);
}

#define DYNAMIC                                                                          \
  "\"analysis\": { \"procedure\": \"dynamic\", \"geometry\": \"nonlinear\", "            \
  "\"dynamic\": { "                                                                      \
  "\"duration\": 1, \"time_step\": 0.005, \"ground\": ["

static char *
make_motions (int count)
{
  return make_list ("motions.quoin", 100, DYNAMIC, 0, count, add_motion, "] } }");
}

static void
add_record (GString *text, int i)
{
  (void) i;
  g_string_append (text, "{ \"direction\": [1, 0], \"record\": \"record.csv\" }");
}

/* Of so many samples. */
static char *
make_record (int count)
{
  g_autoptr (GString) samples = g_string_new ("time [s],acceleration [m/s2]\n");
  for (int i = 0; i < count; i++)
    g_string_append_printf (samples, "%.9g,%.9g\n", i / (double) count, sin (i));
  g_free (cli_write (folder, "record.csv", samples->str));
  return make_list ("record.quoin", 100, DYNAMIC, 0, 1, add_record, "] } }");
}

/* A wall of so many courses, with a finding in each: a gap just wider than the tolerance. */
static char *
make_courses (int count)
{
  g_autoptr (GString) text = g_string_new (PROJECT_HEAD);
  add_block (text, 0, -5, -1, 0);
  g_string_append (text,
                   " ], \"walls\": [ { \"name\": \"w\", \"origin\": [0, 0], \"unit\": "
                   "[1, 1], \"thickness\": 1, \"unit_weight\": 1, \"courses\": [");
  for (int i = 0; i < count; i++)
    g_string_append (text, i == 0 ? "[1, -1e-5, 1]" : ", [1, -1e-5, 1]");
  g_string_append (text, "] } ] }");
  return cli_write (folder, "courses.quoin", text->str);
}

/* So many walls, each with a finding: it floats beside the next one. */
static char *
make_walls (int count)
{
  g_autoptr (GString) text = g_string_new (PROJECT_HEAD);
  add_block (text, 0, -5, -1, 0);
  g_string_append (text, " ], \"walls\": [");
  for (int i = 0; i < count; i++)
    g_string_append_printf (
      text,
      "%s{ \"name\": \"w%d\", \"origin\": [%.9g, 0], \"unit\": [1, "
      "1], \"thickness\": 1, \"unit_weight\": 1, \"courses\": [[1]] }",
      i > 0 ? ", " : "", i, i * 1.00001);
  g_string_append (text, "] }");
  return cli_write (folder, "walls.quoin", text->str);
}

/* Stones on the teeth of one block. */
static char *
make_teeth (int count)
{
  g_autoptr (GString) text = g_string_new (PROJECT_HEAD);
  for (int i = 0; i < count; i++)
    add_block (text, i, 2 * i, 1, 0);
  g_string_append (
    text, ", { \"name\": \"ground\", \"thickness\": 1, \"unit_weight\": 1, \"support\": "
          "[true, true, true], \"vertices\": [[0, -1], ");
  g_string_append_printf (text, "[%d, -1]", 2 * count);
  for (int i = count - 1; i >= 0; i--)
    g_string_append_printf (text, ", [%d, 0], [%d, 1], [%d, 1], [%d, 0]", 2 * i + 1,
                            2 * i + 1, 2 * i, 2 * i);
  g_string_append (text, "] } ] }");
  return cli_write (folder, "teeth.quoin", text->str);
}

static char *
make_unknown_keys (int count)
{
  g_autoptr (GString) text = g_string_new (PROJECT_HEAD);
  add_block (text, 0, 0, 0, 0);
  g_string_append (text, " ]");
  for (int i = 0; i < count; i++)
    g_string_append_printf (text, ",\n\"k%d\": 1", i);
  g_string_append (text, " }");
  return cli_write (folder, "keys.quoin", text->str);
}

static char *
make_recipes (int count)
{
  g_autoptr (GString) text = g_string_new (PROJECT_HEAD);
  add_block (text, 0, 0, 0, 0);
  g_string_append (text, " ], \"figures\": [ ");
  for (int i = 0; i < count; i++)
    g_string_append_printf (text, "%s{ \"name\": \"f%d\", \"view\": \"model\" }",
                            i > 0 ? "," : "", i);
  g_string_append (text, " ] }");
  return cli_write (folder, "recipes.quoin", text->str);
}

/* A wall of a few stones with an opening under so many voussoirs. */
static char *
make_voussoirs (int count)
{
  g_autoptr (GString) text = g_string_new (PROJECT_HEAD);
  add_block (text, 0, 0, 0, 0);
  g_string_append_printf (
    text,
    " ], \"masonry\": [ { \"kind\": \"wall\", \"name\": \"w\", \"origin\": [9, 0], "
    "\"height\": 0.5, \"thickness\": 0.3, \"unit_weight\": 2e4, \"foundation\": 0.2, "
    "\"leaves\": [ { \"length\": 1, \"unit\": [0.5, 0.2], \"bond\": \"running\" } ], "
    "\"openings\": [ { \"at\": [0.2, 0.1], \"width\": 0.3, \"height\": 0.2, \"span\": "
    "\"flat-arch\", \"depth\": 0.2, \"voussoirs\": %d, \"skew\": 0.3 } ] } ] }",
    count);
  return cli_write (folder, "voussoirs.quoin", text->str);
}

/* A stone with a name of so many letters. */
static char *
make_long_name (int count)
{
  g_autoptr (GString) text = g_string_new (
    PROJECT_LAWS
    "\"loads\": { \"live\": [ { \"kind\": \"weight\", \"direction\": [1, 0] } ], "
    "\"dead\": [ { \"kind\": \"weight\", \"direction\": [0, -1] } ] }, "
    "\"blocks\": [ ");
  add_block (text, 0, 0, 0, 0);
  g_string_append (text, ", { \"name\": \"");
  for (int i = 0; i < count; i++)
    g_string_append_c (text, 'a');
  g_string_append (text, "\", \"thickness\": 1, \"unit_weight\": 1, \"vertices\": "
                         "[[0, 1], [1, 1], [1, 2], [0, 2]] } ] }");
  return cli_write (folder, "name.quoin", text->str);
}

static char *
make_lines (int count)
{
  g_autoptr (GString) text = g_string_new ("0\nSECTION\n2\nENTITIES\n");
  g_autoptr (GRand) random = g_rand_new_with_seed (1);
  for (int i = 0; i < count; i++) {
    double end[4];
    for (int k = 0; k < 4; k++)
      end[k] = g_rand_double_range (random, 0, 10);
    g_string_append_printf (text,
                            "0\nLINE\n8\n0\n10\n%.9g\n20\n%.9g\n11\n%.9g\n21\n%.9g\n",
                            end[0], end[1], end[2], end[3]);
  }
  g_string_append (text, "0\nENDSEC\n0\nEOF\n");
  return cli_write (folder, "lines.dxf", text->str);
}

/* The squares of a chequered paper, 50 wide. */
static char *
make_grid (int count)
{
  g_autoptr (GString) text = g_string_new ("0\nSECTION\n2\nENTITIES\n");
  for (int i = 0; i < count; i++) {
    int x = i % 50, y = i / 50;
    g_string_append_printf (text,
                            "0\nLINE\n8\n0\n10\n%d\n20\n%d\n11\n%d\n21\n%d\n"
                            "0\nLINE\n8\n0\n10\n%d\n20\n%d\n11\n%d\n21\n%d\n",
                            x, y, x + 1, y, x, y, x, y + 1);
  }
  g_string_append (text, "0\nENDSEC\n0\nEOF\n");
  return cli_write (folder, "grid.dxf", text->str);
}

/* A line of many points that lie together, in a drawing that is very wide. */
static char *
make_speck (int count)
{
  g_autoptr (GString) text =
    g_string_new ("<svg><rect width=\"4e9\" height=\"9\"/><path d=\"M0 0");
  for (int i = 0; i < count; i++)
    g_string_append_printf (text, " L %d %d", i % 7, i % 5);
  g_string_append (text, " H 4e9\"/></svg>");
  return cli_write (folder, "speck.svg", text->str);
}

/* Circles about one centre, 20 mm apart. */
static char *
make_circles (int count)
{
  g_autoptr (GString) text = g_string_new (
    "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n6\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n");
  for (int i = 0; i < count; i++)
    g_string_append_printf (text, "0\nCIRCLE\n8\n0\n10\n0\n20\n0\n40\n%.2f\n",
                            0.1 + 0.02 * i);
  g_string_append (text, "0\nENDSEC\n0\nEOF\n");
  return cli_write (folder, "circles.dxf", text->str);
}

/* The same as blocks of 480 sides, each over the others. */
static char *
make_discs (int count)
{
  g_autoptr (GString) text = g_string_new (PROJECT_HEAD);
  for (int i = 0; i < count; i++) {
    g_string_append_printf (
      text,
      "%s{ \"name\": \"d%d\", \"thickness\": 1, \"unit_weight\": 1, "
      "\"vertices\": [",
      i > 0 ? ",\n" : "", i);
    for (int k = 0; k < 480; k++)
      g_string_append_printf (text, "%s[%.9f, %.9f]", k > 0 ? ", " : "",
                              (1 + 0.01 * i) * cos (k * G_PI / 240),
                              (1 + 0.01 * i) * sin (k * G_PI / 240));
    g_string_append (text, "], \"support\": [true, true, true] }");
  }
  g_string_append (text, " ] }");
  return cli_write (folder, "discs.quoin", text->str);
}

/* A project with the beginning of a PNG file behind it that announces so many pixels each way. */
static char *
make_picture (int pixels)
{
  static const guint8 head[] = {
    0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 0, 0, 0, 13
  };
  guint32 crc = 0xffffffff;
  g_autoptr (GByteArray) bytes = g_byte_array_new ();
  guint8 header[17] = { 'I', 'H', 'D', 'R', [12] = 8 };
  for (int k = 0; k < 4; k++)
    header[4 + k] = header[8 + k] = (guint8) (pixels >> (24 - 8 * k));
  for (gsize i = 0; i < sizeof header; i++) { /* ISO 3309 */
    crc ^= header[i];
    for (int bit = 0; bit < 8; bit++)
      crc = crc >> 1 ^ (crc & 1 ? 0xedb88320 : 0);
  }
  guint32 sum = GUINT32_TO_BE (~crc);
  g_byte_array_append (bytes, head, sizeof head);
  g_byte_array_append (bytes, header, sizeof header);
  g_byte_array_append (bytes, (guint8 *) &sum, sizeof sum);
  g_byte_array_append (bytes, (const guint8 *) "\0\0\1\0IDAT\x78\x9c", 10);
  g_autofree char *picture = g_build_filename (folder, "large.png", NULL);
  g_assert_true (g_file_set_contents (picture, (char *) bytes->data, bytes->len, NULL));

  g_autoptr (GString) text = g_string_new (PROJECT_HEAD);
  add_block (text, 0, 0, 0, 0);
  g_string_append (text,
                   " ], \"underlay\": { \"image\": \"large.png\", \"width\": 1 } }");
  return cli_write (folder, "picture.quoin", text->str);
}

/* A project whose picture is a pipe that nobody writes to. */
static char *
make_pipe (int count)
{
  (void) count;
  g_autofree char *pipe = g_build_filename (folder, "pipe.png", NULL);
  g_assert_true (mkfifo (pipe, 0600) == 0 || errno == EEXIST);
  g_autoptr (GString) text = g_string_new (PROJECT_HEAD);
  add_block (text, 0, 0, 0, 0);
  g_string_append (text, " ], \"underlay\": { \"image\": \"pipe.png\", \"width\": 1 } }");
  return cli_write (folder, "pipe.quoin", text->str);
}

static char *
make_endless (int count)
{
  (void) count;
  return g_strdup ("/dev/zero");
}

/* More than is read, though it takes no room on the disk. */
static char *
make_sparse (int count)
{
  char *path = cli_write (folder, "sparse.quoin", "{");
  g_assert_cmpint (truncate (path, (off_t) count << 20), ==, 0);
  return path;
}

/* --- The table ------------------------------------------------------------------------------ */

typedef struct Input {
  const char *name;
  char *(*make) (int count);
  int count;
  const char *command;
  int code;
  const char *part; /* of what is said on standard error; nullable */
} Input;

static const Input inputs[] = {
  { "1,000 identical blocks", make_same_blocks, 1000, "check", 3, "blocks overlap" },
  { "10,000 identical blocks", make_same_blocks, 10000, "check", 3, "lie near" },
  { "12 discs of 480 sides", make_discs, 12, "check", 3, "blocks overlap" },
  { "3,000 parallel slabs", make_slabs, 3000, "check", 3, "lie near" },
  { "100,001 voussoirs", make_voussoirs, 100001, "check", 3, "masonry[0].openings" },
  { "name of 100,000 letters", make_long_name, 100000, "report", 0, NULL },
  { "50 circles", make_circles, 50, "import", 0, NULL },
  { "3,000 points together", make_speck, 3000, "import", 3, "no closed outline" },
  { "3,000 random lines", make_lines, 3000, "import", 3, "cross each other" },
  { "20,000 random lines", make_lines, 20000, "import", 3, "cross each other" },
  { "picture of 30,000 x 30,000", make_picture, 30000, "render", 5, "30000 x 30000" },
  { "picture in a pipe", make_pipe, 1, "render", 5, "pipe" },
  { "zeros without end", make_endless, 1, "check", 5, "too large" },
  { "zeros without end as a drawing", make_endless, 1, "import", 5, NULL },
  { "4 GB of nothing", make_sparse, 4096, "check", 5, "too large" },
};

/* Accepted, in proportion to the size. */
static const Input growing[] = {
  { "stones apart", make_apart, 2000, "check", 3, NULL },
  { "wall", make_wall, 1000, "check", 0, NULL },
  { "stones on teeth", make_teeth, 500, "check", 0, NULL },
  { "courses", make_courses, 1000, "check", 3, NULL },
  { "walls", make_walls, 1000, "check", 3, NULL },
  { "bars", make_bars, 1000, "check", 0, NULL },
  { "ties", make_ties, 1000, "check", 0, NULL },
  { "arches", make_arches, 250, "check", 0, NULL },
  { "stages", make_stages, 250, "check", 0, NULL },
  { "cases", make_cases, 250, "check", 0, NULL },
  { "motions", make_motions, 1000, "check", 0, NULL },
  { "samples of a record", make_record, 10000, "check", 0, NULL },
  { "squares", make_grid, 1000, "import", 0, NULL },
  { "unknown keys", make_unknown_keys, 8000, "check", 0, NULL },
  { "recipes", make_recipes, 8000, "figures", 0, NULL },
};

typedef struct Command {
  const char *arguments[8];
  char *path, *output;
} Command;

static Command
command_of (const Input *input, int count)
{
  Command c = { .path = input->make (count),
                .output = g_build_filename (folder, "output", NULL) };
  gboolean import = g_str_equal (input->command, "import");
  gboolean render = g_str_equal (input->command, "render");
  gboolean report = g_str_equal (input->command, "report");
  gboolean figures = g_str_equal (input->command, "figures");
  g_autofree char *named = g_strconcat (c.output,
                                        render   ? ".png"
                                        : report ? ".pdf"
                                                 : ".quoin",
                                        NULL);
  g_free (c.output);
  c.output = g_steal_pointer (&named);
  const char *const arguments[] = { g_getenv ("QUOIN_CLI"), input->command, c.path,
                                    NULL };
  memcpy (c.arguments, arguments, sizeof arguments);
  if (import || render || report) {
    c.arguments[3] = "-o";
    c.arguments[4] = c.output;
  }
  if (figures)
    c.arguments[3] = "--list";
  if (render) {
    c.arguments[5] = "--view";
    c.arguments[6] = "model";
  }
  return c;
}

static void
command_clear (Command *c)
{
  if (g_str_has_prefix (c->path, folder))
    g_remove (c->path);
  g_remove (c->output);
  g_free (c->path);
  g_free (c->output);
}

static void
limit_memory (gpointer data)
{
  (void) data;
  const struct rlimit limit = { MOST_MEMORY, MOST_MEMORY };
  setrlimit (RLIMIT_DATA, &limit);
}

static void
test_memory (gconstpointer data)
{
  const Input *input = data;
  Command c = command_of (input, input->count);
  g_autofree char *said = NULL;
  int status;
  g_assert_true (g_spawn_sync (NULL, (char **) c.arguments, NULL,
                               G_SPAWN_STDOUT_TO_DEV_NULL, limit_memory, NULL, NULL,
                               &said, &status, NULL));
  g_test_message ("%s", said);
  g_assert_true (WIFEXITED (status));
  g_assert_cmpint (WEXITSTATUS (status), ==, input->code);
  if (input->part != NULL)
    g_assert_nonnull (strstr (said, input->part));
  command_clear (&c);
}

static void
test_work (gconstpointer data)
{
  const Input *input = data;
  Command c = command_of (input, input->count);
  int code = -1;
  double instructions = count_program (c.arguments, &code);
  command_clear (&c);
  if (code < 0) {
    g_test_skip ("instructions cannot be counted here");
    return;
  }
  g_test_message ("%s: %.3g instructions", input->name, instructions);
  g_assert_cmpint (code, ==, input->code);
  g_assert_cmpfloat (instructions, >, 1e4); /* something was counted */
  g_assert_cmpfloat (instructions, <, MOST_INSTRUCTIONS);
}

static void
test_growth (gconstpointer data)
{
  const Input *input = data;
  double instructions[2];
  for (int i = 0; i < 2; i++) {
    Command c = command_of (input, (i + 1) * (i + 1) * input->count);
    int code = -1;
    instructions[i] = count_program (c.arguments, &code);
    command_clear (&c);
    if (code < 0) {
      g_test_skip ("instructions cannot be counted here");
      return;
    }
    g_assert_cmpint (code, ==, input->code);
  }
  double growth = log (instructions[1] / instructions[0]) / log (4);
  g_test_message ("%s: %.3g and %.3g instructions, exponent %.2f", input->name,
                  instructions[0], instructions[1], growth);
  g_assert_cmpfloat (instructions[1], <, MOST_INSTRUCTIONS);
  g_assert_cmpfloat (growth, <=, MOST_GROWTH);
}

static void
forget (void)
{
  test_scratch_free (folder);
}

QN_TESTS
{
  folder = test_scratch_new ();
  atexit (forget);
  for (gsize i = 0; i < G_N_ELEMENTS (inputs); i++) {
    g_autofree char *memory = g_strconcat ("/cli/work/memory/", inputs[i].name, NULL);
    g_autofree char *work = g_strconcat ("/cli/work/instructions/", inputs[i].name, NULL);
    g_test_add_data_func (memory, &inputs[i], test_memory);
    g_test_add_data_func (work, &inputs[i], test_work);
  }
  for (gsize i = 0; i < G_N_ELEMENTS (growing); i++) {
    g_autofree char *path = g_strconcat ("/cli/work/growth/", growing[i].name, NULL);
    g_test_add_data_func (path, &growing[i], test_growth);
  }
}
