#pragma once

#include <acb.h>
#include <flint/fmpq.h>
#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_poly.h>

// The part of Calcium 0.4 that is used here. Calcium's own headers are C only: their inline functions rely on
// implicit conversions from void*, which C++ forbids. tests/schemes/algebra/calcium_declarations.c compiles
// these lines after the real headers, so that a difference is an error.

#ifdef __cplusplus
extern "C" {
#endif

#ifndef QQBAR_H
typedef struct {
  fmpz_poly_struct poly;  // the minimal polynomial
  acb_struct enclosure;   // a ball that isolates the root
} qqbar_struct;
typedef qqbar_struct qqbar_t[1];
typedef qqbar_struct* qqbar_ptr;
#endif

void qqbar_init(qqbar_t res);
void qqbar_clear(qqbar_t res);
void qqbar_swap(qqbar_t x, qqbar_t y);
void qqbar_set(qqbar_t res, const qqbar_t x);
void qqbar_set_si(qqbar_t res, slong x);
void qqbar_set_fmpq(qqbar_t res, const fmpq_t x);
int qqbar_sgn_re(const qqbar_t x);
int qqbar_sgn_im(const qqbar_t x);
void qqbar_get_fmpq(fmpq_t res, const qqbar_t x);
int qqbar_equal(const qqbar_t x, const qqbar_t y);
int qqbar_cmp_re(const qqbar_t x, const qqbar_t y);
void qqbar_neg(qqbar_t res, const qqbar_t x);
void qqbar_add(qqbar_t res, const qqbar_t x, const qqbar_t y);
void qqbar_sub(qqbar_t res, const qqbar_t x, const qqbar_t y);
void qqbar_mul(qqbar_t res, const qqbar_t x, const qqbar_t y);
void qqbar_div(qqbar_t res, const qqbar_t x, const qqbar_t y);
void qqbar_cos_pi(qqbar_t res, slong p, ulong q);
void qqbar_root_ui(qqbar_t res, const qqbar_t x, ulong n);
void qqbar_get_arb(arb_t res, const qqbar_t x, slong prec);
void qqbar_get_quadratic(fmpz_t a, fmpz_t b, fmpz_t c, fmpz_t q, const qqbar_t x, int factoring);
void qqbar_roots_fmpz_poly(qqbar_ptr res, const fmpz_poly_t poly, int flags);

#ifndef FMPZ_MPOLY_Q_H
typedef struct {
  fmpz_mpoly_struct num;
  fmpz_mpoly_struct den;
} fmpz_mpoly_q_struct;
typedef fmpz_mpoly_q_struct fmpz_mpoly_q_t[1];
#endif

void fmpz_mpoly_q_init(fmpz_mpoly_q_t res, const fmpz_mpoly_ctx_t ctx);
void fmpz_mpoly_q_clear(fmpz_mpoly_q_t res, const fmpz_mpoly_ctx_t ctx);
void fmpz_mpoly_q_swap(fmpz_mpoly_q_t x, fmpz_mpoly_q_t y, const fmpz_mpoly_ctx_t ctx);
void fmpz_mpoly_q_set(fmpz_mpoly_q_t res, const fmpz_mpoly_q_t x, const fmpz_mpoly_ctx_t ctx);
void fmpz_mpoly_q_set_fmpq(fmpz_mpoly_q_t res, const fmpq_t x, const fmpz_mpoly_ctx_t ctx);
void fmpz_mpoly_q_set_si(fmpz_mpoly_q_t res, slong x, const fmpz_mpoly_ctx_t ctx);
void fmpz_mpoly_q_canonicalise(fmpz_mpoly_q_t x, const fmpz_mpoly_ctx_t ctx);
int fmpz_mpoly_q_equal(const fmpz_mpoly_q_t x, const fmpz_mpoly_q_t y, const fmpz_mpoly_ctx_t ctx);
void fmpz_mpoly_q_add(fmpz_mpoly_q_t res, const fmpz_mpoly_q_t x, const fmpz_mpoly_q_t y,
                      const fmpz_mpoly_ctx_t ctx);
void fmpz_mpoly_q_sub(fmpz_mpoly_q_t res, const fmpz_mpoly_q_t x, const fmpz_mpoly_q_t y,
                      const fmpz_mpoly_ctx_t ctx);
void fmpz_mpoly_q_mul(fmpz_mpoly_q_t res, const fmpz_mpoly_q_t x, const fmpz_mpoly_q_t y,
                      const fmpz_mpoly_ctx_t ctx);
void fmpz_mpoly_q_div(fmpz_mpoly_q_t res, const fmpz_mpoly_q_t x, const fmpz_mpoly_q_t y,
                      const fmpz_mpoly_ctx_t ctx);

#ifdef __cplusplus
}
#endif
