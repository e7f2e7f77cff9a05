#include "output/interrupt.hpp"

#include <csignal>

namespace dld {
namespace {

volatile std::sig_atomic_t received = 0;

// Async-signal-safe: sets the flag and restores the default action for a second signal.
void on_signal(int number) {
  received = number;
  std::signal(number, SIG_DFL);
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

int interrupted() {
  return received;
}

}  // namespace dld
