#pragma once
#include <string>
#include <vector>

namespace towform {

/// Fewest insertions, deletions, replacements and swaps of neighbours that turn a into b.
int edit_distance(const std::string& a, const std::string& b);

/// The choice nearest to `word`, or empty when none is near enough to be meant.
std::string nearest(const std::string& word, const std::vector<std::string>& choices);

/// "; did you mean `choice`?", or empty.
std::string did_you_mean(const std::string& choice);

/// "a, b or c".
std::string listed(const std::vector<std::string>& words, const std::string& last = "or");

} // namespace towform
