/// Command line of the solver.
///
///   dld run case.json out.h5 --summary summary.json    simulate; the same command resumes after Ctrl-C
///   dld check case.json                    what it simulates, costs, is limited by (--json: every number)
///   dld resolve cases.json out.json        the same in short for many cases, for programs that plan
///   dld verify out.h5 summary.json         are the files of a finished run as they were written?
///   dld schema                             JSON Schema of case files
///
/// Exit codes: 0 done, 2 bad parameters, 3 diverged, 4 input/output, 5 checkpoint of another case or build,
/// 128 + signal when interrupted: 130 Ctrl-C, 143 SIGTERM, 142 end of --wall-time.
#include <CLI/CLI.hpp>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <new>

#include "output/checkpoint.hpp"
#include "output/durable_file.hpp"
#include "output/interrupt.hpp"
#include "output/memory_limit.hpp"
#include "output/provenance.hpp"
#include "output/terminal.hpp"
#include "output/verify.hpp"
#include "output/xdmf.hpp"
#include "parameters/check_text.hpp"
#include "parameters/headline.hpp"
#include "parameters/limits.hpp"
#include "parameters/physical.hpp"
#include "parameters/presets.hpp"
#include "parameters/reader.hpp"
#include "parameters/report.hpp"
#include "parameters/resolve.hpp"
#include "parameters/text.hpp"
#include "scene/registry.hpp"

namespace {

using namespace dld;
using Json = nlohmann::ordered_json;

enum ExitCode {
  done = 0,
  unexpected = 1,
  bad_parameters = 2,
  diverged = 3,
  input_output = 4,
  foreign_checkpoint = 5,
  signal_base = 128
};

struct RunOptions {
  std::string case_file, output_file, summary_file;
  std::string checkpoint_file() const { return output_file + ".checkpoint"; }
  bool force = false, no_resume = false;
  int threads = 1;
  double checkpoint_minutes = default_checkpoint_minutes;
  double wall_time_minutes = 0.0;  // 0: no end
};

// What was given without effect.
void print_warnings(const Case& c, const std::string& file) {
  for (const auto& warning : c.warnings) std::cerr << file << ": warning: " << warning << "\n";
}

// Prints the violated margins; true if none of them makes the run diverge, or if it is forced.
bool may_run(const Case& c, const std::string& file, bool force) {
  const auto margins = stability_margins(c);
  for (const auto& margin : margins) {
    if (margin.ok) continue;
    std::cerr << file << ": " << (margin.fails ? "expected to diverge" : "expected to be inaccurate") << ": "
              << margin.name << " = " << quantity_text(margin.value, margin.unit) << ", the limit is "
              << quantity_text(margin.limit, margin.unit) << "; " << margin.advice << "\n";
  }
  const bool hold = !expected_to_diverge(margins);
  if (!hold && !force) std::cerr << file << ": refused because it is expected to diverge; see --force\n";
  return hold || force;
}

// What became of a diverged run, for the user's eyes.
void explain_divergence(const Json& summary, const Hdf5File& out, bool state_kept) {
  const auto number = [&](const char* key) {
    const auto value = summary.find(key);
    return value != summary.end() && value->is_number() ? quantity_text(value->get<double>(), "")
                                                        : "not a number";
  };
  std::cerr << "diverged at step " << summary.value("failing_step", 0L) << ": "
            << summary.value("failing_quantity", "") << " = " << number("failing_value") << " (limit "
            << number("failing_limit") << ") at " << summary.value("failing_place", "")
            << "\n  likely cure: " << summary.value("advice", "") << "\n";
  const std::string output = out.path().string();
  if (summary.contains("last_good_step"))
    std::cerr << "  last good shape: /membrane/last_good in " << output << "\n";
  if (state_kept) std::cerr << "  last state that was saved: " << output << ".last_good.checkpoint\n";
}

void write_root_attributes(Hdf5File& out, const Case& c, const Json& summary, int threads) {
  out.attribute("/", seal_attribute, "length and checksum at the end of the file");
  out.attribute("/", "status", summary["status"].get<std::string>());
  out.attribute("/", "scene", c.scene);
  out.attribute("/", "provenance", provenance(threads).dump());
  out.attribute("/", "case", echo(c).dump());
  out.attribute("/", "lattice", lattice_numbers(c).dump());
  out.attribute("/", "physical", physical_json(physical_scales(c)).dump());
  out.attribute("/", "summary", summary.dump());
}

// Files by what they are called on the command line.
using NamedFiles = std::vector<std::pair<std::string, std::filesystem::path>>;

std::filesystem::path last_good_checkpoint(const RunOptions& options) {
  return options.output_file + ".last_good.checkpoint";
}

NamedFiles named_for(const RunOptions& options) {
  NamedFiles files = {{"case", options.case_file}, {"output", options.output_file}};
  if (!options.summary_file.empty()) files.emplace_back("summary", options.summary_file);
  return files;
}

// Files that a run makes beside them, and where each stands until it is complete.
NamedFiles made_for(const RunOptions& options) {
  const std::filesystem::path checkpoint = options.checkpoint_file();
  NamedFiles files = {{"checkpoint", checkpoint}};
  for (const auto& path : xdmf_files(options.output_file)) files.emplace_back("XDMF file", path);
  NamedFiles whole = files;
  whole.emplace_back("output", options.output_file);
  if (!options.summary_file.empty()) whole.emplace_back("summary", options.summary_file);
  for (const auto& [name, path] : whole) files.emplace_back("unfinished " + name, part_of(path));
  files.emplace_back("checkpoint before", Checkpoint::previous(checkpoint));
  files.emplace_back("state of a diverged run", last_good_checkpoint(options));
  return files;
}

// One file under two names (links included) would be overwritten by the command that reads it. The names that
// the user gave are compared with all; those made from them differ, and the two checkpoints are one file at
// times.
void require_different_files(const NamedFiles& given, const NamedFiles& made) {
  const auto same = [](const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code none;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(a), none) ==
               std::filesystem::weakly_canonical(std::filesystem::absolute(b), none) ||
           std::filesystem::equivalent(a, b, none);
  };
  NamedFiles others = made;
  for (const auto& [name, path] : given) {
    for (const auto& [other_name, other] : others) {
      if (same(path, other))
        throw CLI::ValidationError(path.string(),
                                   "is the " + name + " and the " + other_name + "; name another file");
    }
    others.emplace_back(name, path);
  }
}

