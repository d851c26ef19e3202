#include "core/contacts.h"
#include "support/models.h"

#include <glib.h>

/* The six walls as published: blocks and faces. */
static void
test_published_walls (void)
{
  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    QnModel model;
    QnContacts contacts;
    test_model_init_wall (&model, number, 0);
    g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
    g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
    g_assert_cmpuint (model.block_count, ==, test_walls[number - 1].blocks + 1);
    g_assert_cmpuint (contacts.face_count, ==, test_walls[number - 1].faces);
    g_assert_cmpuint (contacts.pair_count, ==, 2 * contacts.face_count);
    g_assert_cmpuint (contacts.findings.count, ==, 0);
    g_assert_cmpint (qn_contacts_require_sound (&model, &contacts, NULL), ==, QN_OK);
    qn_contacts_clear (&contacts);
    qn_model_clear (&model);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/contacts/published-walls", test_published_walls);
  return g_test_run ();
}
