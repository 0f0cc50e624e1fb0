#include "analysis/jsr/word.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

TEST(Word, HasAText) {
  EXPECT_EQ(word_text({0, 0, 1, 1}), "0011");
  EXPECT_EQ(word_text({3, 11, 0}), "3.11.0");
  EXPECT_EQ(word_text({}), "");
}

TEST(Word, StandsForAProductWhoseFirstLetterActsFirst) {
  Matrix<Rational> a = identity_matrix<Rational>(2);
  a(0, 1) = Rational(1);
  Matrix<Rational> b = identity_matrix<Rational>(2);
  b(1, 1) = Rational(3);
  EXPECT_TRUE(product(std::vector{a, b}, {0, 1}) == Matrix<Rational>(b * a));
  EXPECT_TRUE(product(std::vector{a, b}, {}) == identity_matrix<Rational>(2));
}

TEST(Word, PrimitiveRotation) {
  EXPECT_EQ(primitive_rotation({1, 0, 1, 0}), (Word{0, 1}));
  EXPECT_EQ(primitive_rotation({1, 1, 0}), (Word{0, 1, 1}));
  EXPECT_EQ(primitive_rotation({0, 0, 0}), (Word{0}));
  EXPECT_EQ(primitive_rotation({1, 0, 0, 1, 0}), (Word{0, 0, 1, 0, 1}));
}

TEST(Word, LyndonWordsAreOneFromEachClass) {
  for (const int letters : {1, 2, 3}) {
    const int longest = letters == 2 ? 8 : 5;
    std::set<Word> found;
    Word previous;
    for (Word w = next_lyndon_word({}, letters, longest); !w.empty();
         w = next_lyndon_word(w, letters, longest)) {
      EXPECT_LT(previous, w);
      EXPECT_EQ(primitive_rotation(w), w);
      found.insert(w);
      previous = w;
    }
    // Every word at all has its primitive rotation among them.
    std::set<Word> expected;
    std::vector<Word> words{{}};
    for (int length = 1; length <= longest; ++length) {
      std::vector<Word> longer;
      for (const Word& w : words) {
        for (int letter = 0; letter < letters; ++letter) {
          longer.push_back(w);
          longer.back().push_back(letter);
          expected.insert(primitive_rotation(longer.back()));
        }
      }
      words = std::move(longer);
    }
    EXPECT_EQ(found, expected) << letters;
  }
}

}  // namespace
}  // namespace subdiv
