#include "element/membrane_batches.hpp"
#include <algorithm>
#include <array>

namespace towform {

class MembraneBatches::Maker {
public:
  Maker(MembraneBatches& all, std::span<const int> shape, std::span<const FlatTriangle> elements)
      : all_(all), shape_(shape), elements_(elements),
        of_shape_(shape.empty() ? 0 : static_cast<std::size_t>(*std::max_element(shape.begin(), shape.end()) + 1), -1)
  {
  }

  /// Batches of a block's places from `begin` to `end`, which these elements have.
  void add(std::span<const int> element, int begin, int end)
  {
    constexpr int few = 8; // elements of a shape, which had better go with others
    const auto run_end = [&](int from) {
      int to = from + 1;
      while (to < end && shape_[element[to]] == shape_[element[from]]) ++to;
      return to;
    };
    const auto is_run = [&](int from) { return shape_[element[from]] >= 0 && run_end(from) - from >= few; };
    for (int at = begin; at < end;) {
      int to = run_end(at);
      if (is_run(at)) {
        const int first = first_of_shape(element[at]);
        for (; at < to; at += size) all_.batches_.push_back({at, std::min(size, to - at), first, size});
        at = to;
        continue;
      }
      while (to < end && !is_run(to)) to = run_end(to);
      for (; at < to; at += size) add_mixed(element, at, std::min(size, to - at));
      at = to;
    }
  }

private:
  static constexpr int size = MembraneBatch::size;

  /// Where the coefficients of an element's shape begin, each as often as a batch has places.
  int first_of_shape(int element)
  {
    int& first = of_shape_[static_cast<std::size_t>(shape_[element])];
    if (first < 0) {
      first = static_cast<int>(all_.coefficients_.size());
      for (const double of_all : coefficients_of(element)) all_.coefficients_.insert(all_.coefficients_.end(), size, of_all);
    }
    return first;
  }

  void add_mixed(std::span<const int> element, int begin, int count)
  {
    all_.batches_.push_back({begin, count, static_cast<int>(all_.coefficients_.size()), count});
    for (std::size_t k = 0; k < 5; ++k)
      for (int i = begin; i < begin + count; ++i) all_.coefficients_.push_back(coefficients_of(element[i])[k]);
  }

  [[nodiscard]] std::array<double, 5> coefficients_of(int element) const
  {
    const auto& [g, area] = elements_[element];
    return {g.warp_1, g.warp_2, g.weft_1, g.weft_2, area};
  }

  MembraneBatches& all_;
  std::span<const int> shape_;
  std::span<const FlatTriangle> elements_;
  std::vector<int> of_shape_;
};

MembraneBatches::MembraneBatches(const ElementBlocks& blocks, std::span<const int> shape, std::span<const FlatTriangle> elements)
{
  Maker maker(*this, shape, elements);
  const auto begin_part = [&] { first_.push_back(static_cast<int>(batches_.size())); };
  for (const ElementBlocks::Block& b : blocks.blocks) {
    const std::span<const int> places =
        std::span<const int>(blocks.element).subspan(static_cast<std::size_t>(b.first_place), static_cast<std::size_t>(b.places));
    begin_part();
    maker.add(places, 0, b.own);
    begin_part();
    maker.add(places, b.own, b.places);
  }
  begin_part();
  batches_.shrink_to_fit();
  coefficients_.shrink_to_fit();
}

} // namespace towform
