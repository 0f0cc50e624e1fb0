// Compiles the project's declarations of Calcium after Calcium's own: a difference is an error of the
// compiler.

#include <stddef.h>

#include <calcium/fmpz_mpoly_q.h>
#include <calcium/qqbar.h>

#include "schemes/algebra/calcium.h"

// The project's own structures, under other names, next to the real ones.
typedef struct {
  fmpz_poly_struct poly;
  acb_struct enclosure;
} qqbar_copy;
typedef struct {
  fmpz_mpoly_struct num;
  fmpz_mpoly_struct den;
} fmpz_mpoly_q_copy;

_Static_assert(sizeof(qqbar_copy) == sizeof(qqbar_struct), "size of qqbar_struct");
_Static_assert(offsetof(qqbar_copy, poly) == offsetof(qqbar_struct, poly), "place of qqbar_struct.poly");
_Static_assert(offsetof(qqbar_copy, enclosure) == offsetof(qqbar_struct, enclosure),
               "place of qqbar_struct.enclosure");
_Static_assert(sizeof(fmpz_mpoly_q_copy) == sizeof(fmpz_mpoly_q_struct), "size of fmpz_mpoly_q_struct");
_Static_assert(offsetof(fmpz_mpoly_q_copy, num) == offsetof(fmpz_mpoly_q_struct, num), "place of numerators");
_Static_assert(offsetof(fmpz_mpoly_q_copy, den) == offsetof(fmpz_mpoly_q_struct, den),
               "place of denominators");
_Static_assert(QQBAR_ROOTS_IRREDUCIBLE == 1, "the flag that real_roots passes");
