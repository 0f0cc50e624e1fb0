#include "schemes/evaluate/patch_kernel.h"

// Highway compiles this file once for each instruction set and chooses among the results at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "schemes/evaluate/patch_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace subdiv::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, patch_line>;

/// Some lanes of a line: points lane .. lane + Lanes - 1.
HWY_INLINE void lanes_of_line(const double* HWY_RESTRICT weights, const double* HWY_RESTRICT controls,
                              std::size_t count, double* HWY_RESTRICT out) {
  const Tag tag;
  auto x = hn::Zero(tag);
  auto y = hn::Zero(tag);
  auto z = hn::Zero(tag);
  for (std::size_t k = 0; k < count; ++k) {
    const auto weight = hn::Load(tag, weights + k * patch_line);
    x = hn::Add(x, hn::Mul(weight, hn::Set(tag, controls[3 * k])));
    y = hn::Add(y, hn::Mul(weight, hn::Set(tag, controls[3 * k + 1])));
    z = hn::Add(z, hn::Mul(weight, hn::Set(tag, controls[3 * k + 2])));
  }
  hn::StoreInterleaved3(x, y, z, tag, out);
}

void apply(const PatchTable& table, const double* HWY_RESTRICT controls, std::size_t first, std::size_t last,
           double* HWY_RESTRICT out) {
  const std::size_t lanes = hn::Lanes(Tag());
  const std::size_t count = table.controls.size();
  for (std::size_t line = first; line < last; ++line) {
    const double* weights = table.weights.data() + line * count * patch_line;
    for (std::size_t lane = 0; lane < patch_line; lane += lanes)
      lanes_of_line(weights + lane, controls, count, out + 3 * lane);
    out += 3 * patch_line;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace subdiv::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace subdiv::detail {

HWY_EXPORT(apply);

void apply_patch_table(const PatchTable& table, const double* controls, std::size_t first, std::size_t last,
                       double* out) {
  HWY_DYNAMIC_DISPATCH(apply)(table, controls, first, last, out);
}

}  // namespace subdiv::detail
#endif
