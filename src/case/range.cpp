#include "range.hpp"
#include <stdexcept>

namespace towform {

namespace {
double number_in(const std::string& text, Dimension dimension)
{
  // A limit without a unit is a plain number or zero of any unit.
  Quantity limit = read_quantity(text, dimension);
  if (!limit.problem.empty()) limit = read_quantity(text, Dimension::none);
  if (!limit.problem.empty()) throw std::logic_error("range limit `" + text + "` " + limit.problem);
  return limit.value;
}
} // namespace

Range::Range(std::string text, Dimension dimension) : text_(std::move(text))
{
  const std::size_t dots = text_.find(" .. ");
  if (dots != std::string::npos) {
    low_ = number_in(text_.substr(0, dots), dimension);
    high_ = number_in(text_.substr(dots + 4), dimension);
    return;
  }
  for (std::size_t start = 0; start < text_.size();) {
    const std::size_t comma = std::min(text_.find(", ", start), text_.size());
    limit(text_.substr(start, comma - start), dimension);
    start = comma + 2;
  }
}

void Range::limit(const std::string& part, Dimension dimension)
{
  const bool equal = part.size() > 1 && part[1] == '=';
  const double value = number_in(part.substr(equal ? 2 : 1), dimension);
  if (part[0] == '>') {
    low_ = value;
    without_low_ = !equal;
  } else if (part[0] == '<') {
    high_ = value;
    without_high_ = !equal;
  } else {
    throw std::logic_error("range `" + text_ + "`");
  }
}

bool Range::contains(double value) const
{
  if (without_low_ ? value <= low_ : value < low_) return false;
  return without_high_ ? value < high_ : value <= high_;
}

} // namespace towform
