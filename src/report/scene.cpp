#include "report/scene.hpp"
#include "parallel/parallel.hpp"
#include "report/quantised.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <future>

namespace towform {

namespace {

using Json = nlohmann::ordered_json;

/// A field as the view shows it: names for people, and the factor to the unit shown.
struct ShownField {
  const char *name, *label, *units;
  double factor, shift;
  const char *first = "", *second = ""; ///< of fields with two components
};

constexpr ShownField shown_fields[] = {
    {"shear_angle", "Shear angle", "°", 1.0, 0.0},
    {"shear_rate", "Shear rate", "rad/s", 1.0, 0.0},
    {"curve_index", "Curve indicator", "", 1.0, 0.0},
    {"thickness", "Thickness", "mm", 1e3, 0.0},
    {"fibre_strain", "Yarn strain", "%", 1e2, 0.0, "warp", "weft"},
    {"shear_force", "Shear force", "N/m", 1.0, 0.0},
    {"curvature", "Curvature", "1/m", 1.0, 0.0, "along warp", "along weft"},
    {"clearance", "Clearance from tools", "mm", 1e3, 0.0},
    {"contact_pressure", "Contact pressure", "kPa", 1e-3, 0.0},
    {"temperature", "Temperature", "°C", 1.0, -273.15},
};

class SceneMaker {
public:
  SceneMaker(const RunRecord& run, const ResultsFrames& frames, std::size_t stride)
      : run_(run), frames_(frames)
  {
    for (std::size_t f = 0; f < frames.size(); ++f)
      if ((frames.size() - 1 - f) % stride == 0) chosen_.push_back(f);
  }

  Scene make()
  {
    const SheetResult& sheet = run_.sheet;
    Json& d = scene_.description;
    d["nodes"] = sheet.flat.points.size();
    d["elements"] = sheet.flat.triangles.size();
    d["frames"] = chosen_;
    for (const std::size_t f : chosen_) d["times"].push_back(frames_.times()[f]);
    const bool x = run_.run_case && (run_.run_case->blank.symmetry == Symmetry::x ||
                                     run_.run_case->blank.symmetry == Symmetry::quarter);
    const bool y = run_.run_case && (run_.run_case->blank.symmetry == Symmetry::y ||
                                     run_.run_case->blank.symmetry == Symmetry::quarter);
    d["mirror"] = {x, y};
    d["triangles"] = corners("triangles", sheet.flat.triangles);
    d["reference"] = places("reference", sheet.flat.points);
    d["yarns"] = {yarn("fibre_1"), yarn("fibre_2")};
    d["position"] = series("position");
    add_fields();
    add_tools();
    finish_packing();
    return std::move(scene_);
  }

private:
  void add_fields()
  {
    Json& list = scene_.description["fields"] = Json::array();
    for (const ShownField& shown : shown_fields) {
      const FrameField* field = frames_.find(shown.name);
      if (field == nullptr) continue;
      Json entry = series(shown.name);
      entry["name"] = shown.name;
      entry["label"] = shown.label;
      entry["units"] = shown.units;
      entry["factor"] = shown.factor;
      entry["shift"] = shown.shift;
      entry["nodal"] = field->rows == run_.sheet.flat.points.size();
      if (field->components == 2) entry["parts"] = {shown.first, shown.second};
      list.push_back(std::move(entry));
    }
  }

  void add_tools()
  {
    Json& list = scene_.description["tools"] = Json::array();
    if (!run_.run_case) return;
    const Case& c = *run_.run_case;
    ToolSurfaces surfaces = read_tool_surfaces(c, frames_.text("inputs"));
    scene_.notes.insert(scene_.notes.end(), surfaces.gaps.begin(), surfaces.gaps.end());
    for (std::size_t i = 0; i < c.tools.size(); ++i) {
      if (!surfaces.meshes[i]) continue;
      const std::string id = fmt::format("tool-{}", i);
      const Vec3 way = direction_of(c.tools[i]);
      Json tool{{"name", c.tools[i].name},
                {"direction", {way.x, way.y, way.z}},
                {"points", places(id + "-points", surfaces.meshes[i]->points)},
                {"triangles", corners(id + "-triangles", surfaces.meshes[i]->triangles)}};
      for (const std::size_t f : chosen_)
        tool["displacement"].push_back(
            run_.at(fmt::format("position_{}_m", c.tools[i].name), frames_.times()[f]).value_or(0.0));
      list.push_back(std::move(tool));
    }
  }

  /// The field over the chosen frames; two passes over the file, so that one block is read at a time.
  Json series(const std::string& name)
  {
    const FrameField& field = *frames_.find(name);
    ComponentRanges ranges(field.components);
    for (const std::size_t f : chosen_) ranges.add(frames_.values(f, field));
    Quantised quantised = ranges.scale();
    quantised.q.reserve(chosen_.size() * field.rows * field.components);
    for (const std::size_t f : chosen_) add_frame(quantised, frames_.values(f, field));
    return block(name, std::move(quantised), field.rows);
  }

