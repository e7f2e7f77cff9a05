#pragma once
/// SIGINT and SIGTERM ask a run to stop at its next check; a passage goes on later from its last pillar line.

namespace dld {

/// From now on the two signals set a flag; a second one of the same kind ends the program at once.
void catch_interrupts();

/// Number of the signal that came, 0 if none.
int interrupted();

}  // namespace dld
