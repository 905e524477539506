#include "case/key_table.hpp"
#include "towform/case_schema.hpp"
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace towform {

TEST(CaseSchema, KnowsEveryKeyWithItsMeaning)
{
  const auto schema = nlohmann::json::parse(case_schema());
  for (const Row& row : key_table()) {
    const nlohmann::json* at = &schema;
    std::istringstream parts(row.path);
    for (std::string part; std::getline(parts, part, '.');) {
      if (at->contains("items")) at = &at->at("items");
      EXPECT_FALSE(at->at("additionalProperties")) << row.path; // an unknown key is marked
      ASSERT_TRUE(at->at("properties").contains(part)) << row.path;
      at = &at->at("properties").at(part);
    }
    EXPECT_EQ(at->at("description").get<std::string>().find(row.meaning), 0U) << row.path;
  }
  EXPECT_EQ(schema["properties"]["blank"]["properties"]["symmetry"]["enum"],
            (nlohmann::json{"none", "x", "y", "quarter"}));
  EXPECT_EQ(schema["properties"]["tool"]["type"], "array");
}

/// `TOWFORM_WRITE=1 towform_tests --gtest_filter=CaseSchema.*` writes the file.
TEST(CaseSchema, FileIsUpToDate)
{
  const std::string path = TOWFORM_SOURCE_DIR "/docs/case.schema.json";
  if (std::getenv("TOWFORM_WRITE") != nullptr) std::ofstream(path) << case_schema();
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  EXPECT_EQ(text.str(), case_schema());
}

} // namespace towform
