#pragma once
#include "report/run_record.hpp"

namespace towform {

/// A block of packed numbers of the page.
struct SceneBlock {
  std::string id, text;
};

/// What the 3-D view is given: a description and the blocks that it names.
struct Scene {
  nlohmann::ordered_json description;
  std::vector<SceneBlock> blocks;
  std::vector<std::string> notes; ///< sentences: what was left out and why

  [[nodiscard]] std::size_t bytes() const;
};

/// Packs sheet, fields and tools. Frames are thinned, the last one kept, until the blocks take no more than
/// `limit` bytes; a note says so. Throws FileError.
Scene make_scene(const RunRecord& run, const ResultsFrames& frames, std::size_t limit);

} // namespace towform
