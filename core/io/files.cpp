// SPDX-License-Identifier: MIT
#include "io/files.h"

#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace versorium {
namespace {

Status failure(const std::string& what, const std::string& path, int number) {
    return Status::inputOutput(what + " " + path + ": " + std::strerror(number));
}

// Owns an open descriptor; closing can fail and is then told.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ > STDERR_FILENO) ::close(number_);
    }
    int number() const { return number_; }
    bool close() {
        const int closing = number_;
        number_ = -1;
        return ::close(closing) == 0;
    }

  private:
    int number_;
};

int openRetrying(const char* path, int flags, mode_t mode = 0) {
    int number = -1;
    do number = ::open(path, flags | O_CLOEXEC, mode);
    while (number < 0 && errno == EINTR);
    return number;
}

// 0, or the errno of the write that failed.
int writeAll(int descriptor, std::span<const unsigned char> bytes) {
    constexpr std::size_t kPiece = std::size_t{1} << 26;
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), std::min(bytes.size(), kPiece));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        if (written == 0) return ENOSPC;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return 0;
}

std::string sizeText(std::size_t bytes) {
    const std::size_t mebi = std::size_t{1} << 20;
    return bytes >= mebi ? std::to_string(bytes / mebi) + " MiB" : std::to_string(bytes) + " bytes";
}

Status tooLarge(const std::string& path, std::size_t maxBytes) {
    return Status::inputOutput("cannot read " + path + ": it is larger than " + sizeText(maxBytes) +
                               ", the most that is read here");
}

// Devices and pipes cannot be replaced, so they are written to.
Status writeDirectly(const std::string& path, std::span<const unsigned char> bytes) {
    Descriptor file(openRetrying(path.c_str(), O_WRONLY));
    if (file.number() < 0) return failure("cannot write", path, errno);
    if (const int number = writeAll(file.number(), bytes))
        return failure("cannot write", path, number);
    return file.close() ? Status{} : failure("cannot write", path, errno);
}

std::string folderOf(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "./" : path.substr(0, slash + 1);
}

std::string nameOf(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? path : path.substr(slash + 1);
}

// Opens a file that did not exist; `path` receives its name. A leftover of a crashed process may
// hold a name, so several are tried.
int openTemporary(const std::string& target, std::string& path) {
    // A file name has at most 255 bytes; the name's start is enough to recognise it.
    const std::string name = nameOf(target).substr(0, 200);
    for (int attempt = 0; attempt < 1000; ++attempt) {
        path = folderOf(target) + "." + name + "." +
               std::to_string(static_cast<long>(::getpid()) * 1000 + attempt) + ".partial";
        const int number = openRetrying(path.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0666);
        if (number >= 0 || errno != EEXIST) return number;
    }
    return -1;
}

// The names of a rename last through a power cut only when the folder is written too. Some file
// systems refuse to sync a folder; the file itself is safe then all the same.
void syncFolder(const std::string& path) {
    const int number = openRetrying(folderOf(path).c_str(), O_RDONLY);
    if (number < 0) return;
    ::fsync(number);
    ::close(number);
}

Status replaceFile(const std::string& path, std::span<const unsigned char> bytes, mode_t mode) {
    std::string temporary;
    Descriptor file(openTemporary(path, temporary));
    if (file.number() < 0) return failure("cannot write", path, errno);
    int number = writeAll(file.number(), bytes);
    // The mode of the file that is replaced stays.
    if (number == 0 && mode != 0 && ::fchmod(file.number(), mode) != 0) number = errno;
    if (number == 0 && ::fsync(file.number()) != 0) number = errno;
    if (!file.close() && number == 0) number = errno;
    if (number == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) number = errno;
    if (number != 0) {
        ::unlink(temporary.c_str());
        return failure("cannot write", path, number);
    }
    syncFolder(path);
    return {};
}

}  // namespace

std::string expandedPath(const std::string& path) {
    if (path != "~" && !path.starts_with("~/")) return path;
    const char* home = std::getenv("HOME");
    return home != nullptr ? home + path.substr(1) : path;
}

Expected<Bytes> readFile(const std::string& given, std::size_t maxBytes) {
    const std::string path = expandedPath(given);
    const bool standard = path == "-";
    const std::string shown = standard ? "standard input" : path;
    Descriptor file(standard ? STDIN_FILENO : openRetrying(path.c_str(), O_RDONLY));
    if (file.number() < 0) return failure("cannot read", shown, errno);
    struct stat information {};
    if (::fstat(file.number(), &information) != 0) return failure("cannot read", shown, errno);
    Bytes bytes;
    if (S_ISREG(information.st_mode)) {
        const auto size = static_cast<unsigned long long>(information.st_size);
        if (size > maxBytes) return tooLarge(shown, maxBytes);
        bytes.reserve(static_cast<std::size_t>(size) + 1);
    }
    std::size_t filled = 0;
    while (filled <= maxBytes) {
        // The content grows by doubling; the reserved byte lets the end of a file be met without
        // it.
        if (filled == bytes.size())
            bytes.resize(std::max({bytes.capacity(), bytes.size() * 2, std::size_t{65536}}));
        const ssize_t got = ::read(file.number(), bytes.data() + filled, bytes.size() - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return failure("cannot read", shown, errno);
        if (got == 0) break;
        filled += static_cast<std::size_t>(got);
    }
    if (filled > maxBytes) return tooLarge(shown, maxBytes);
    bytes.resize(filled);
    return bytes;
}

Status writeFileAtomically(const std::string& given, std::span<const unsigned char> bytes) {
    const std::string path = expandedPath(given);
    if (path == "-") {
        std::fflush(stdout);
        const int number = writeAll(STDOUT_FILENO, bytes);
        return number == 0 ? Status{} : failure("cannot write", "standard output", number);
    }
    struct stat information {};
    if (::stat(path.c_str(), &information) != 0) {
        if (errno != ENOENT) return failure("cannot write", path, errno);
        return replaceFile(path, bytes, 0);
    }
    if (S_ISDIR(information.st_mode)) return failure("cannot write", path, EISDIR);
    if (!S_ISREG(information.st_mode)) return writeDirectly(path, bytes);
    char* resolved = ::realpath(path.c_str(), nullptr);
    if (resolved == nullptr) return failure("cannot write", path, errno);
    const std::string target = resolved;
    ::free(resolved);
    return replaceFile(target, bytes, information.st_mode & 07777);
}

Status writeFileAtomically(const std::string& path, std::string_view text) {
    return writeFileAtomically(
        path, std::span(reinterpret_cast<const unsigned char*>(text.data()), text.size()));
}

}  // namespace versorium
