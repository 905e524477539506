#include "output/sha256.hpp"
#include "temporary_directory.hpp"
#include "towform/error.hpp"
#include "towform/results.hpp"

namespace towform {

namespace {

using Sha256OfFile = TemporaryDirectory;

std::string digest_in_pieces(const std::string& text, std::size_t piece)
{
  Sha256 sha;
  for (std::size_t i = 0; i < text.size(); i += piece) {
    const std::string part = text.substr(i, piece);
    sha.add({reinterpret_cast<const unsigned char*>(part.data()), part.size()});
  }
  return sha.digest();
}

} // namespace

// The examples published with FIPS 180: none, one and two blocks, and many.
TEST(Sha256, AgreesWithThePublishedExamples)
{
  EXPECT_EQ(digest_in_pieces("", 1), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(digest_in_pieces("abc", 3), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(digest_in_pieces("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq", 56),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(
      digest_in_pieces("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmnhijklmnoijklmnopjklmnopqk"
                       "lmnopqrlmnopqrsmnopqrstnopqrstu",
                       112),
      "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1");
  EXPECT_EQ(digest_in_pieces(std::string(1'000'000, 'a'), 4096),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_F(Sha256OfFile, ReadsAllOfIt)
{
  std::ofstream(directory / "a") << std::string(1'000'000, 'a');
  EXPECT_EQ(sha256_of_file(directory / "a"),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_F(Sha256OfFile, SaysWhatItCannotRead)
{
  EXPECT_EQ(message_of<FileError>([&] { sha256_of_file(directory / "none"); }),
            (directory / "none").string() + ": cannot be read: No such file or directory");
  EXPECT_EQ(message_of<FileError>([&] { sha256_of_file(directory); }),
            directory.string() + ": cannot be read: Is a directory");
}

} // namespace towform
