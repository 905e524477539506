#pragma once
#include "towform/case.hpp"
#include "units.hpp"
#include <cassert>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace towform {

/// What the keys of a section write to: the case, and the tool or boundary for keys of [[tool]] and
/// [[boundary]].
struct Target {
  Case& c;
  ToolParameters* tool = nullptr;
  BoundaryParameters* boundary = nullptr;

  /// Of the tool or boundary; one of them there must be.
  [[nodiscard]] std::optional<Motion>& motion() const
  {
    if (tool != nullptr) return tool->motion;
    assert(boundary != nullptr);
    return boundary->motion;
  }
};

template <class T>
using At = T& (*)(Target&);

/// A value that is one of a few words; the numbers are places in the list, negative when it has no meaning.
struct Words {
  std::vector<std::string> names;
  std::function<int(Target&)> get;
  std::function<void(Target&, int)> set;
};

/// A motion's final displacement or its velocity, whichever is given.
struct MotionAmount {
  Motion::Quantity quantity;
};

/// A motion's [[time, value], …]; the values' units say whether they are displacements or velocities.
struct MotionTable {};

/// Where a key's value lives, and thereby its type.
using Binding = std::variant<At<bool>, At<double>, At<std::optional<double>>, At<int>, At<std::optional<int>>,
                             At<std::string>, At<std::filesystem::path>, At<Vec2>, At<std::optional<Vec2>>,
                             At<Vec3>, At<std::optional<Vec3>>, Words, MotionAmount, MotionTable,
                             At<std::vector<double>>, At<std::vector<ViscosityPoint>>,
                             At<std::vector<BendingPoint>>, At<std::vector<PressurePoint>>>;

/// A default that says there is none.
inline const std::string required = "required"; ///< the case (or its card) must give the key
inline const std::string optional = "-";        ///< the key may be left out

/// One key of a case: everything there is to know about it. Keys of [[tool]] are `tool.…`, of [[boundary]]
/// `boundary.…`.
struct Row {
  std::string path;
  Binding binding;
  Dimension dimension = Dimension::none;
  std::string default_text; ///< TOML or plain text as on a command line, `required` or `optional`
  std::string range;        ///< as Range reads it
  std::string meaning;
  std::string only_with{}; ///< path of the key without which this one has no effect
  bool bare_unit = false;  ///< "mm" stands for "1 mm"
  /// Whether the key says anything beside the keys before it; otherwise it is neither asked for nor echoed.
  std::function<bool(const Case&)> when{};

  [[nodiscard]] bool counts(const Case& c) const { return !when || when(c); }

  [[nodiscard]] std::string section() const; ///< first part of the path; empty for a key of no table
  [[nodiscard]] std::string name() const;    ///< last part of the path
};

/// Is a section a list of tables, each with a name: [[tool]], [[boundary]]?
bool is_list_section(const std::string& section);

/// Is it a key of the table `motion` of a tool or boundary?
bool is_motion_key(const Row& row);

/// All keys of a case, in the order in which they are echoed.
const std::vector<Row>& key_table();

const Row& row_of(const std::string& path);

} // namespace towform
