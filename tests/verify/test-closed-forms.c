/* Textbook statics, linear geometry: the collapse multiplier to 1e-6, of crushed joints to 2.7 %. */
#include "solve.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

/* Dead load, live load to the right, and a multiplier sought far more exactly than usual. */
static double
collapse (QnModel *model)
{
  test_model_add_weight_loads (model, 1);
  model->analysis.multiplier_tolerance = 1e-8;
  return verify_collapse (model);
}

static void
assert_multiplier (double found, double expected)
{
  g_test_message ("found %.9f, expected %.9f", found, expected);
  g_assert_cmpfloat (fabs (found - expected), <=, 1e-6 * expected);
}

/* A low block slides at mu, whatever its friction. */
static void
test_sliding (void)
{
  static const double frictions[] = { 0.1, 0.3, 0.65, 1.2 };
  for (size_t i = 0; i < G_N_ELEMENTS (frictions); i++) {
    QnModel model;
    test_model_init_block_on_plane (&model, 2, 0.5);
    model.laws[0].friction = frictions[i];
    assert_multiplier (collapse (&model), frictions[i]);
  }
}

/* A high block overturns at (b - 2r)/h. */
static void
test_overturning (void)
{
  static const double shapes[][3] = {
    { 0.5, 1, 0 }, { 0.2, 1, 0 }, { 0.3, 0.5, 0 }, { 0.5, 1, 0.05 }, { 0.4, 2, 0.1 }
  };
  for (size_t i = 0; i < G_N_ELEMENTS (shapes); i++) {
    double b = shapes[i][0], h = shapes[i][1], r = shapes[i][2];
    QnModel model;
    test_model_init_block_on_plane (&model, b, h);
    model.contact.pairs.offset = r;
    assert_multiplier (collapse (&model), (b - 2 * r) / h);
  }
}

/* So it does with pairs by area, by default, although they lie between the corners too. */
static void
test_overturning_by_area (void)
{
  for (int count = 0; count <= QN_MOST_LOBATTO_PAIRS; count++) {
    if (count == 1 || count == 2) /* 0: without any rule */
      continue;
    QnModel model;
    test_model_init_block_on_plane (&model, 0.3, 1);
    model.laws[0].basis = QN_BASIS_SURFACE;
    model.contact.pairs.offset = count % 2 == 0 ? 0 : 0.02;
    if (count > 0) {
      model.contact.pairs.placement = QN_PLACEMENT_LOBATTO;
      model.contact.pairs.count = count;
    }
    assert_multiplier (collapse (&model), (0.3 - 2 * model.contact.pairs.offset) / 1);
  }
}

/* A block whose joint is crushed turns about the middle of a stress block of W / (fc t), and overturns
 * at (b - W / (fc t)) / h. The moment of nine Gauss-Lobatto pairs lies 2.7 % below to 1.4 % above that
 * of a stress block. Two end pairs have it rock about a corner until half of the strength is used. */
static void
test_crushing (void)
{
  const double b = 2, h = 20, weight = 10e3 * b * h;
  for (int percent = 5; percent <= 95; percent += 10) {
    double compression = weight / b / (0.01 * percent);
    double exact = (b - weight / compression) / h, found[2];
    for (int ends = 0; ends < 2; ends++) {
      QnModel model;
      test_model_init_block_on_plane (&model, b, h);
      model.laws[0].kind = QN_LAW_MOHR_COULOMB;
      model.laws[0].basis = QN_BASIS_SURFACE;
      model.laws[0].kn = model.laws[0].ks = 1e11;
      model.laws[0].compression = compression;
      if (ends == 1)
        model.contact.pairs.placement = QN_PLACEMENT_ENDS;
      found[ends] = collapse (&model);
    }
    g_test_message ("%d %% of the strength: %.6f, exact %.6f; ends %.6f", percent,
                    found[0], exact, found[1]);
    g_assert_cmpfloat (found[0], >, exact * (1 - 0.027));
    g_assert_cmpfloat (found[0], <, exact * (1 + 0.0141));
    double half = fmin (1, 100. / percent - 1); /* of the joint's length as lever */
    g_assert_cmpfloat_with_epsilon (found[1], half * b / h, 1e-6);
  }
}

/* A column of n blocks overturns as one at its base, at b/H. */
static void
test_stack (void)
{
  for (int count = 1; count <= 5; count++) {
    QnModel model;
    test_model_init_stack (&model, count, 0.4, 0.25);
    assert_multiplier (collapse (&model), fmin (0.65, 0.4 / (0.25 * count)));
  }
}

