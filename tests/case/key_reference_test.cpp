#include "case/key_table.hpp"
#include "case/range.hpp"
#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace towform {

TEST(KeyReference, ListsEveryKeyOnce)
{
  const std::string text = key_reference();
  std::set<std::string> paths;
  for (const Row& row : key_table()) {
    EXPECT_TRUE(paths.insert(row.path).second) << row.path;
    EXPECT_NE(text.find("\n| `" + row.path + "` |"), std::string::npos) << row.path;
    EXPECT_FALSE(row.meaning.empty()) << row.path;
    EXPECT_NO_THROW(Range(row.range, row.dimension)) << row.path;
  }
}

/// `TOWFORM_WRITE=1 towform_tests --gtest_filter=KeyReference.*` writes the page.
TEST(KeyReference, PageIsUpToDate)
{
  const std::string page = TOWFORM_SOURCE_DIR "/docs/case_keys.md";
  if (std::getenv("TOWFORM_WRITE") != nullptr) std::ofstream(page) << key_reference();
  std::ostringstream text;
  text << std::ifstream(page).rdbuf();
  EXPECT_EQ(text.str(), key_reference());
}

} // namespace towform