// A file that cannot be written is known before anything is simulated.
void try_files(const RunOptions& options) {
  require_writable(options.output_file);
  for (const auto& [name, path] : made_for(options)) require_writable(path);
  if (options.summary_file.empty()) return;
  require_writable(options.summary_file);
  const std::filesystem::path part = part_of(options.summary_file);
  write_durably(part, {});
  std::filesystem::remove(part);
}

// What keeps the case from this machine, empty if it fits.
std::string lack_of_memory(const Case& c, const std::string& file) {
  const double need = memory_MiB(c);
  const auto limit = memory_limit();
  if (!limit || need < limit->MiB) return "";
  return file + ": needs about " + number_text(std::ceil(need)) + " MiB of memory; there are " +
         number_text(std::floor(limit->MiB)) + " MiB (" + limit->by + "); " + memory_advice(c) +
         ", or take a machine with more\n";
}

int run(const RunOptions& options) {
  require_different_files(named_for(options), made_for(options));
  const Case c = read_case(options.case_file);
  std::cerr << headline(c) << "\n";
  print_warnings(c, options.case_file);
  if (!may_run(c, options.case_file, options.force)) return bad_parameters;
  if (const std::string lack = lack_of_memory(c, options.case_file); !lack.empty()) {
    std::cerr << lack;
    return bad_parameters;
  }
  catch_interrupts(part_of(options.output_file));
  if (options.wall_time_minutes > 0.0) limit_wall_time(options.wall_time_minutes);
  try_files(options);
  Hdf5File out(options.output_file);
  Progress progress;
  RunContext context{.out = out,
                     .progress = progress,
                     .checkpoint = options.checkpoint_file(),
                     .resume = !options.no_resume,
                     .threads = options.threads,
                     .save_timer = SaveTimer(options.checkpoint_minutes)};
  Status status = Status::undecided;
  try {
    status = find_scene(c.scene)(c, context);
  } catch (const std::bad_alloc&) {
    std::cerr << options.case_file << ": out of memory; it needs about "
              << number_text(std::ceil(memory_MiB(c))) << " MiB: " << memory_advice(c)
              << ", or take a machine with more\n";
    return bad_parameters;
  }
  if (status == Status::interrupted) {
    std::cerr << (interrupted() == SIGALRM ? "the wall time is over" : "interrupted") << "; the same command "
              << (context.owns_checkpoint ? "continues from " + context.checkpoint.string() : "starts afresh")
              << "\n";
    return signal_base + interrupted();
  }

  Json summary = {{"scene", c.scene}, {"status", to_string(status)}};
  summary.update(context.summary);
  if (const Json physical = physical_summary(summary, physical_scales(c)); !physical.empty())
    summary["si"].update(physical);
  if (!c.warnings.empty()) summary["warnings"] = c.warnings;
  const auto margins = stability_margins(c);
  if (const Margin* margin = tightest(margins)) {
    summary["tightest_margin"] = margin->name;
    summary["used_share_of_margin"] = margin->share;
  }
  write_root_attributes(out, c, summary, options.threads);
  out.close_sealed();
  if (!write_xdmf(out.path(), context.xdmf))
    std::cerr << "no XDMF file: its readers end a file's name at a colon, as " << out.path().filename()
              << " has one\n";
  if (!options.summary_file.empty()) write_whole(options.summary_file, summary.dump(2) + "\n");
  if (status != Status::diverged) {
    if (context.owns_checkpoint) Checkpoint::remove(context.checkpoint);
    return done;
  }
  if (context.owns_checkpoint) {
    std::filesystem::rename(context.checkpoint, last_good_checkpoint(options));
    Checkpoint::remove(context.checkpoint);
  }
  explain_divergence(summary, out, context.owns_checkpoint);
  return diverged;
}

