#include "temporary_directory.hpp"
#include "towform/error.hpp"
#include "towform/results.hpp"

namespace towform {

using History = TemporaryDirectory;

TEST_F(History, HasEveryRowInTheFileAsSoonAsItIsAppended)
{
  const std::filesystem::path path = directory / "out/history.csv";
  HistoryWriter history(path, {"time_s", "step", "force_punch_N"});
  EXPECT_EQ(text_of(path), "time_s,step,force_punch_N\n");
  history.append({0.0, 0.0, -0.0});
  EXPECT_EQ(text_of(path), "time_s,step,force_punch_N\n0,0,0\n");
  history.append({0.0002, 12345678901.0, -1.0 / 3.0});
  EXPECT_EQ(text_of(path), "time_s,step,force_punch_N\n0,0,0\n0.0002,12345678901,-0.333333333\n");
  history.append({1e300, 5e-6, 123456.7890123});
  EXPECT_TRUE(text_of(path).ends_with("\n1e+300,5e-06,123456.789\n"));
}

TEST_F(History, StartsAnewAndQuotesAwkwardNames)
{
  const std::filesystem::path path = directory / "history.csv";
  HistoryWriter(path, {"a"}).append({1.0});
  const HistoryWriter second(path, {"time_s", "force_a,\"b\"_N"});
  EXPECT_EQ(text_of(path), "time_s,\"force_a,\"\"b\"\"_N\"\n");
}

TEST_F(History, RejectsARowOfAnotherLengthAndAPlaceItCannotWrite)
{
  HistoryWriter history(directory / "history.csv", {"a", "b"});
  EXPECT_EQ(message_of<std::invalid_argument>([&] { history.append({1.0}); }),
            "history: 1 values for 2 columns");
  EXPECT_EQ(text_of(directory / "history.csv"), "a,b\n");
  EXPECT_EQ(message_of<FileError>([&] { HistoryWriter(directory, {"a"}); }),
            directory.string() + ": cannot be written: Is a directory");
  EXPECT_EQ(message_of<FileError>([] { HistoryWriter("/dev/full", {"a"}); }),
            "/dev/full: cannot be written: No space left on device");
}

} // namespace towform