/* Under dead load alone each joint carries the blocks above it, half at each end. */
static void
test_stack_joint_forces (void)
{
  enum { COUNT = 4 };
  Solved solved;
  QnModel model;
  test_model_init_stack (&model, COUNT, 0.4, 0.25);
  test_model_add_weight_loads (&model, 1);
  model.analysis.max_multiplier = 1e-12;
  verify_solve (&solved, &model);

  double weight = solved.model.blocks[1].weight;
  g_assert_cmpuint (solved.contacts.face_count, ==, COUNT);
  for (size_t i = 0; i < solved.contacts.face_count; i++) {
    const QnContactFace *face = &solved.contacts.faces[i];
    double above = weight * (COUNT - MIN (face->a, face->b));
    for (int32_t k = 0; k < face->pair_count; k++) {
      const QnPairResult *pair = &solved.result.pairs[face->first_pair + k];
      g_assert_cmpfloat_with_epsilon (pair->normal_force, -above / 2, 1e-6 * weight);
      g_assert_cmpfloat_with_epsilon (pair->shear_force, 0, 1e-6 * weight);
    }
  }
  verify_clear (&solved);
}

/* On a plane that falls at an angle theta in the load's direction: tan (phi - theta). Turning
 * the structure turns its loads with it, so they are set to the world's axes afterwards. */
static void
test_slope (void)
{
  static const double angles[] = { 0.1, 0.3, 0.5 };
  double phi = atan (0.65);
  for (size_t i = 0; i < G_N_ELEMENTS (angles); i++) {
    QnModel model;
    test_model_init_block_on_plane (&model, 2, 0.5);
    test_model_rotate (&model, -angles[i]);
    assert_multiplier (collapse (&model), tan (phi - angles[i]));
  }
}

/* Blocks side by side that push each other slide together at mu. */
static void
test_chain (void)
{
  for (int count = 2; count <= 3; count++) {
    QnModel model;
    test_model_init (&model);
    test_model_add_base (&model, -1, -0.5, 8, 0.5);
    for (int i = 0; i < count; i++) {
      g_autofree char *name = g_strdup_printf ("b%d", i + 1);
      test_model_add_rectangle (&model, name, i, 0, 1, 0.4);
    }
    assert_multiplier (collapse (&model), 0.65);
  }
}

/* A slender block (b x h, weight W) leans against the smooth side of a low one (height s,
 * weight G) and pushes it with a force N at its upper edge, while it turns about its own lower
 * corner: lambda W h/2 = W b/2 + N s. The low one slides: lambda G + N = mu G. */
static void
test_leaning (void)
{
  const double b = 0.2, h = 1, side = 0.5, mu = 0.65;
  QnModel model;
  test_model_init (&model);
  QnLaw *smooth = qn_model_add_law (&model, "smooth");
  smooth->kind = QN_LAW_COULOMB;
  smooth->kn = smooth->ks = 1e7;
  test_model_add_base (&model, -1, -0.5, 4, 0.5);
  test_model_add_rectangle (&model, "slender", 0, 0, b, h);
  test_model_add_rectangle (&model, "low", b, 0, 1, side);
  QnFaceOverride *override = qn_model_add_override (&model);
  override->block_a = 1;
  override->block_b = 2;
  override->law = 1;

  double weight = 10000 * b * h, low = 10000 * side;
  double expected = (weight * b / 2 + mu * low * side) / (weight * h / 2 + low * side);
  assert_multiplier (collapse (&model), expected);
}

QN_TESTS
{
  g_test_add_func ("/verify/closed-forms/sliding", test_sliding);
  g_test_add_func ("/verify/closed-forms/overturning", test_overturning);
  g_test_add_func ("/verify/closed-forms/overturning-by-area", test_overturning_by_area);
  g_test_add_func ("/verify/closed-forms/crushing", test_crushing);
  g_test_add_func ("/verify/closed-forms/stack", test_stack);
  g_test_add_func ("/verify/closed-forms/stack-joint-forces", test_stack_joint_forces);
  g_test_add_func ("/verify/closed-forms/slope", test_slope);
  g_test_add_func ("/verify/closed-forms/chain", test_chain);
  g_test_add_func ("/verify/closed-forms/leaning", test_leaning);
}