int verify(const std::string& run_file, const std::string& summary_file, const std::string& case_file) {
  std::optional<std::filesystem::path> summary;
  std::optional<Json> resolved;
  if (!summary_file.empty()) summary = summary_file;
  if (!case_file.empty()) resolved = echo(read_case(case_file));
  const auto problems = verify_run(run_file, summary, resolved);
  for (const std::string& problem : problems) std::cerr << problem << "\n";
  return problems.empty() ? done : input_output;
}

int check(const std::string& case_file, bool force, bool json) {
  const Case c = read_case(case_file);
  std::cout << (json ? check_json(c).dump(2) + "\n" : check_text(c));
  flush_output();
  print_warnings(c, case_file);
  std::cerr << lack_of_memory(c, case_file);
  return may_run(c, case_file, force) ? done : bad_parameters;
}

// One answer a line; 2 if a case of the file cannot be run.
int resolve(const std::string& case_file, const std::string& output_file) {
  if (!output_file.empty()) {
    require_different_files({{"file of cases", case_file}, {"output", output_file}},
                            {{"unfinished output", part_of(output_file)}});
    require_writable(output_file);
  }
  const Json answers = resolve_text(read_text(case_file), case_file);
  std::string text = "[";
  bool all_right = true;
  for (const Json& answer : answers) {
    all_right = all_right && answer["problems"].empty();
    text += (text.size() > 1 ? ",\n" : "\n") + answer.dump();
  }
  text += "\n]\n";
  if (output_file.empty()) {
    std::cout << text;
  } else {
    write_whole(output_file, text);
  }
  return all_right ? done : bad_parameters;
}

