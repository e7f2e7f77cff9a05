#pragma once
/// When the next timed checkpoint is due.
#include <chrono>

namespace dld {

/// A time of the machine and not of the run: no result may depend on it.
class SaveTimer {
 public:
  using Clock = std::chrono::steady_clock;

  explicit SaveTimer(double minutes) : interval_(minutes) {}
  /// The interval has passed since the last restart.
  bool due() const { return Clock::now() - last_ >= interval_; }
  void restart() { last_ = Clock::now(); }

 private:
  std::chrono::duration<double, std::ratio<60>> interval_;
  Clock::time_point last_ = Clock::now();
};

}  // namespace dld
