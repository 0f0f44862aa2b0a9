// Runs that are stopped, killed, or left without room, and what is kept of them.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <map>
#include <sstream>
#include <thread>

#include "base/seeded_stream.hpp"
#include "unit/cli/program.hpp"

namespace lamina::test {
namespace {

const std::vector<std::string> kRun{"run",       "self-sum",    "--rays", "1000",
                                    "--numbers", "float,exact", "--seed", "3"};

std::string in_shell(const std::vector<std::string>& arguments) {
  std::string text;
  for (const std::string& argument : arguments) {
    text += argument + " ";
  }
  return text;
}

// Starts the run into `folder` in a process of its own, which writes to `folder`.out and .error.
pid_t start(const std::string& folder, rlim_t file_size = RLIM_INFINITY) {
  std::vector<std::string> arguments = kRun;
  arguments.insert(arguments.begin(), LAMINA_PROGRAM);
  arguments.insert(arguments.end(), {"--out", folder});
  if (std::filesystem::exists(folder + "/run.sqlite")) {
    arguments.emplace_back("--resume");
  }
  std::vector<char*> argv;
  for (std::string& argument : arguments) {
    argv.push_back(argument.data());
  }
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    const rlimit limit{file_size, file_size};
    setrlimit(RLIMIT_FSIZE, &limit);
    signal(SIGXFSZ, SIG_IGN);  // a full file is an error of write(), as a full disk is
    for (const auto& [name, stream] :
         {std::pair{".out", STDOUT_FILENO}, {".error", STDERR_FILENO}}) {
      dup2(open((folder + name).c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), stream);
    }
    execv(argv[0], argv.data());
    _exit(127);
  }
  return child;
}

int status_of(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string whole_table() {
  static const std::string table = lamina(in_shell(kRun) + "--format csv").out;
  return table;
}

std::string resumed_table(const std::string& folder) {
  const Outcome outcome = lamina(in_shell(kRun) + "--format csv --resume --out " + folder);
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  return outcome.out;
}

TEST(RunTest, ResumesToTheSameTableAfterKillsAtRandomMoments) {
  ASSERT_GT(whole_table().size(), 1000U);
  base::SeededStream stream("run_test/kill", 1, 0);
  std::size_t killed = 0;
  const Scratch scratch;
  for (int round = 0; killed < 20; ++round) {
    ASSERT_LT(round, 200);
    const std::string folder = scratch.path("run" + std::to_string(round));
    // Until it is whole: killed, gone on with, killed again.
    for (bool done = false; !done;) {
      const pid_t child = start(folder);
      std::this_thread::sleep_for(std::chrono::microseconds(stream.integer(0, 250'000)));
      kill(child, SIGKILL);
      int status = 0;
      waitpid(child, &status, 0);
      done = WIFEXITED(status);
      killed += done ? 0 : 1;
      if (!done && killed >= 20) {
        break;
      }
    }
    EXPECT_EQ(resumed_table(folder), whole_table());
  }
}

TEST(RunTest, KeepsWhatIsFinishedWhereThereIsNoRoom) {
  const Scratch scratch;
  const std::string folder = scratch.path("run");
  ASSERT_EQ(status_of(start(scratch.path("whole"))), 0);
  const auto whole = std::filesystem::file_size(scratch.path("whole/run.sqlite"));
  constexpr std::uintmax_t kPage = 4096;  // of SQLite
  EXPECT_EQ(status_of(start(folder, whole - 2 * kPage)), 2);
  EXPECT_NE(read(folder + ".error").find("cannot be written"), std::string::npos);
  const Outcome some = lamina("table " + folder);
  ASSERT_EQ(some.status, 0) << some.error;
  EXPECT_NE(some.out.find("Not finished: "), std::string::npos);
  EXPECT_EQ(some.out.find("Not finished: 0 of"), std::string::npos);
  EXPECT_EQ(resumed_table(folder), whole_table());
  EXPECT_EQ(lamina("table " + folder + " --format csv").out, whole_table());
}

TEST(RunTest, ATruncatedStoreSaysWhatToDo) {
  const Scratch scratch;
  const std::string folder = scratch.path("run");
  ASSERT_EQ(status_of(start(folder)), 0);
  const std::string file = folder + "/run.sqlite";
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  for (const std::string& command :
       {"table " + folder, in_shell(kRun) + "--resume --out " + folder}) {
    const Outcome outcome = lamina(command);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.error.find("is damaged"), std::string::npos) << outcome.error;
    EXPECT_NE(outcome.error.find("run again"), std::string::npos) << outcome.error;
  }
}

TEST(RunTest, InterruptKeepsWhatIsFinishedAndSaysHowToGoOn) {
  const Scratch scratch;
  const std::string folder = scratch.path("run");
  const pid_t child = start(folder);
  // Once the store is there, the first block is on its way.
  while (!std::filesystem::exists(folder + "/run.sqlite")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  kill(child, SIGINT);
  EXPECT_EQ(status_of(child), 130);
  EXPECT_NE(read(folder + ".error").find("--resume"), std::string::npos) << read(folder + ".error");
  EXPECT_NE(read(folder + ".out").find("Not finished: "), std::string::npos);
  EXPECT_EQ(resumed_table(folder), whole_table());
}

TEST(RunTest, TablesDoNotDependOnThreads) {
  EXPECT_EQ(lamina(in_shell(kRun) + "--format csv --threads 1").out, whole_table());
  EXPECT_EQ(lamina(in_shell(kRun) + "--format csv --threads 2").out, whole_table());
}

TEST(RunTest, OtherSettingsAreNotMixedIn) {
  const Scratch scratch;
  const std::string folder = scratch.path("run");
  ASSERT_EQ(lamina("run four-cases --rays 24 --numbers float --out " + folder).status, 0);
  const auto refused = [&](const std::string& arguments, const std::string& part) {
    const Outcome outcome = lamina("run " + arguments + " --out " + folder);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_NE(outcome.error.find(part), std::string::npos) << outcome.error;
  };
  refused("four-cases --rays 24 --numbers float", "--resume");
  refused("four-cases --rays 48 --numbers float --resume", "rays 24, here 48");
  refused("four-cases --rays 24 --numbers double --resume", "numbers float, here double");
  refused("four-cases --rays 24 --numbers float --seed 2 --resume", "seed 1, here 2");
  refused("self-sum --rays 24 --numbers float --resume", "experiment four-cases");
}

// The fields of a line of CSV, quotes undone (RFC 4180).
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += line[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  EXPECT_FALSE(quoted) << line;
  return fields;
}

// Every experiment that needs no corpus, with a few rays: its tables parse, and regularized in
// exact numbers, which is the truth's method, has no artifact.
TEST(RunTest, EveryExperimentRunsAndItsTablesParse) {
  const Scratch scratch;
  std::istringstream list(lamina("list experiments").out);
  std::size_t experiments = 0;
  for (std::string line; std::getline(list, line);) {
    const std::string name = line.substr(0, line.find(' '));
    if (name == "real-models") {
      continue;
    }
    SCOPED_TRACE(name);
    ++experiments;
    const std::string folder = scratch.path(name);
    // A ray at least for each series: these have about a hundred, or more.
    const bool many = name == "self-intersection" || name == "grazing-spawn" ||
                      name == "sweep-accuracy" || name.starts_with("solver");
    // Those that make records of their own: their first table, and another.
    const std::map<std::string, std::array<std::string, 2>> own_tables{
        {"solver-accuracy", {"accuracy", "ideal"}},
        {"sweep-accuracy", {"accuracy", "times"}},
        {"printed-formulas", {"normals", "caps"}},
        {"sweep-race", {"race", "crossings"}}};
    const bool judges_rays = !own_tables.contains(name);
    const Outcome run = lamina("run " + name + (many ? " --rays 200" : " --rays 60") +
                               " --numbers double,exact --out " + folder);
    ASSERT_EQ(run.status, 0) << run.error;
    EXPECT_EQ(run.out, lamina("table " + folder).out);

    const std::string table = judges_rays ? "artifacts" : own_tables.at(name)[0];
    std::istringstream csv(lamina("table " + folder + " --table " + table + " --format csv").out);
    std::string header;
    std::getline(csv, header);
    const std::vector<std::string> names = fields_of(header);
    std::size_t rows = 0;
    bool regularized = false;
    const bool spawned = header.find("self_intersection") != std::string::npos;
    for (std::string row; std::getline(csv, row); ++rows) {
      const std::vector<std::string> fields = fields_of(row);
      ASSERT_EQ(fields.size(), names.size()) << row;
      std::map<std::string, std::string> value;
      for (std::size_t i = 0; i < names.size(); ++i) {
        value[names[i]] = fields[i];
      }
      if (value["method"] == "wyvill-trotman:secondary:cluster" && name.starts_with("coincident")) {
        EXPECT_EQ(value["first_wrong_count"], "0");
        EXPECT_NE(value["rays"], "0");
      }
      if (value["method"] == "regularized" && value["number"] == "exact") {
        regularized = true;
        for (const char* artifact :
             {"first_wrong", "missed_solver", "missed_logic", "missed_range", "ghost_hit",
              "ghost_surface", "wrong_interface", "ghost_material", "void", "wrong_medium",
              "inconsistent", "wrong_count", "wrong_parity", "order_sensitive"}) {
          EXPECT_EQ(value[std::string(artifact) + "_count"], "0") << artifact;
        }
      }
    }
    EXPECT_GT(rows, 0U);
    EXPECT_TRUE(regularized || spawned || !judges_rays || name == "epsilon-sweep");

    for (const std::string& other :
         {judges_rays ? std::string("paired") : own_tables.at(name)[1], std::string("clock")}) {
      std::istringstream more(lamina("table " + folder + " --format csv --table " + other).out);
      std::getline(more, header);
      const std::size_t columns = fields_of(header).size();
      EXPECT_GT(columns, 3U);
      for (std::string row; std::getline(more, row);) {
        EXPECT_EQ(fields_of(row).size(), columns) << row;
      }
    }
    // Each line of a Markdown table has as many cells as the one before it.
    std::istringstream markdown(run.out);
    std::size_t bars = 0;
    for (std::string row; std::getline(markdown, row);) {
      if (!row.starts_with("|")) {
        bars = 0;
        continue;
      }
      const auto count = static_cast<std::size_t>(std::count(row.begin(), row.end(), '|'));
      EXPECT_TRUE(bars == 0 || bars == count) << row;
      bars = count;
    }
    EXPECT_EQ(lamina("table " + folder + " --table nothing").status, 2);
  }
  EXPECT_GE(experiments, 14U);
}

}  // namespace
}  // namespace lamina::test
