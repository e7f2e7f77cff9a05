#pragma once
/// What every scene gets and gives back.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "output/hdf5_file.hpp"
#include "output/progress.hpp"
#include "output/save_timer.hpp"
#include "output/xdmf.hpp"
#include "parameters/case.hpp"

namespace dld {

enum class Status {
  converged,    ///< the steady state was reached (streamlines, stretching, channel, shear)
  displaced,    ///< passage: bumped at every row, return map at its fixed point
  zigzag,       ///< passage: fell back a lane again and again
  undecided,    ///< passage: no proof of either within the allowed rows or steps
  diverged,     ///< a quantity left its bounds; the summary names it
  interrupted,  ///< by a signal or the end of the wall time; what a scene saves for its continuation is its
                ///< checkpoint, if it has one
};

std::string to_string(Status status);

/// Wall time from one checkpoint to the next, unless the command line says otherwise.
constexpr double default_checkpoint_minutes = 5.0;

/// The surroundings of a run. The scene writes its datasets to `out`, its row of results to `summary`
/// and the shapes worth seeing to `xdmf`; root attributes and the end of the file are the caller's.
struct RunContext {
  Hdf5File& out;
  Progress& progress;
  std::filesystem::path checkpoint;  ///< where to save the state
  bool resume = true;                ///< continue from the checkpoint if there is one
  nlohmann::ordered_json summary = nlohmann::ordered_json::object();
  XdmfDescription xdmf = {};
  int threads = 1;               ///< that share a time step; results do not depend on it
  bool owns_checkpoint = false;  ///< set by a scene that has read or written the file `checkpoint`
  SaveTimer save_timer{default_checkpoint_minutes};  ///< asks for a checkpoint between the regular ones
};

using SceneFunction = Status (*)(const Case&, RunContext&);

}  // namespace dld
