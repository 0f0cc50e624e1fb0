#include "analysis/mesh/exact_condition.h"

#include <cstddef>
#include <vector>

#include "analysis/eigenvalues.h"
#include "analysis/mesh/mesh_condition.h"

namespace subdiv {

Decision exact_condition(const MeshScheme<Rational>& scheme, int valence) {
  const Matrix<Rational> matrix = full_matrix(fan_matrix(scheme, valence, eigenvalue_rings(scheme)));
  const std::vector<Eigenvalue> all = eigenvalues(matrix);  // by decreasing modulus
  const Algebraic one(1);
  std::vector<const Eigenvalue*> others;
  for (const Eigenvalue& e : all) {
    if (e.exact && *e.exact == one) {
      if (e.multiplicity > 1) return Decision::no;
    } else {
      others.push_back(&e);
    }
  }
  if (others.size() < 2 || !others[0]->exact) return Decision::undecided;
  const Algebraic largest = abs(*others[0]->exact);
  if (others[0]->multiplicity != 2 || others[0]->exact->sign() < 0) return Decision::no;
  return others[1]->exact && abs(*others[1]->exact) == largest ? Decision::no : Decision::undecided;
}

}  // namespace subdiv
