#include "towform/error.hpp"
#include <gtest/gtest.h>

namespace towform {

TEST(InputError, NamesPlaceAndPrefersTheCaseFilesCode)
{
  const InputIssue file{{"case.toml", 0, 0}, "cannot be read", ExitCode::files};
  const InputIssue key{{"case.toml", 3, 7}, "unknown key", ExitCode::case_file};
  EXPECT_EQ(file.text(), "case.toml: cannot be read");
  EXPECT_EQ(key.text(), "case.toml:3:7: unknown key");
  EXPECT_EQ(InputError({file}).code(), ExitCode::files);
  EXPECT_EQ(InputError({file, key}).code(), ExitCode::case_file);
}

} // namespace towform
