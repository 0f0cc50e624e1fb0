#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "schemes/algebra/matrix.h"

namespace subdiv {

/// A finite sequence w_1 .. w_k of indices into a family of matrices T_0 .. T_{m-1}. It stands for the
/// product T_{w_k} .. T_{w_1}, in which w_1 acts first.
using Word = std::vector<int>;

/// "0011"; letters above 9 are separated: "3.11.0".
[[nodiscard]] std::string word_text(const Word& word);

/// T_{w_k} .. T_{w_1}; the empty word gives the identity.
template <class M>
M product(const std::vector<M>& family, const Word& word) {
  M result = M::Identity(family[0].rows(), family[0].cols());
  for (const int letter : word) result = (family[static_cast<std::size_t>(letter)] * result).eval();
  return result;
}

/// The products of all words of a length >= 0.
template <class M>
std::vector<M> all_products(const std::vector<M>& family, int length) {
  std::vector<M> result{M::Identity(family[0].rows(), family[0].cols())};
  for (int i = 0; i < length; ++i) {
    std::vector<M> longer;
    for (const M& p : result) {
      for (const M& t : family) longer.push_back(t * p);
    }
    result = std::move(longer);
  }
  return result;
}

/// The least rotation of the word's primitive root: "1010" gives "01". Products of words with the same root
/// have the same spectral radius^(1/length).
[[nodiscard]] Word primitive_rotation(const Word& word);

/// The next Lyndon word of at most `longest` letters after the given one in lexicographic order (Duval 1988);
/// start with the empty word, which also marks the end. Lyndon words are strictly less than all their proper
/// rotations: one from each class of primitive words up to rotation.
[[nodiscard]] Word next_lyndon_word(Word word, int letters, int longest);

}  // namespace subdiv