  Json places(const std::string& id, const std::vector<Vec3>& points)
  {
    std::vector<double> numbers;
    for (const Vec3& p : points) numbers.insert(numbers.end(), {p.x, p.y, p.z});
    ComponentRanges ranges(3);
    ranges.add(numbers);
    Quantised quantised = ranges.scale();
    add_frame(quantised, numbers);
    return block(id, std::move(quantised), points.size());
  }

  Json block(const std::string& id, Quantised quantised, std::size_t rows)
  {
    const std::size_t components = quantised.offset.size();
    Json entry{{"block", id}, {"rows", rows}, {"offset", quantised.offset}, {"step", quantised.step}};
    const bool constant =
        std::all_of(quantised.step.begin(), quantised.step.end(), [](double step) { return step == 0.0; });
    if (constant &&
        std::find(quantised.q.begin(), quantised.q.end(), Quantised::missing) == quantised.q.end())
      entry["constant"] = true; // the offsets say it all
    else
      pack(id, [q = std::move(quantised.q), components, rows] { return packed(q, components, rows * components); });
    return entry;
  }

  /// Packs a block while the next one is read, where there is a thread to do so.
  template <class Make>
  void pack(const std::string& id, Make make)
  {
    finish_packing();
    scene_.blocks.push_back({id, {}});
    packing_ = std::async(threads() > 1 ? std::launch::async : std::launch::deferred, std::move(make));
  }
  void finish_packing()
  {
    if (packing_.valid()) scene_.blocks.back().text = packing_.get();
  }

  Json corners(const std::string& id, const std::vector<Triangle>& triangles)
  {
    std::vector<std::uint32_t> numbers;
    for (const Triangle& t : triangles)
      for (const int n : t) numbers.push_back(static_cast<std::uint32_t>(n));
    pack(id, [numbers = std::move(numbers)] { return packed(numbers); });
    return {{"block", id}, {"rows", triangles.size()}};
  }

  /// The direction of a yarn family on the flat blank: what the first frame's is, carried back by the mesh.
  Json yarn(const std::string& name)
  {
    const FrameField *fibre = frames_.find(name), *position = frames_.find("position");
    if (fibre == nullptr || position == nullptr) return nullptr;
    const std::vector<double> directions = frames_.values(0, *fibre), x = frames_.values(0, *position);
    const auto place = [&](int n) { return Vec3{x[3 * n], x[3 * n + 1], x[3 * n + 2]}; };
    Vec3 sum;
    for (std::size_t e = 0; e < run_.sheet.flat.triangles.size(); ++e) {
      const auto& [a, b, c] = run_.sheet.flat.triangles[e];
      const Vec3 u = place(b) - place(a), v = place(c) - place(a), normal = cross(u, v);
      const Vec3 f{directions[3 * e], directions[3 * e + 1], directions[3 * e + 2]};
      const double area2 = norm_squared(normal);
      if (!(area2 > 0.0)) continue;
      const double along_u = dot(cross(f, v), normal) / area2, along_v = dot(cross(u, f), normal) / area2;
      const auto& flat = run_.sheet.flat.points;
      sum += along_u * (flat[b] - flat[a]) + along_v * (flat[c] - flat[a]);
    }
    if (!(norm_squared(sum) > 0.0)) return nullptr;
    const Vec3 mean = normalized(sum);
    return {mean.x, mean.y, mean.z};
  }

  const RunRecord& run_;
  const ResultsFrames& frames_;
  std::vector<std::size_t> chosen_;
  Scene scene_;
  std::future<std::string> packing_; ///< of the last block
};

} // namespace

std::size_t Scene::bytes() const
{
  std::size_t sum = 0;
  for (const SceneBlock& block : blocks) sum += block.text.size();
  return sum;
}

Scene make_scene(const RunRecord& run, const ResultsFrames& frames, std::size_t limit)
{
  std::size_t stride = 1;
  Scene scene = SceneMaker(run, frames, stride).make();
  while (scene.bytes() > limit && stride < frames.size()) {
    // Blocks grow with the frames, nearly; those that do not are small.
    const double over = static_cast<double>(scene.bytes()) / static_cast<double>(limit);
    stride = std::max(stride + 1, static_cast<std::size_t>(std::ceil(static_cast<double>(stride) * over)));
    scene = SceneMaker(run, frames, stride).make();
  }
  if (stride > 1)
    scene.notes.push_back(fmt::format("the 3-D view has {} of {} frames, to keep this page small",
                                      scene.description["frames"].size(), frames.size()));
  return scene;
}

} // namespace towform
