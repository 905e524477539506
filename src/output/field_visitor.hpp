#pragma once
#include "towform/state.hpp"
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace towform {

/// Sees every value of a run's state under its name: writes them, reads them back, or takes their hash.
/// Values arrive as plain numbers in place, so that one description serves all three.
class FieldVisitor {
public:
  FieldVisitor() = default;
  FieldVisitor(const FieldVisitor&) = delete;
  FieldVisitor& operator=(const FieldVisitor&) = delete;
  virtual ~FieldVisitor() = default;

  void operator()(const char* name, double& value) { see(name, {&value, 1}, 1); }
  void operator()(const char* name, Vec3& value) { see(name, {&value.x, 3}, 3); }
  void operator()(const char* name, std::vector<double>& values) { see(name, values, 1); }
  template <std::size_t Count>
  void operator()(const char* name, std::array<double, Count>& values)
  {
    see(name, values, 1);
  }
  void operator()(const char* name, std::vector<Vec3>& values) { see_rows<3>(name, values); }
  void operator()(const char* name, std::vector<ShearPoint>& values) { see_rows<3>(name, values); }
  void operator()(const char* name, std::vector<YarnPair>& values) { see_rows<2>(name, values); }
  void operator()(const char* name, std::int64_t& value) { see(name, value); }
  void operator()(const char* name, int& value)
  {
    std::int64_t wide = value;
    see(name, wide);
    value = static_cast<int>(wide);
  }
  void operator()(const char* name, bool& value)
  {
    std::int64_t wide = value ? 1 : 0;
    see(name, wide);
    value = wide != 0;
  }
  /// A member that is rebuilt from the others before it is used.
  void rebuilt(const char* name) { skip(place_ + name); }

  /// Names get this in front while it lives: "sheet.", "contact.0.".
  class Part {
  public:
    Part(FieldVisitor& visitor, const std::string& name) : visitor_(visitor), before_(visitor.place_)
    {
      visitor_.place_ += name + '.';
    }
    ~Part() { visitor_.place_ = before_; }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

  private:
    FieldVisitor& visitor_;
    std::string before_;
  };

protected:
  /// Rows of `columns` numbers, one after the other.
  virtual void numbers(const std::string& name, std::span<double> values, int columns) = 0;
  virtual void integer(const std::string& name, std::int64_t& value) = 0;
  virtual void skip(const std::string&) {}

private:
  void see(const char* name, std::span<double> values, int columns)
  {
    numbers(place_ + name, values, columns);
  }
  void see(const char* name, std::int64_t& value) { integer(place_ + name, value); }
  template <int Columns, class Row>
  void see_rows(const char* name, std::vector<Row>& rows)
  {
    static_assert(sizeof(Row) == Columns * sizeof(double) && alignof(Row) == alignof(double));
    see(name, {reinterpret_cast<double*>(rows.data()), Columns * rows.size()}, Columns);
  }

  std::string place_;
};

} // namespace towform
