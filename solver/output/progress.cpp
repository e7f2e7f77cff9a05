#include "output/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace dld {
namespace {

using std::chrono::duration;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr seconds rate_window{60};

double elapsed_s(Progress::Clock::time_point from, Progress::Clock::time_point to) {
  return duration<double>(to - from).count();
}

}  // namespace

std::string duration_text(double seconds_total) {
  const auto s = static_cast<long>(std::ceil(std::clamp(seconds_total, 0.0, 1e9)));
  char text[64];
  if (s >= 3600) {
    std::snprintf(text, sizeof text, "%ld h %02ld min", s / 3600, s % 3600 / 60);
  } else if (s >= 60) {
    std::snprintf(text, sizeof text, "%ld min %02ld s", s / 60, s % 60);
  } else {
    std::snprintf(text, sizeof text, "%ld s", s);
  }
  return text;
}

Progress::Progress() : Progress(stderr, isatty(fileno(stderr)) == 1) {}

void Progress::start(const std::string& title, double total) {
  title_ = title;
  total_ = total;
  begin_ = Clock::now();
  next_ = begin_;
  recent_.clear();
}

double Progress::remaining_s(double done, Clock::time_point now) {
  recent_.emplace_back(now, done);
  while (recent_.size() > 2 && now - recent_[1].first > rate_window) recent_.pop_front();
  const double span = elapsed_s(recent_.front().first, now);
  const double gained = done - recent_.front().second;
  // Too little evidence for an honest number: say nothing.
  if (span < 0.5 || gained <= 0) return -1;
  return (total_ - done) * span / gained;
}

void Progress::update(double done, const std::string& state) {
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + (terminal_ ? Clock::duration(milliseconds(200)) : Clock::duration(seconds(30)));
  const double remaining = remaining_s(done, now);
  std::string line = title_ + ": ";
  if (total_ > 0) {
    char percent[16];
    std::snprintf(percent, sizeof percent, "%5.1f %%  ", 100 * std::min(1.0, done / total_));
    line += percent;
  }
  line += state + "  (" + duration_text(elapsed_s(begin_, now)) + " elapsed";
  if (total_ > 0 && remaining >= 0) line += ", about " + duration_text(remaining) + " left";
  print(line + ")", false);
}

void Progress::finish(const std::string& state) {
  print(title_ + ": " + state + "  (" + duration_text(elapsed_s(begin_, Clock::now())) + ")", true);
}

void Progress::print(const std::string& line, bool last) {
  if (terminal_) {
    const std::string blank(width_ > line.size() ? width_ - line.size() : 0, ' ');
    std::fprintf(stream_, "\r%s%s%s", line.c_str(), blank.c_str(), last ? "\n" : "");
    width_ = last ? 0 : line.size();
  } else {
    std::fprintf(stream_, "%s\n", line.c_str());
  }
  std::fflush(stream_);
}

}  // namespace dld
