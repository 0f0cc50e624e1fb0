#include "analysis/jsr/word.h"

#include <algorithm>

namespace subdiv {

std::string word_text(const Word& word) {
  const bool wide = std::any_of(word.begin(), word.end(), [](int letter) { return letter > 9; });
  std::string text;
  for (const int letter : word) {
    if (wide && !text.empty()) text += '.';
    text += std::to_string(letter);
  }
  return text;
}

Word primitive_rotation(const Word& word) {
  Word least = word;
  Word rotated = word;
  std::size_t period = word.size();
  for (std::size_t i = 1; i <= word.size(); ++i) {
    std::rotate(rotated.begin(), rotated.begin() + 1, rotated.end());
    if (rotated == word) {
      period = i;
      break;
    }
    least = std::min(least, rotated);
  }
  least.resize(period);
  return least;
}

Word next_lyndon_word(Word word, int letters, int longest) {
  const std::size_t period = word.size();
  if (period == 0) return {0};
  while (word.size() < static_cast<std::size_t>(longest)) word.push_back(word[word.size() - period]);
  while (!word.empty() && word.back() == letters - 1) word.pop_back();
  if (!word.empty()) ++word.back();
  return word;
}

}  // namespace subdiv
