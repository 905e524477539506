#include "suggestion.hpp"
#include <algorithm>
#include <cctype>

namespace towform {

int edit_distance(const std::string& a, const std::string& b)
{
  // Optimal string alignment on three rows: two before and the current one.
  const std::size_t n = b.size();
  std::vector<int> before(n + 1), above(n + 1), row(n + 1);
  for (std::size_t j = 0; j <= n; ++j) above[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= n; ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    std::swap(before, above);
    std::swap(above, row);
  }
  return above[n];
}

namespace {
std::string lower(std::string text)
{
  for (char& c : text) c = c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}
} // namespace

std::string nearest(const std::string& word, const std::vector<std::string>& choices)
{
  if (word.size() > 100) return "";
  std::string best;
  int least = std::max(1, static_cast<int>(word.size()) / 3) + 1;
  for (const std::string& choice : choices) {
    const int distance = edit_distance(lower(word), lower(choice));
    // A short word is far from everything: one letter in three must stay.
    if (distance < least && distance < static_cast<int>(choice.size())) {
      least = distance;
      best = choice;
    }
  }
  return best;
}

std::string did_you_mean(const std::string& choice)
{
  return choice.empty() ? "" : "; did you mean `" + choice + "`?";
}

std::string listed(const std::vector<std::string>& words, const std::string& last)
{
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " " + last + " " : ", ";
    text += words[i];
  }
  return text;
}

} // namespace towform
