// SPDX-License-Identifier: MIT
// What needs real devices, folders and processes.
#include "io/files.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "base/random.h"

namespace versorium {
namespace {

namespace fs = std::filesystem;

class Files : public ::testing::Test {
  protected:
    Files() {
        std::string name = (fs::temp_directory_path() / "versorium-XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
    }
    ~Files() override { fs::remove_all(folder_); }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::size_t fileCount() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }
    fs::path folder_;
};

TEST_F(Files, RoundTrip) {
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{1}, std::size_t{65536}, std::size_t{3000001}}) {
        Bytes bytes(size);
        for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<unsigned char>(i * 7 >> 3);
        ASSERT_TRUE(writeFileAtomically(path("data"), bytes).ok());
        const Expected<Bytes> read = readFile(path("data"));
        ASSERT_TRUE(read.ok());
        EXPECT_EQ(*read, bytes);
    }
    EXPECT_EQ(fileCount(), 1u);
}

TEST_F(Files, SizeIsCapped) {
    ASSERT_TRUE(writeFileAtomically(path("data"), std::string_view("12345")).ok());
    EXPECT_TRUE(readFile(path("data"), 5).ok());
    EXPECT_EQ(readFile(path("data"), 4).status().kind(), ErrorKind::inputOutput);
    // A device has no size to look at first.
    EXPECT_EQ(readFile("/dev/zero", 100000).status().kind(), ErrorKind::inputOutput);
}

TEST_F(Files, FailuresNameThePath) {
    const Status missing = readFile(path("none")).status();
    EXPECT_EQ(missing.message(), "cannot read " + path("none") + ": No such file or directory");
    EXPECT_EQ(missing.kind(), ErrorKind::inputOutput);
    EXPECT_FALSE(readFile(folder_.string()).ok());
    const Status noFolder = writeFileAtomically(path("none/file"), std::string_view("x"));
    EXPECT_EQ(noFolder.message(),
              "cannot write " + path("none/file") + ": No such file or directory");
    EXPECT_FALSE(writeFileAtomically(folder_.string(), std::string_view("x")).ok());
}

TEST_F(Files, AFullDeviceIsTold) {
    const Status status = writeFileAtomically("/dev/full", std::string_view("x"));
    EXPECT_EQ(status.message(), "cannot write /dev/full: No space left on device");
    // The device is still one: nothing took its place.
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(Files, AnUnwritableFolderIsTold) {
    if (::geteuid() == 0) {
        // Permissions do not bind root; a folder of the kernel's that nobody can write to does.
        EXPECT_FALSE(writeFileAtomically("/proc/versorium", std::string_view("x")).ok());
        return;
    }
    ASSERT_EQ(::chmod(folder_.c_str(), 0500), 0);
    const Status status = writeFileAtomically(path("file"), std::string_view("x"));
    ASSERT_EQ(::chmod(folder_.c_str(), 0700), 0);
    EXPECT_EQ(status.message(), "cannot write " + path("file") + ": Permission denied");
    EXPECT_EQ(fileCount(), 0u);
}

TEST_F(Files, LinksAndModesStay) {
    ASSERT_TRUE(writeFileAtomically(path("target"), std::string_view("old")).ok());
    ASSERT_EQ(::chmod(path("target").c_str(), 0640), 0);
    fs::create_symlink("target", path("link"));
    ASSERT_TRUE(writeFileAtomically(path("link"), std::string_view("new")).ok());
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(*readFile(path("target")), (Bytes{'n', 'e', 'w'}));
    EXPECT_EQ(fs::status(path("target")).permissions(), fs::perms(0640));
}

// A file that cannot grow beyond a limit: the write fails in its middle, and the old file stays.
TEST_F(Files, AFailedWriteLeavesTheOldFile) {
    ASSERT_TRUE(writeFileAtomically(path("data"), std::string_view("old")).ok());
    const pid_t child = ::fork();
    if (child == 0) {
        ::signal(SIGXFSZ, SIG_IGN);
        const struct rlimit limit = {100000, 100000};
        if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) ::_exit(1);
        const Status status = writeFileAtomically(path("data"), Bytes(300000, 'x'));
        ::_exit(status.kind() == ErrorKind::inputOutput ? 7 : 2);
    }
    int outcome = 0;
    ::waitpid(child, &outcome, 0);
    EXPECT_EQ(WEXITSTATUS(outcome), 7);
    EXPECT_EQ(*readFile(path("data")), (Bytes{'o', 'l', 'd'}));
    EXPECT_EQ(fileCount(), 1u);
}

// Killed at any moment, the writer leaves one of the contents that it wrote, whole.
TEST_F(Files, KilledWritersNeverTear) {
    constexpr std::size_t kSize = 300000;
    ASSERT_TRUE(writeFileAtomically(path("data"), Bytes(kSize, 'a')).ok());
    Random random(9);
    for (int round = 0; round < 50; ++round) {
        int ready[2];
        ASSERT_EQ(::pipe(ready), 0);
        const pid_t child = ::fork();
        if (child == 0) {
            for (unsigned char fill = 'b';; fill = fill == 'z' ? 'a' : fill + 1) {
                const bool good = writeFileAtomically(path("data"), Bytes(kSize, fill)).ok();
                if (::write(ready[1], "x", 1) != 1 || !good) ::_exit(1);
            }
        }
        // After some finished writes the next one is under way.
        char byte;
        for (std::uint64_t n = 1 + random.below(3); n > 0; --n)
            ASSERT_EQ(::read(ready[0], &byte, 1), 1);
        ::usleep(static_cast<useconds_t>(random.below(800)));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        ::close(ready[0]);
        ::close(ready[1]);
        const Expected<Bytes> read = readFile(path("data"));
        ASSERT_TRUE(read.ok());
        ASSERT_EQ(read->size(), kSize);
        ASSERT_EQ(std::count(read->begin(), read->end(), read->front()),
                  static_cast<std::ptrdiff_t>(kSize));
    }
}

}  // namespace
}  // namespace versorium
