#pragma once
/// Progress of a run: a rewritten line on a terminal, rare log lines elsewhere (stderr).
#include <chrono>
#include <cstdio>
#include <deque>
#include <string>

namespace dld {

/// Reports done / total with the remaining time that the recent rate (last minute) allows. A scene calls
///   progress.start("passage", total);
///   if (progress.due()) progress.update(done, "row 3, gap position 4.2 um");
///   progress.finish("displaced");
class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  /// `terminal` rewrites a line at most 5 times per second; otherwise one line at most every 30 s.
  explicit Progress(std::FILE* stream, bool terminal) : stream_(stream), terminal_(terminal) {}
  /// On stderr, in the way that suits what stderr is.
  Progress();

  /// Begins a stage; total <= 0 means unknown (no fraction, no remaining time).
  void start(const std::string& title, double total = 0);
  /// The total may become known, or change, on the way.
  void set_total(double total) { total_ = total; }
  /// True when update() would print. Costs one look at the clock: ask it at most every few steps.
  bool due() const { return Clock::now() >= next_; }
  /// Prints `done` of `total` and the state if it is time to.
  void update(double done, const std::string& state);
  /// Ends the stage with a last line.
  void finish(const std::string& state);

 private:
  /// Seconds until `total` at the rate of the recent updates; negative when unknown.
  double remaining_s(double done, Clock::time_point now);
  void print(const std::string& line, bool last);

  std::FILE* stream_;
  bool terminal_;
  std::string title_;
  double total_ = 0;
  Clock::time_point begin_{}, next_{};
  std::deque<std::pair<Clock::time_point, double>> recent_;
  std::size_t width_ = 0;  ///< of the last line on the terminal, to blank it
};

/// "1 h 05 min", "3 min 20 s", "12 s".
std::string duration_text(double seconds);

}  // namespace dld
