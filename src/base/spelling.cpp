#include "base/spelling.h"

#include <algorithm>
#include <cstddef>

namespace anamorph {
namespace {

constexpr std::size_t longestWord = 40;  // bytes; nobody means a longer one

std::string folded(std::string_view word) {
  std::string lower(word);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

// How many letters have to be left out, added, changed or swapped with their neighbour (Damerau and Levenshtein).
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before, above, row(b.size() + 1);
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = above;
    above = row;
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1])});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

std::string nearestWord(std::string_view word, const std::vector<std::string>& known) {
  if (word.size() > longestWord) return "";
  const std::string wanted = folded(word);
  std::string nearest;
  std::size_t least =
      std::max<std::size_t>(1, (word.size() + 1) / 3);  // about every third letter may be wrong
  for (const std::string& candidate : known) {
    if (candidate.size() > longestWord) continue;
    const std::size_t far = distance(wanted, folded(candidate));
    if (far > least || far >= candidate.size() || (far == least && !nearest.empty())) continue;
    nearest = candidate;
    least = far;
  }
  return nearest;
}

std::string didYouMean(std::string_view word, const std::vector<std::string>& known) {
  const std::string meant = nearestWord(word, known);
  return meant.empty() ? "" : "; did you mean \"" + meant + "\"?";
}

}  // namespace anamorph
