// SPDX-License-Identifier: Apache-2.0
#include "converters/common/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

namespace libstyle {
namespace {

constexpr std::string_view kStandardStream = "-";

Error input_error(const std::string& name, const std::string& what) {
  return Error({name}, what + ": " + std::strerror(errno));
}

OutputError output_error(const std::string& name) {
  return OutputError({name}, std::string("cannot be written: ") + std::strerror(errno));
}

// Owns a file descriptor, but for those of the standard streams.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() {
    if (value_ > STDERR_FILENO) close(value_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return value_; }

 private:
  int value_;
};

class FileSource final : public ByteSource {
 public:
  FileSource(int descriptor, std::string name) : descriptor_(descriptor), name_(std::move(name)) {}

  std::size_t read(std::span<char> buffer) override {
    for (;;) {
      const ssize_t count = ::read(descriptor_.get(), buffer.data(), buffer.size());
      if (count >= 0) return static_cast<std::size_t>(count);
      if (errno != EINTR) throw input_error(name_, "cannot be read");
    }
  }

 private:
  Descriptor descriptor_;
  std::string name_;
};

// What a name leads to at the end of its links, so that a link stays a link when its file is
// replaced.
std::string resolve_links(const std::string& name) {
  std::error_code fault;
  const std::filesystem::path resolved = std::filesystem::canonical(name, fault);
  return fault ? name : resolved.string();
}

mode_t mode_of_new_file() {
  const mode_t mask = umask(0);
  umask(mask);
  return 0666 & ~mask;
}

}  // namespace

std::string display_name(const std::string& name) {
  return name == kStandardStream ? "stdin" : name;
}

std::string document_name(const std::string& input_name) {
  return std::filesystem::path(display_name(input_name)).stem().string();
}

std::unique_ptr<ByteSource> open_input(const std::string& name) {
  if (name == kStandardStream) return std::make_unique<FileSource>(STDIN_FILENO, "stdin");
  const int descriptor = open(name.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw input_error(name, "cannot be opened");
  auto source = std::make_unique<FileSource>(descriptor, name);
  struct stat status {};
  if (fstat(descriptor, &status) == 0 && S_ISDIR(status.st_mode)) {
    throw Error({name}, "is a folder; name a file");
  }
  return source;
}

std::string read_all(ByteSource& source, std::size_t limit, const std::string& name) {
  constexpr std::size_t kChunk = std::size_t{1} << 18;
  std::string text;
  for (;;) {
    const std::size_t used = text.size();
    if (used > limit) {
      throw Error({name}, "is larger than the limit of " + std::to_string(limit >> 20) + " MiB");
    }
    text.resize(used + std::max(kChunk, used));
    const std::size_t count = source.read({text.data() + used, text.size() - used});
    text.resize(used + count);
    if (count == 0) return text;
  }
}

OutputFile::OutputFile(const std::string& name) : name_(name) {
  if (name == kStandardStream) {
    name_ = "stdout";
    descriptor_ = STDOUT_FILENO;
    return;
  }
  struct stat status {};
  const bool exists = stat(name.c_str(), &status) == 0;
  if (exists && !S_ISREG(status.st_mode)) {  // a device or a named pipe: nothing to rename
    descriptor_ = open(name.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) throw output_error(name_);
    return;
  }
  destination_ = exists ? resolve_links(name) : name;
  temporary_ = destination_ + ".XXXXXX";
  descriptor_ = mkostemp(temporary_.data(), O_CLOEXEC);
  if (descriptor_ < 0) {
    temporary_.clear();
    throw output_error(name_);
  }
  fchmod(descriptor_, exists ? status.st_mode & 07777 : mode_of_new_file());
}

OutputFile::~OutputFile() {
  if (descriptor_ > STDERR_FILENO) close(descriptor_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno == EPIPE) {
      throw ClosedPipe();
    } else if (errno != EINTR) {
      throw output_error(name_);
    }
  }
}

void OutputFile::commit() {
  if (descriptor_ > STDERR_FILENO) {
    // Some file systems report a full disk only here.
    if (close(std::exchange(descriptor_, -1)) != 0) throw output_error(name_);
  }
  if (temporary_.empty()) return;
  if (rename(temporary_.c_str(), destination_.c_str()) != 0) {
    throw output_error(name_);
  }
  temporary_.clear();
}

}  // namespace libstyle
