#include "output/interrupt.hpp"

#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <csignal>
#include <cstring>
#include <string>
#include <string_view>

namespace dld {
namespace {

volatile std::sig_atomic_t received = 0;
volatile std::sig_atomic_t looked_at = 0;
char unfinished[PATH_MAX] = "";

// Async-signal-safe: sets the flag and restores the default action for a second signal. Before the first look
// at the flag there is nothing to save.
void on_signal(int number) {
  if (looked_at == 0) {
    constexpr std::string_view words = "interrupted before the first step; the same command starts again\n";
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, words.data(), words.size());
    if (unfinished[0] != 0) ::unlink(unfinished);
    ::_exit(128 + number);
  }
  received = number;
  std::signal(number, SIG_DFL);
}

// A twentieth of the time, a minute at the most, is left for saving the state.
constexpr double share_kept = 0.05, longest_kept_s = 60.0;

}  // namespace

void catch_interrupts(const std::filesystem::path& unfinished_file) {
  looked_at = 0;
  const std::string& path = unfinished_file.native();
  if (path.size() < sizeof unfinished) std::strcpy(unfinished, path.c_str());
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

void limit_wall_time(double minutes) {
  std::signal(SIGALRM, on_signal);
  const double limit_s = 60.0 * minutes;
  const double run_s = limit_s - std::min(share_kept * limit_s, longest_kept_s);
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(run_s);
  timer.it_value.tv_usec = std::max<suseconds_t>(1, std::lround(1e6 * (run_s - std::floor(run_s))) % 1000000);
  setitimer(ITIMER_REAL, &timer, nullptr);
}

int interrupted() {
  looked_at = 1;
  return received;
}

}  // namespace dld
