#pragma once
/// Strict reader of case files: every violation is reported at once, and what was resolved is echoed.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "parameters/case.hpp"

namespace dld {

/// One violation: where, what was found, what is allowed, what to change.
struct Problem {
  std::string pointer;  ///< JSON pointer, "/fluid/relaxation_time"
  std::string value;    ///< as it stands in the file
  std::string allowed;
  std::string advice;
};

/// A case that cannot be run (exit code 2). what() lists all problems, one per line.
struct CaseError : std::runtime_error {
  CaseError(const std::string& file, std::vector<Problem> list);
  std::vector<Problem> problems;
};

/// A case as it was understood, and all that is wrong with it; what is wrong keeps its default.
struct Reading {
  Case c;
  std::vector<Problem> problems;
};

/// Resolves and checks the tree of one case; mesh files are relative to `folder`.
Reading read_tree(const nlohmann::ordered_json& root, const std::string& folder);

/// Reads, resolves defaults and checks a file: syntax, names, types and ranges first, then the rules that
/// join several parameters (consistency.hpp). Throws CaseError; IoError stays with output/, so a file
/// that cannot be opened is a CaseError too.
Case read_case(const std::filesystem::path& path);

/// The text of a file; throws CaseError.
std::string read_text(const std::filesystem::path& path);

/// The same for a text; `name` stands for the file in messages and for where mesh files are relative to.
Case parse_case(const std::string& text, const std::string& name);

/// The resolved case with all defaults; reading it gives the same case.
nlohmann::ordered_json echo(const Case& c);

/// JSON Schema (2020-12) of case files: exactly what the reader accepts, short of the consistency rules.
nlohmann::ordered_json case_schema();

}  // namespace dld
