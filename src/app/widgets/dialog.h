/* Windows that ask something: over their parent, closed by Escape. */
#pragma once

#include <gtk/gtk.h>

/* Popovers that are open when the window goes close with it. GTK 4.8 takes them from the screen only:
 * they would keep the pointer and the keys, and stay in memory. A popover that closes alone gives the keys
 * back. */
void qn_popovers_attend (GtkWidget *window);

/* Escape closes the window, and popovers that close give their keys back; qn_builder_new() does it. */
void qn_dialog_attend (GtkWidget *window);

/* Shows it over its parent with the focus on the button that takes what it offers, for Return. `help`: the page
 * of the manual about it, or NULL. */
void qn_dialog_present (GtkWidget *dialog, GtkWindow *parent, const char *help,
                        GtkWidget *accept);

/* A modal question about something that may be lost. REJECT loses it; CANCEL, also by Escape and by closing,
 * keeps it; ACCEPT is the button that Return presses. Texts are translated; without `reject` or `accept` there
 * is no such button. `more` is shown below the text, or NULL. It is called "question", for the style. */
typedef enum { QN_ANSWER_CANCEL, QN_ANSWER_REJECT, QN_ANSWER_ACCEPT } QnAnswer;
typedef void (*QnAnswered) (QnAnswer answer, gpointer data);
void qn_dialog_ask (GtkWindow *parent, const char *question, const char *consequence,
                    const char *reject, const char *accept, GtkWidget *more,
                    QnAnswered answered, gpointer data);
