/* contact2d: the cards of a deck, for programs that process them, to rewrite or to draw a deck. To read a deck into a solver use
   c2d_read_deck of contact2d.h.

     static void show_field(void* context, const c2d_card* card) {
       if (card->kind == C2D_CARD_INTEGER || card->kind == C2D_CARD_REAL)
         fprintf((FILE*)context, "line %d, column %d: %g\n", (int)card->line, (int)card->column, card->value);
     }
*/
#ifndef CONTACT2D_CARDS_H
#define CONTACT2D_CARDS_H

#include "contact2d.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
  C2D_CARD_FREE = 0,          /* the deck is of the free form; comes first                          */
  C2D_CARD_HEADING = 1,       /* a heading card, as it stands                                       */
  C2D_CARD_INTEGER = 2,       /* fields                                                             */
  C2D_CARD_REAL = 3,
  C2D_CARD_LETTER = 4,        /* P in column 1 of a node card                                       */
  C2D_CARD_REMARK = 5,        /* words behind the last field of a fixed card                        */
  C2D_CARD_COMMENT = 6,       /* without its C or !; comes before the card on the same line         */
  C2D_CARD_EXTENSION = 7      /* a keyword card or one below it, as it stands                       */
};
typedef struct c2d_card {
  uint32_t struct_size;
  int32_t kind;               /* C2D_CARD_...                                                       */
  int32_t line;               /* of the deck                                                        */
  int32_t column, width;      /* of the field in the fixed form, also where the deck is of the free form (*FREE) */
  int32_t length;             /* characters in text, which has no zero byte; 0: a field left blank  */
  const char* text;           /* without outer blanks; valid during the call only                   */
  double value;               /* of a field, as the library reads it                                */
} c2d_card;
typedef void (*c2d_card_fn)(void* context, const c2d_card* card);

/* Walks over a deck like c2d_check_deck, without a workspace: `card` receives every field in the order of the deck, `report` every
   fault; either may be null. Discard the fields of a deck with faults. body[0 .. bodies) is work space; its contents are
   undefined afterwards. Errors: ARGUMENT, INPUT, READ; LIMIT: the deck has more bodies than `bodies`, reported as soon as their
   number is read. */
c2d_status c2d_walk_deck(c2d_read_line read, void* context, c2d_body_limits* body, int32_t bodies, c2d_card_fn card,
                         void* card_context, c2d_report report, void* report_context);

#ifdef __cplusplus
}
#endif
#endif
