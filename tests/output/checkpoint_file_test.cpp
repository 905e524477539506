#include "output/checkpoint_file.hpp"
#include "results_fixture.hpp"
#include "towform/error.hpp"

namespace towform {
namespace {

struct Values {
  double number = 0.1;
  std::int64_t count = (std::int64_t{1} << 60) + 1; // no double holds it
  std::vector<Vec3> points{{1, 2, 3}, {4, 5, 6}};
  std::vector<double> none;

  void visit(FieldVisitor& v)
  {
    v("number", number);
    v("count", count);
    const FieldVisitor::Part part(v, "sheet");
    v("points", points);
    v("none", none);
  }
};

class CheckpointFile : public TemporaryDirectory {
protected:
  void write(double number)
  {
    Values values;
    values.number = number;
    CheckpointWriter writer(directory, {"1.2.3", "abc", "explicit", "the case", "digest  file\n"});
    values.visit(writer);
    writer.commit();
  }
  std::string refusal() const
  {
    return message_of<CheckpointError>([&] { CheckpointReader reader(checkpoint_path(directory)); });
  }
  /// Writes bytes over the checkpoint.
  void damage(std::streamoff at, const std::string& bytes) const
  {
    std::fstream file(checkpoint_path(directory), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(at);
    file << bytes;
  }
};

TEST_F(CheckpointFile, GivesBackEveryValueToTheBit)
{
  write(1.0 / 3.0);
  CheckpointReader reader(checkpoint_path(directory));
  EXPECT_EQ(reader.origin().version, "1.2.3");
  EXPECT_EQ(reader.origin().resolved_case, "the case");
  EXPECT_EQ(reader.origin().inputs, "digest  file\n");
  Values values;
  values.count = 0;
  values.points.assign(2, {});
  values.visit(reader);
  EXPECT_EQ(values.number, 1.0 / 3.0);
  EXPECT_EQ(values.count, (std::int64_t{1} << 60) + 1);
  EXPECT_EQ(values.points[1].z, 6.0);
}

TEST_F(CheckpointFile, KeepsTheOneBefore)
{
  for (const double number : {1.0, 2.0, 3.0}) write(number);
  for (const auto& [path, number] :
       {std::pair{checkpoint_path(directory), 3.0}, {previous_checkpoint_path(directory), 2.0}}) {
    CheckpointReader reader(path);
    Values values;
    values.visit(reader);
    EXPECT_EQ(values.number, number);
  }
  remove_checkpoints(directory);
  EXPECT_TRUE(std::filesystem::is_empty(directory));
}

TEST_F(CheckpointFile, IsRefusedWhenAnyByteIsWrong)
{
  write(1.0);
  const auto size = static_cast<std::streamoff>(std::filesystem::file_size(checkpoint_path(directory)));
  for (std::streamoff at = 512; at < size; at += 97) {
    const std::string before = text_of(checkpoint_path(directory)).substr(static_cast<std::size_t>(at), 1);
    damage(at, std::string(1, static_cast<char>(before[0] ^ 0x10)));
    EXPECT_TRUE(contains(refusal(), "is damaged: its CRC is wrong")) << at;
    damage(at, before);
  }
  CheckpointReader(checkpoint_path(directory)); // whole again
}

TEST_F(CheckpointFile, IsRefusedWhenItIsNotOne)
{
  write(1.0);
  const std::filesystem::path path = checkpoint_path(directory);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1);
  EXPECT_TRUE(contains(refusal(), "is damaged: ")) << refusal();
  std::filesystem::resize_file(path, 100);
  EXPECT_TRUE(contains(refusal(), "is too short to be a checkpoint")) << refusal();
  write(1.0);
  damage(0, "TOWFORM");
  EXPECT_TRUE(contains(refusal(), "is not a checkpoint of towform")) << refusal();
  write(1.0);
  damage(0, "towform checkpoint\nschema 9\n");
  EXPECT_TRUE(contains(refusal(), "has schema 9, this towform reads schema 5")) << refusal();
}

TEST_F(CheckpointFile, SaysWhichArrayDoesNotFit)
{
  write(1.0);
  CheckpointReader reader(checkpoint_path(directory));
  Values values;
  values.points.resize(3);
  EXPECT_TRUE(contains(message_of<CheckpointError>([&] { values.visit(reader); }),
                       "/state/sheet.points has 6 numbers, the case needs 9"));
}

TEST_F(CheckpointFile, LeavesTheOldOnesWhenItIsNotFinished)
{
  write(1.0);
  {
    CheckpointWriter writer(directory, {});
    Values().visit(writer);
  }
  CheckpointReader reader(checkpoint_path(directory));
  EXPECT_EQ(reader.origin().version, "1.2.3");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory), {}), 1);
}

} // namespace
} // namespace towform
