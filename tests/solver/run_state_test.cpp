#include "solver/run_state.hpp"
#include <gtest/gtest.h>
#include <set>

namespace towform {
namespace {

/// Counts the members that a visit names, whether they are kept or rebuilt.
class Names final : public FieldVisitor {
public:
  std::set<std::string> names;

private:
  void numbers(const std::string& name, std::span<double>, int) override { names.insert(name); }
  void integer(const std::string& name, std::int64_t&) override { names.insert(name); }
  void skip(const std::string& name) override { names.insert(name); }
};

/// Something that any member of an aggregate can be made of.
struct Anything {
  template <class T>
  operator T() const; // NOLINT(google-explicit-constructor): that is its use
};

/// How many members an aggregate has.
template <class Struct, class... Members>
constexpr std::size_t member_count()
{
  if constexpr (requires { Struct{Members{}..., Anything{}}; })
    return member_count<Struct, Members..., Anything>();
  else
    return sizeof...(Members);
}

template <class Struct>
std::size_t visited(Struct value = {})
{
  Names names;
  visit(names, value);
  return names.names.size();
}

// Taking a struct apart by name does not compile with a member too many; here, each of them is used, too.
TEST(RunState, EveryMemberIsVisited)
{
  EXPECT_EQ(visited<State>(), member_count<State>());
  EXPECT_EQ(visited<BendingState>(), member_count<BendingState>());
  EXPECT_EQ(visited<ToolState>(), member_count<ToolState>());
  EXPECT_EQ(visited<BoundaryState>(), member_count<BoundaryState>());
  EXPECT_EQ(visited<ContactState>(), member_count<ContactState>() - 1 + member_count<ContactEnergies>());
  EXPECT_EQ(visited<StaticsState>(), member_count<StaticsState>());
  EXPECT_EQ(visited<Summary>() + 1, member_count<Summary>()); // no energies in an empty list
  EXPECT_EQ(visited<PressureState>(), member_count<PressureState>());
  EXPECT_EQ(visited<Record>(),
            member_count<Record>() - 2 + visited<Summary>() + member_count<DeepestContact>());

  System system;
  system.bending.resize(1);
  system.tools.resize(2);
  system.contacts.resize(2);
  system.boundaries.resize(3);
  const std::size_t whole = 1 + member_count<TouchedTools>() + visited<State>() + visited<BendingState>() + 2 * visited<ToolState>() +
                            2 * visited<ContactState>() + 3 * visited<BoundaryState>();
  EXPECT_EQ(visited(system), whole);
  EXPECT_EQ(visited<RunState>(), visited<System>() + member_count<StepLook>() + member_count<KnownStep>() +
                                     member_count<Stride>() + visited<Record>() + 3);
  EXPECT_EQ(visited<StaticsRunState>(), visited<StaticsState>() + visited<Record>() + 4);
}

} // namespace
} // namespace towform
