#pragma once
/// What asks a run to stop before its end: SIGINT, SIGTERM, and the end of its wall time (SIGALRM).
#include <filesystem>

namespace dld {

/// From now on the signals set a flag, which a run looks at many times a second; a second one of the same
/// kind ends the program at once. So does the first, as long as nobody has looked: what is set up then can
/// take a while, and all there is to tidy is the file that was begun.
void catch_interrupts(const std::filesystem::path& unfinished_file = {});

/// Sets the flag, too, shortly before so many minutes from now: early enough to save the state.
void limit_wall_time(double minutes);

/// Number of the signal that came, 0 if none.
int interrupted();

}  // namespace dld
