#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <limits>
#include <numeric>
#include <sstream>
#include <thread>

#include "output/checkpoint.hpp"
#include "output/hdf5_file.hpp"
#include "output/interrupt.hpp"
#include "output/memory_limit.hpp"
#include "output/progress.hpp"
#include "output/provenance.hpp"
#include "output/xdmf.hpp"
#include "scene/registry.hpp"

namespace dld {
namespace {

namespace fs = std::filesystem;

// A folder of its own for every test, removed at its end.
class Output : public testing::Test {
 protected:
  void SetUp() override {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::temp_directory_path() / ("dld_output_" + test + "_" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string bytes(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
  }

  static void write_sample(const fs::path& path) {
    Hdf5File file(path);
    std::vector<double> field(100 * 50 * 2);
    std::iota(field.begin(), field.end(), 0.5);
    file.write("/flow/velocity", std::span<const double>(field), {100, 50, 2}, "lu", "a field");
    file.write("/trajectory/step", std::vector<std::int64_t>{1, 2, 3}, "steps", "a list");
    file.attribute("/", "status", "converged");
    file.close();
  }

  fs::path folder_;
};

TEST_F(Output, ArraysOfEveryTypeComeBack) {
  const fs::path path = folder_ / "types.h5";
  {
    Hdf5File file(path);
    file.write("/d", std::vector<double>{1.5, -2}, "um", "doubles");
    file.write("/a/b/f", std::vector<float>{0.25f}, "lu", "floats");
    file.write("/i", std::vector<std::int32_t>{-7, 8}, "none", "integers");
    file.write("/l", std::vector<std::int64_t>{std::int64_t{1} << 40}, "none", "long integers");
    file.write("/u", std::vector<std::uint8_t>{0, 255}, "none", "flags");
    file.write("/empty", std::vector<double>{}, "um", "nothing");
    file.write_scalar("/s", 3.25, "um", "a number");
    file.close();
  }
  const Hdf5Reader file(path);
  EXPECT_EQ(file.read<double>("/d"), (std::vector<double>{1.5, -2}));
  EXPECT_EQ(file.read<float>("/a/b/f"), std::vector<float>{0.25f});
  EXPECT_EQ(file.read<std::int32_t>("/i"), (std::vector<std::int32_t>{-7, 8}));
  EXPECT_EQ(file.read<std::int64_t>("/l"), std::vector<std::int64_t>{std::int64_t{1} << 40});
  EXPECT_EQ(file.read<std::uint8_t>("/u"), (std::vector<std::uint8_t>{0, 255}));
  EXPECT_TRUE(file.read<double>("/empty").empty());
  EXPECT_EQ(file.shape("/s"), Shape{});
  EXPECT_EQ(file.read<double>("/s"), std::vector<double>{3.25});
  EXPECT_EQ(file.type("/a/b/f"), Hdf5Reader::Type::float32);
  EXPECT_EQ(file.text_attribute("/a/b/f", "unit"), "lu");
  EXPECT_EQ(file.text_attribute("/d", "description"), "doubles");
  EXPECT_TRUE(file.exists("/a/b"));
  EXPECT_FALSE(file.exists("/a/c/f"));
  EXPECT_THROW(file.read<double>("/missing"), IoError);
}

TEST_F(Output, MatricesAreWrittenByRows) {
  Eigen::MatrixX3d vertices(2, 3);
  vertices << 1, 2, 3, 4, 5, 6;
  const fs::path path = folder_ / "matrix.h5";
  {
    Hdf5File file(path);
    file.write_matrix("/membrane/reference", vertices, "um", "vertices");
    file.write_matrix("/membrane/faces", Eigen::MatrixX3i::Constant(4, 3, 9), "none", "faces");
    file.close();
  }
  const Hdf5Reader file(path);
  EXPECT_EQ(file.shape("/membrane/reference"), (Shape{2, 3}));
  EXPECT_EQ(file.read<double>("/membrane/reference"), (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(file.type("/membrane/faces"), Hdf5Reader::Type::int32);
  EXPECT_EQ(file.members("/membrane"), (std::vector<std::string>{"faces", "reference"}));
}

TEST_F(Output, CompressedArraysComeBack) {
  write_sample(folder_ / "sample.h5");
  const Hdf5Reader file(folder_ / "sample.h5");
  EXPECT_EQ(file.shape("/flow/velocity"), (Shape{100, 50, 2}));
  const auto field = file.read<double>("/flow/velocity");
  EXPECT_EQ(field.front(), 0.5);
  EXPECT_EQ(field.back(), 9999.5);
  EXPECT_LT(fs::file_size(folder_ / "sample.h5"), field.size() * sizeof(double) / 2);
}

TEST_F(Output, EqualCallsMakeEqualBytes) {
  write_sample(folder_ / "first.h5");
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // object times count seconds
  write_sample(folder_ / "second.h5");
  EXPECT_EQ(bytes(folder_ / "first.h5"), bytes(folder_ / "second.h5"));
}

TEST_F(Output, AnUnfinishedFileLeavesNothing) {
  const fs::path path = folder_ / "unfinished.h5";
  {
    Hdf5File file(path);
    file.write_scalar("/x", 1.0, "none", "x");
    EXPECT_TRUE(fs::exists(path.string() + ".part"));
    EXPECT_FALSE(fs::exists(path));
  }
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(Output, RefusesWhatCannotBeWritten) {
  EXPECT_THROW(Hdf5File(folder_ / "no" / "such" / "folder.h5"), IoError);
  Hdf5File file(folder_ / "refuse.h5");
  const std::vector<double> values{1, 2, 3};
  EXPECT_THROW(file.write("/x", std::span<const double>(values), {2, 2}, "none", "wrong shape"), IoError);
  EXPECT_THROW(file.write("x", values, "none", "no slash"), IoError);
  file.write("/x", values, "none", "x");
  EXPECT_THROW(file.write("/x", values, "none", "twice"), IoError);
}

TEST_F(Output, CheckpointComesBack) {
  const fs::path path = folder_ / "run.checkpoint";
  Checkpoint saved("{\"scene\":\"passage\"}");
  saved.set("populations", std::vector<float>{0.1f, 0.2f});
  saved.set("vertices", std::vector<double>{std::nextafter(1.0, 2.0)});
  saved.set("step", std::int64_t{123456789012});
  saved.set("time", 0.1);
  saved.set("state", std::string("row 3"));
  saved.save(path);
  std::ostringstream log;
  const auto loaded = Checkpoint::load(path, "{\"scene\":\"passage\"}", log);
  ASSERT_TRUE(loaded.has_value());
  EXPECT_EQ(loaded->get<std::vector<float>>("populations"), (std::vector<float>{0.1f, 0.2f}));
  EXPECT_EQ(loaded->get<std::vector<double>>("vertices").at(0), std::nextafter(1.0, 2.0));
  EXPECT_EQ(loaded->integer("step"), 123456789012);
  EXPECT_EQ(loaded->get<std::vector<double>>("time").at(0), 0.1);
  EXPECT_EQ(loaded->get<std::string>("state"), "row 3");
  EXPECT_THROW(loaded->get<std::vector<double>>("nothing"), IoError);
  EXPECT_THROW(loaded->get<std::vector<double>>("populations"), IoError);
}

TEST_F(Output, CheckpointOfAnotherCaseIsRefused) {
  const auto path = folder_ / "run.checkpoint";
  std::ostringstream log;
  Checkpoint("one").save(path);
  EXPECT_THROW(Checkpoint::load(path, "two", log), CheckpointMismatch);
  EXPECT_TRUE(std::filesystem::exists(path));
  EXPECT_FALSE(Checkpoint::load(folder_ / "absent", "one", log).has_value());
}

/// Every byte of a checkpoint is under its seal: whichever is changed, the state before it is taken.
TEST_F(Output, DamagedCheckpointIsPutAsideForTheOneBefore) {
  const auto path = folder_ / "run.checkpoint";
  Checkpoint state("case");
  state.set("row", std::int64_t{1});
  state.save(path);
  state.set("row", std::int64_t{2});
  state.save(path);
  const std::vector<char> good = read_bytes(path);
  const auto row_after = [&](const std::vector<char>& bytes) {
    write_durably(path, bytes);
    std::ostringstream log;
    const auto loaded = Checkpoint::load(path, "case", log);
    EXPECT_EQ(log.str().find("run.checkpoint is damaged") != std::string::npos, bytes != good);
    return loaded ? loaded->integer("row") : -1;
  };
  EXPECT_EQ(row_after(good), 2);
  for (std::size_t i = 0; i < good.size(); i += good.size() / 97) {
    std::vector<char> bytes = good;
    bytes[i] = static_cast<char>(bytes[i] ^ 4);
    EXPECT_EQ(row_after(bytes), 1) << "byte " << i;
  }
  for (const std::size_t length : {std::size_t{0}, std::size_t{10}, good.size() / 2, good.size() - 1}) {
    EXPECT_EQ(row_after({good.begin(), good.begin() + static_cast<long>(length)}), 1) << length;
  }
  Checkpoint::remove(path);
  std::ostringstream log;
  EXPECT_FALSE(Checkpoint::load(path, "case", log).has_value());
}

XdmfGrid sample_grid(const std::string& name) {
  return {
      .name = name,
      .points = "/" + name + "/points",
      .cells = "/cells",
      .n_points = 12,
      .n_cells = 20,
      .fields = {{.name = "strain", .dataset = "/" + name + "/strain", .centre = XdmfField::Centre::cell}}};
}

TEST_F(Output, XdmfNamesTheDatasets) {
  const XdmfDescription description{
      .series = {{sample_grid("a"), 1}, {sample_grid("b"), 2.5}, {sample_grid("twice"), 2.5}},
      .fixed = {sample_grid("pillars")}};
  EXPECT_TRUE(write_xdmf(folder_ / "run.h5", description));
  const std::string text = bytes(folder_ / "run.xdmf");
  for (const char* part :
       {">run.h5:/a/points<", ">run.h5:/b/strain<", "<Time Value=\"2.5\"/>", ">run.h5:/cells<",
        "Dimensions=\"12 3\"", "Dimensions=\"20 3\"", "Dimensions=\"20\""}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(text.find("twice"), std::string::npos) << "readers want one shape at a time";
  EXPECT_EQ(text.find(folder_.string()), std::string::npos);
  EXPECT_EQ(bytes(folder_ / "run.pillars.xdmf").find("Collection"), std::string::npos);
}

TEST_F(Output, XdmfOfARunWithNothingToShowIsRemoved) {
  write_xdmf(folder_ / "run.h5", {.series = {}, .fixed = {sample_grid("pillars")}});
  EXPECT_TRUE(fs::exists(folder_ / "run.pillars.xdmf"));
  write_xdmf(folder_ / "run.h5", {});
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(Output, XdmfEscapesNamesAndRefusesAColon) {
  const XdmfDescription description{.series = {{sample_grid("a"), 1}}, .fixed = {}};
  EXPECT_TRUE(write_xdmf(folder_ / "a & b <1>.h5", description));
  EXPECT_NE(bytes(folder_ / "a & b <1>.xdmf").find(">a &amp; b &lt;1&gt;.h5:/a/points<"), std::string::npos);
  EXPECT_FALSE(write_xdmf(folder_ / "a:b.h5", description));
  EXPECT_FALSE(fs::exists(folder_ / "a:b.xdmf"));
}

TEST_F(Output, PhysicalUnitsAreAttributes) {
  Hdf5File file(folder_ / "units.h5");
  file.write("/v", std::vector<double>{0.01}, "lu", "a velocity");
  file.physical("/v", "mm/s", 250);
  file.write("/w", std::vector<double>{0.01}, "lu", "one without a scale");
  file.physical("/w", "mm/s", 0);
  file.close();
  const Hdf5Reader reader(folder_ / "units.h5");
  EXPECT_EQ(reader.text_attribute("/v", "physical_unit"), "mm/s");
  EXPECT_EQ(reader.text_attributes("/v").size(), 4u);
  EXPECT_EQ(reader.text_attributes("/w").size(), 2u);
}

TEST(ProgressText, Durations) {
  EXPECT_EQ(duration_text(11.2), "12 s");
  EXPECT_EQ(duration_text(200), "3 min 20 s");
  EXPECT_EQ(duration_text(3900), "1 h 05 min");
  EXPECT_EQ(duration_text(-1), "0 s");
}

// Text that a progress report writes to its stream.
template <class Report>
std::string printed(bool terminal, Report report) {
  std::FILE* stream = std::tmpfile();
  Progress progress(stream, terminal);
  report(progress);
  std::rewind(stream);
  std::string text(4096, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), stream));
  std::fclose(stream);
  return text;
}

TEST(ProgressText, LogLinesAreRare) {
  const std::string text = printed(false, [](Progress& progress) {
    progress.start("passage", 10);
    for (int i = 0; i <= 10; ++i) progress.update(i, "row " + std::to_string(i));
    EXPECT_FALSE(progress.due());
    progress.finish("displaced");
  });
  EXPECT_EQ(std::ranges::count(text, '\n'), 2);
  EXPECT_NE(text.find("passage:   0.0 %  row 0"), std::string::npos) << text;
  EXPECT_NE(text.find("displaced"), std::string::npos);
}

TEST(ProgressText, TerminalRewritesItsLine) {
  const std::string text = printed(true, [](Progress& progress) {
    progress.start("channel");
    progress.update(1, "a long state of the run");
    std::this_thread::sleep_for(std::chrono::milliseconds(220));
    EXPECT_TRUE(progress.due());
    progress.update(2, "short");
    progress.finish("converged");
  });
  EXPECT_EQ(std::ranges::count(text, '\r'), 3);
  EXPECT_EQ(std::ranges::count(text, '\n'), 1);
  EXPECT_EQ(text.find('%'), std::string::npos);  // the total is unknown
}

// While a run is set up, which nobody can look at, a signal ends it and tidies the file that was begun.
TEST_F(Output, ASignalDuringTheSetUpEndsTheProgram) {
  const fs::path part = part_of(folder_ / "out.h5");
  std::ofstream(part) << "begun";
  const auto set_up = [&] {
    catch_interrupts(part);
    std::raise(SIGTERM);
  };
  EXPECT_EXIT(set_up(), testing::ExitedWithCode(128 + SIGTERM), "before the first step");
  EXPECT_FALSE(fs::exists(part));
}

TEST_F(Output, MemoryIsLimitedByTheTightestOfMachineAndGroups) {
  const auto write = [&](const std::string& name, const std::string& text) {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
  };
  EXPECT_FALSE(memory_limit(folder_).has_value());
  write("proc/meminfo", "MemTotal: 9000000 kB\nMemAvailable: 2048000 kB\n");
  EXPECT_EQ(memory_limit(folder_)->MiB, 2000);
  EXPECT_NE(memory_limit(folder_)->by.find("machine"), std::string::npos);
  write("proc/self/cgroup", "0::/jobs/one\n");
  write("sys/fs/cgroup/jobs/one/memory.max", "max\n");
  EXPECT_EQ(memory_limit(folder_)->MiB, 2000);
  write("sys/fs/cgroup/jobs/memory.max", "1073741824\n");
  write("sys/fs/cgroup/jobs/memory.current", "104857600\n");
  EXPECT_EQ(memory_limit(folder_)->MiB, 1024 - 100);
  EXPECT_NE(memory_limit(folder_)->by.find("group"), std::string::npos);
  write("proc/self/cgroup", "5:memory:/job\n");
  write("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "9223372036854771712\n");  // no limit
  EXPECT_EQ(memory_limit(folder_)->MiB, 2000);
  write("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "209715200\n");
  EXPECT_EQ(memory_limit(folder_)->MiB, 200);
}

TEST(Interrupt, SignalSetsTheFlag) {
  catch_interrupts();
  EXPECT_EQ(interrupted(), 0);  // as a run looks before its steps
  std::raise(SIGTERM);
  EXPECT_EQ(interrupted(), SIGTERM);
}

TEST(Provenance, NamesBuildAndLibraries) {
  const auto p = provenance(3);
  EXPECT_EQ(p["threads"], 3);
  EXPECT_FALSE(p["git_commit"].get<std::string>().empty());
  EXPECT_EQ(p["libraries"].size(), 5u);
  EXPECT_EQ(provenance(3).dump(), p.dump());
}

TEST(SceneStatus, HasAName) {
  EXPECT_EQ(to_string(Status::zigzag), "zigzag");
  EXPECT_EQ(to_string(Status::interrupted), "interrupted");
}

}  // namespace
}  // namespace dld
