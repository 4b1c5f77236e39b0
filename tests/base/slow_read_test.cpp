// Reading from a disk that does not answer. There is none, so this program's read() is one.

#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file.h"

namespace {

std::atomic<int> secondsAsleep{0};

}  // namespace

// In the place of the C library's.
extern "C" ssize_t read(int file, void* bytes, size_t size) {
  std::this_thread::sleep_for(std::chrono::seconds(secondsAsleep));
  return ::syscall(SYS_read, file, bytes, size);
}

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

class SlowRead : public testing::Test {
 protected:
  SlowRead() { writeFile(path, std::string(100'000, 'x')); }
  ~SlowRead() override {
    secondsAsleep = 0;
    fs::remove(path);
  }
  const fs::path path = fs::path(testing::TempDir()) / ("slow-" + std::to_string(::getpid()));
};

TEST_F(SlowRead, AFileThatIsThereIsReadInTheBackground) {
  const CancelToken token;
  EXPECT_EQ(readFile(path, 1 << 20, {}, &token).size, 100'000u);
  EXPECT_THROW(readFile(path, 10, {}, &token), Error);
  EXPECT_THROW(readFile("nowhere", 10, {}, &token), Error);
}

TEST_F(SlowRead, IsCancelledThoughTheDiskDoesNotAnswer) {
  secondsAsleep = 5;
  const CancelToken token;
  std::thread impatient([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    token.cancel();
  });
  const auto start = Clock::now();
  EXPECT_THROW(readFile(path, 1 << 20, {}, &token), Cancelled);
  EXPECT_LT(Clock::now() - start, std::chrono::seconds(2));
  impatient.join();
}

}  // namespace
}  // namespace anamorph