int command_line(int argc, char** argv) {
  CLI::App app{"One red blood cell in a deterministic lateral displacement array"};
  app.set_version_flag("--version", [] { return provenance(1).dump(2); });
  app.require_subcommand(1);

  RunOptions options;
  CLI::App* run_command = app.add_subcommand("run", "simulate a case");
  run_command->add_option("case", options.case_file, "case file (JSON)")->required();
  run_command->add_option("output", options.output_file, "output file (HDF5)")->required();
  run_command->add_option("--summary", options.summary_file, "row of results (JSON)");
  run_command->add_option("--threads", options.threads, "threads")
      ->envname("OMP_NUM_THREADS")
      ->transform([](const std::string& list) { return list.substr(0, list.find(',')); })  // of nested levels
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  run_command->add_flag("--force", options.force, "run although a stability margin is violated");
  run_command->add_flag("--no-resume", options.no_resume, "ignore a checkpoint");
  run_command
      ->add_option("--checkpoint-minutes", options.checkpoint_minutes,
                   "wall time from one checkpoint to the next; no result depends on it")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  run_command
      ->add_option("--wall-time", options.wall_time_minutes,
                   "minutes after which the run has stopped with its state saved (exit code 142); the same "
                   "command goes on")
      ->check(CLI::Range(0.001, 1e6));
  std::string case_file;
  CLI::App* check_command =
      app.add_subcommand("check", "say what a case simulates, what it costs and what limits it");
  check_command->add_option("case", case_file, "case file (JSON)")->required();
  bool force_check = false;
  bool json_check = false;
  check_command->add_flag("--json", json_check, "print all numbers, as JSON");
  check_command->add_flag("--force", force_check, "succeed although the case is expected to diverge");
  CLI::App* resolve_command =
      app.add_subcommand("resolve", "what many cases resolve to, what is wrong with them, what they cost");
  std::string cases_file, answers_file;
  resolve_command->add_option("cases", cases_file, "an array of cases, or one (JSON)")->required();
  resolve_command->add_option("output", answers_file, "an array of answers (JSON); printed without it");
  CLI::App* verify_command =
      app.add_subcommand("verify", "tell whether the files of a finished run are as they were written");
  std::string run_file, summary_file, resolved_file;
  verify_command->add_option("run", run_file, "output of a run (HDF5)")->required();
  verify_command->add_option("summary", summary_file, "its summary (JSON)");
  verify_command->add_option("--case", resolved_file, "the case (JSON) that it is said to be of");
  CLI::App* schema_command = app.add_subcommand("schema", "print the JSON Schema of case files");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? done : bad_parameters;
  }
  try {
    if (run_command->parsed()) return run(options);
    if (resolve_command->parsed()) return resolve(cases_file, answers_file);
  } catch (const CLI::ValidationError& error) {
    std::cerr << error.what() << "\n";
    return bad_parameters;
  }
  if (verify_command->parsed()) return verify(run_file, summary_file, resolved_file);
  if (check_command->parsed()) return check(case_file, force_check, json_check);
  if (schema_command->parsed()) std::cout << case_schema().dump(2) << "\n";
  return done;
}

}  // namespace

int main(int argc, char** argv) {
  const PrintableStream output(std::cout), errors(std::cerr);
  try {
    const int status = command_line(argc, argv);
    flush_output();
    return status;
  } catch (const dld::CaseError& error) {
    std::cerr << error.what() << "\n";
    return bad_parameters;
  } catch (const dld::CheckpointMismatch& error) {
    std::cerr << error.what() << "\n";
    return foreign_checkpoint;
  } catch (const dld::IoError& error) {
    std::cerr << error.what() << "\n";
    return input_output;
  } catch (const std::filesystem::filesystem_error& error) {
    std::cerr << error.what() << "\n";
    return input_output;
  } catch (const std::exception& error) {
    std::cerr << "unexpected failure: " << error.what() << "\n";
    return unexpected;
  }
}
