#pragma once
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <unistd.h>

namespace towform {

/// A fresh directory for a test, removed afterwards; named after the test so that tests can run side by side.
class TemporaryDirectory : public ::testing::Test {
protected:
  TemporaryDirectory()
  {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    directory = std::filesystem::path(::testing::TempDir()) /
                fmt::format("towform-{}-{}-{}", info->test_suite_name(), info->name(), ::getpid());
    std::filesystem::create_directories(directory);
  }
  ~TemporaryDirectory() override { std::filesystem::remove_all(directory); }

  static std::string text_of(const std::filesystem::path& path)
  {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  std::filesystem::path directory;
};

/// The message of the exception of a type that an action throws; fails the test when it throws none.
template <class Error, class Action>
std::string message_of(Action action)
{
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

} // namespace towform
