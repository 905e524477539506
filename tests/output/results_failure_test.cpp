#include "output/text_file.hpp"
#include "results_fixture.hpp"
#include "towform/error.hpp"
#include <csignal>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/wait.h>

namespace towform {

namespace {

/// The FileError of an action that may not make a file larger than so many bytes.
template <class Action>
std::string with_room_for(std::uintmax_t bytes, Action action)
{
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit limit{bytes, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ::setrlimit(RLIMIT_FSIZE, &limit);
  std::string message = message_of<FileError>(action);
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  return message;
}

} // namespace

TEST_F(Results, CanBeReadAfterEveryFrameAndWhileAReaderHoldsThemOpen)
{
  ResultsWriter writer(directory, mesh, dome::provenance());
  EXPECT_TRUE(frames().empty());
  const int reader = ::open((directory / "results.h5").c_str(), O_RDONLY);
  ASSERT_EQ(::flock(reader, LOCK_SH), 0); // as HDF5 does in a program that reads
  for (int i = 0; i < 3; ++i) {
    writer.append(dome::frame(mesh, i / 2.0));
    EXPECT_EQ(writer.frames(), i + 1);
  }
  ::close(reader);
  EXPECT_EQ(frames(), (std::vector<std::string>{"0000", "0001", "0002"}));
}

TEST_F(Results, LoseOnlyTheFrameThatIsWrittenWhenTheProgramDies)
{
  ResultsWriter writer(directory, mesh, dome::provenance());
  writer.append(dome::frame(mesh, 0.5));
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) { // half of a frame, then death without a close
    reserve_space(directory / "results.h5", 100'000);
    const hdf5::File file = open(hdf5::File::Mode::append);
    const hdf5::Group group = hdf5::create_group(file.id(), "frames/0001");
    const std::vector<double> half(75, 1.0);
    (void)hdf5::write_dataset(group.id(), "position", {25, 3}, H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE,
                              half.data());
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(frames(), std::vector<std::string>{"0000"});
  writer.append(dome::frame(mesh, 1.0));
  EXPECT_EQ(frames(), (std::vector<std::string>{"0000", "0001"}));
  EXPECT_EQ(values("frames/0001/position")[2], dome::frame(mesh, 1.0).position[0].z);
}

TEST_F(Results, StayReadableWhenTheDiskIsFull)
{
  mesh = dome::sheet(40);
  ResultsWriter writer(directory, mesh, dome::provenance());
  writer.append(dome::frame(mesh, 0.5));
  const std::filesystem::path path = directory / "results.h5";
  const std::uintmax_t size = std::filesystem::file_size(path);

  const auto full_disk = [&](auto action) {
    return with_room_for(size + 50'000, action);
  }; // a frame has 290 kB
  const std::string message = full_disk([&] { writer.append(dome::frame(mesh, 1.0)); });
  EXPECT_TRUE(contains(message, path.string() + ": no room for")) << message;
  EXPECT_EQ(writer.frames(), 1);
  EXPECT_EQ(std::filesystem::file_size(path), size);
  EXPECT_EQ(frames(), std::vector<std::string>{"0000"});
  EXPECT_EQ(values("frames/0000/position").size(), 3 * mesh.points.size());
  full_disk([&] { writer.finish("done"); });
  EXPECT_EQ(hdf5::text_attribute(open().id(), "status"), "running");
  writer.append(dome::frame(mesh, 1.0)); // there is room again
  EXPECT_EQ(frames().size(), 2U);
}

TEST_F(Results, AreNotReplacedWhenThereIsNoRoomForNewOnes)
{
  ResultsWriter(directory, mesh, dome::provenance()).append(dome::frame(mesh, 1.0));
  const std::string message =
      with_room_for(1000, [&] { ResultsWriter(directory, mesh, dome::provenance()); });
  EXPECT_TRUE(contains(message, "no room for")) << message;
  EXPECT_EQ(frames().size(), 1U);
  EXPECT_TRUE(std::filesystem::exists(directory / "results.xdmf"));
}

TEST_F(Results, AreNotWrittenWhileAnotherProgramHasThemOpenForWriting)
{
  ResultsWriter writer(directory, mesh, dome::provenance());
  const int other = ::open((directory / "results.h5").c_str(), O_RDWR);
  ASSERT_EQ(::flock(other, LOCK_EX), 0); // as HDF5 does in a program that writes
  const std::string message = message_of<FileError>([&] { writer.append(dome::frame(mesh, 1.0)); });
  EXPECT_TRUE(contains(message, "is open for writing in another program")) << message;
  ::close(other);
  writer.append(dome::frame(mesh, 1.0));
  EXPECT_EQ(frames().size(), 1U);
}

TEST_F(Results, GoOnAfterTheFramesThatAreToStay)
{
  {
    ResultsWriter writer(directory, mesh, dome::provenance());
    for (int i = 0; i < 4; ++i) writer.append(dome::frame(mesh, i / 4.0));
    writer.finish("stopped");
  }
  ResultsWriter writer(directory, mesh, 2);
  EXPECT_EQ(frames(), (std::vector<std::string>{"0000", "0001"}));
  EXPECT_EQ(hdf5::text_attribute(open().id(), "status"), "running");
  EXPECT_EQ(text_of(directory / "results.xdmf").find("/frames/0002"), std::string::npos);
  writer.append(dome::frame(mesh, 1.0));
  EXPECT_EQ(frames(), (std::vector<std::string>{"0000", "0001", "0002"}));
  EXPECT_EQ(values("frames/0002/position")[2], dome::frame(mesh, 1.0).position[0].z);
  EXPECT_TRUE(contains(message_of<FileError>([&] { ResultsWriter(directory, mesh, 5); }),
                       "holds 3 frames where the checkpoint was written after 5"));
}

TEST_F(Results, LeaveNoPartOfAFrameBehindWhenAnArrayHasAWrongLength)
{
  ResultsWriter writer(directory, mesh, dome::provenance());
  Frame frame = dome::frame(mesh, 1.0);
  frame.thickness.pop_back();
  EXPECT_EQ(message_of<std::invalid_argument>([&] { writer.append(frame); }),
            "frame: thickness has 31 rows instead of 32");
  EXPECT_TRUE(frames().empty());
}

TEST_F(Results, LeaveNoPartOfAFrameBehindWhenAFieldThatIsMadeHasAWrongLength)
{
  ResultsWriter writer(directory, mesh, dome::provenance());
  Frame frame = dome::frame(mesh, 1.0);
  frame.thickness.pop_back(); // one of the last
  EXPECT_EQ(message_of<std::invalid_argument>(
                [&] { writer.append(1.0, !frame.clearance.empty(), [&](std::string_view) { return frame; }); }),
            "frame: thickness has 31 rows instead of 32");
  EXPECT_TRUE(frames().empty());
}

TEST_F(Results, SayWhyTheyCannotBeWritten)
{
  const auto message = [&](const std::filesystem::path& where) {
    return message_of<FileError>([&] { ResultsWriter(where, mesh, dome::provenance()); });
  };
  std::ofstream(directory / "file") << "text";
  EXPECT_EQ(message(directory / "file"), (directory / "file").string() + ": is a file, not a directory");
  EXPECT_EQ(message(directory / "file/below"),
            (directory / "file/below").string() + ": the directory cannot be created: Not a directory");
  std::filesystem::create_directories(directory / "taken/results.h5");
  EXPECT_EQ(message(directory / "taken"),
            (directory / "taken/results.h5").string() + ": cannot be written: Is a directory");
  if (::geteuid() != 0) { // nothing is denied to root
    std::filesystem::create_directory(directory / "denied");
    std::filesystem::permissions(directory / "denied", std::filesystem::perms::owner_read);
    EXPECT_TRUE(contains(message(directory / "denied"), "Permission denied"));
    std::filesystem::permissions(directory / "denied", std::filesystem::perms::owner_all);
  }
}

TEST_F(Results, SayWhichFileIsGoneWhenAFrameIsAppended)
{
  ResultsWriter writer(directory, mesh, dome::provenance());
  std::filesystem::remove(directory / "results.h5");
  EXPECT_EQ(message_of<FileError>([&] { writer.append(dome::frame(mesh, 1.0)); }),
            (directory / "results.h5").string() + ": cannot be opened: No such file or directory");
}

} // namespace towform
