// A kernel that does wrong: each of its ways has its verdict, and the next load works.
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <optional>

#include "conformance/sandbox/process_tree.h"
#include "conformance/subject/kernel_subject.h"
#include "conformance/subject/testing/wrong_kernel.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

const fs::path kWrongKernel = PLUMB_TEST_KERNELS "/wrong_kernel.so";

/// A mesh of two triangles.
SubjectScene two_triangles() {
  auto mesh = std::make_shared<TriangleMesh>();
  mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh->triangles = {{0, 1, 2}, {1, 3, 2}};
  SubjectSurface surface;
  surface.shape.kind = ShapeKind::mesh;
  surface.shape.mesh = mesh;
  return {surface};
}

SubjectScene sphere_of(Wrong wrong) {
  SubjectSurface surface;
  surface.shape.kind = ShapeKind::sphere;
  surface.shape.radius = static_cast<double>(wrong);
  return {surface};
}

Ray ray_of(Wrong wrong, double t_min = 0) { return {{0.25, 0.25, 1}, {0, 0, -1}, t_min, static_cast<double>(wrong)}; }

/// Nothing of a process is left after each test.
class KernelFailures : public testing::Test {
 protected:
  KernelFailures() { ::unsetenv("PLUMB_WRONG_KERNEL"); }
  void TearDown() override {
    ::unsetenv("PLUMB_WRONG_KERNEL");
    errno = 0;
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG | __WALL), -1) << "a child is left";
    EXPECT_EQ(errno, ECHILD);
  }

  /// With a library that says this wrong of itself.
  static void expect_refused(const char* wrong, const std::string& part) {
    ::setenv("PLUMB_WRONG_KERNEL", wrong, 1);
    try {
      KernelSubject subject(kWrongKernel);
      FAIL() << wrong << " was accepted";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).find("wrong_kernel.so", 0),
                std::string(error.what()).rfind("wrong_kernel.so"))
          << "the place stands there once: " << error.what();
    }
    EXPECT_THROW(LocalKernelSubject{kWrongKernel}, InputError) << wrong;
  }

  template <class Ask>
  static void expect_failure(Ask ask, Verdict verdict, const std::string& cause, const std::string& part) {
    try {
      ask();
      ADD_FAILURE() << "no failure, expected " << to_string(verdict) << " " << cause;
    } catch (const SubjectFailure& failure) {
      EXPECT_EQ(failure.verdict(), verdict) << failure.what();
      EXPECT_EQ(failure.cause(), cause) << failure.what();
      EXPECT_NE(std::string(failure.what()).find(part), std::string::npos) << failure.what();
    }
  }

  /// That the subject cannot be asked without another load, and answers after one.
  static void expect_recovered(Subject& subject) {
    const std::vector<Ray> right(3, ray_of(Wrong::nothing));
    EXPECT_THROW(subject.closest(right), std::logic_error);
    subject.load(two_triangles());
    const std::vector<SubjectHit> hits = subject.closest(right);
    ASSERT_EQ(hits.size(), 3u);
    EXPECT_EQ(hits[2].surface, 0u);
    EXPECT_EQ(hits[2].t, 1);
  }

  struct Case {
    Wrong wrong;
    Verdict verdict;
    const char* cause;
    const char* part;
  };

  template <class Ask>
  static void expect_each(Subject& subject, std::span<const Case> cases, Ask ask) {
    for (const Case& c : cases) {
      SCOPED_TRACE(static_cast<int>(c.wrong));
      subject.load(two_triangles());
      const std::vector<Ray> rays{ray_of(Wrong::nothing), ray_of(c.wrong), ray_of(Wrong::nothing)};
      expect_failure([&] { ask(rays); }, c.verdict, c.cause, c.part);
      expect_recovered(subject);
    }
  }
};

TEST_F(KernelFailures, AnAnswerThatCannotBeIsAFailureInBothProcesses) {
  const Case cases[] = {
      {Wrong::nan, Verdict::fail, "not_finite", "t of the hit of ray 1"},
      {Wrong::nan_u, Verdict::fail, "not_finite", "u of the hit of ray 1"},
      {Wrong::infinite, Verdict::fail, "not_finite", "inf"},
      {Wrong::bad_surface, Verdict::fail, "protocol", "surface 1000"},
      {Wrong::bad_primitive, Verdict::fail, "protocol", "primitive 12"},
      {Wrong::leaves_all, Verdict::fail, "protocol", "ray 1 was left unwritten"},
      {Wrong::leaves_t, Verdict::fail, "protocol", "t of the hit of ray 1 was left unwritten"},
      {Wrong::leaves_v, Verdict::fail, "protocol", "v of the hit of ray 1 was left unwritten"},
      {Wrong::overrun, Verdict::crash, "overrun", "closest_hit"},
      {Wrong::underrun, Verdict::crash, "overrun", "closest_hit"},
  };
  KernelSubject subject(kWrongKernel);
  expect_each(subject, cases, [&](std::span<const Ray> rays) { subject.closest(rays); });
  LocalKernelSubject local(kWrongKernel);
  expect_each(local, cases, [&](std::span<const Ray> rays) { local.closest(rays); });
}

TEST_F(KernelFailures, AnEndOfTheProcessIsAFailure) {
  const Case cases[] = {
      {Wrong::crash, Verdict::crash, "signal", "signal 11"},
      {Wrong::abort, Verdict::crash, "signal", "signal 6"},
      {Wrong::throws, Verdict::crash, "signal", "signal 6"},
      {Wrong::exits_with_zero, Verdict::fail, "protocol", "without an answer"},
      {Wrong::exits_with_three, Verdict::crash, "exit_status", "status 3"},
      {Wrong::closes_everything, Verdict::fail, "protocol", ""},
      {Wrong::writes_everywhere, Verdict::fail, "protocol", "no message"},
  };
  KernelSubject subject(kWrongKernel);
  expect_each(subject, cases, [&](std::span<const Ray> rays) { subject.closest(rays); });
}

TEST_F(KernelFailures, AHangIsATimeout) {
  KernelOptions options;
  options.seconds = 1.5;  // time for a host with sanitizers to start
  KernelSubject subject(kWrongKernel, options);
  const Case cases[] = {{Wrong::hang, Verdict::timeout, "wall_time", "1.5"}};
  const auto start = std::chrono::steady_clock::now();
  expect_each(subject, cases, [&](std::span<const Ray> rays) { subject.closest(rays); });
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30)) << "nobody waited for it";
}

TEST_F(KernelFailures, TooMuchMemoryIsAMemoryLimit) {
  KernelOptions options;
  options.memory_bytes = 256 << 20;
  KernelSubject subject(kWrongKernel, options);
  const Case cases[] = {{Wrong::takes_memory, Verdict::memory_limit, "memory", "256 MiB"}};
  expect_each(subject, cases, [&](std::span<const Ray> rays) { subject.closest(rays); });
}

TEST_F(KernelFailures, WhetherAnythingIsHitHasToBeZeroOrOne) {
  const Case cases[] = {
      {Wrong::bad_flag, Verdict::fail, "protocol", "ray 1"},
      {Wrong::leaves_all, Verdict::fail, "protocol", "unwritten"},
      {Wrong::overrun, Verdict::crash, "overrun", "any_hit"},
  };
  KernelSubject subject(kWrongKernel);
  expect_each(subject, cases, [&](std::span<const Ray> rays) { subject.any(rays); });
}

TEST_F(KernelFailures, AllHitsHaveToBeAsManyAsTheirCount) {
  const Case cases[] = {
      {Wrong::counts_too_many, Verdict::fail, "protocol", "more hits than there can be"},
      {Wrong::counts_differently, Verdict::fail, "protocol", "differently"},
      {Wrong::leaves_all, Verdict::fail, "protocol", "unwritten"},
      {Wrong::overrun, Verdict::crash, "overrun", "all_hits"},
  };
  KernelSubject subject(kWrongKernel);
  expect_each(subject, cases, [&](std::span<const Ray> rays) { subject.all(rays); });
  subject.load(two_triangles());
  const std::vector<Ray> rays{ray_of(Wrong::nothing, 0), ray_of(Wrong::nothing, 3), ray_of(Wrong::nothing, 16),
                              ray_of(Wrong::nothing, 17), ray_of(Wrong::nothing, 5000)};
  const auto lists = subject.all(rays);
  ASSERT_EQ(lists.size(), rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) EXPECT_EQ(lists[i].size(), rays[i].t_min) << "as many as it was asked";
}

TEST_F(KernelFailures, ASceneMayBeRefused) {
  KernelSubject subject(kWrongKernel);
  expect_failure([&] { subject.load(sphere_of(Wrong::refuses)); }, Verdict::fail, "error", "no reason");
  expect_recovered(subject);
  expect_failure([&] { subject.load(sphere_of(Wrong::refuses_with_a_reason)); }, Verdict::fail, "error",
                 "this sphere is too round");
  expect_recovered(subject);
  expect_failure([&] { subject.load(sphere_of(Wrong::crash)); }, Verdict::crash, "signal", "11");
  expect_recovered(subject);
}

TEST_F(KernelFailures, AmongManySmallScenesOneFails) {
  KernelSubject subject(kWrongKernel);
  std::vector<Subject::Small> questions(10, {two_triangles(), {ray_of(Wrong::nothing)}});
  EXPECT_EQ(subject.closest_each(questions).size(), 10u);
  questions[7].rays[0] = ray_of(Wrong::crash);
  expect_failure([&] { subject.closest_each(questions); }, Verdict::crash, "signal", "11");
  expect_recovered(subject);
  questions[7].scene = sphere_of(Wrong::refuses);
  expect_failure([&] { subject.closest_each(questions); }, Verdict::fail, "error", "");
  expect_recovered(subject);
}

TEST_F(KernelFailures, WhatItPrintsIsALogOfBoundedSize) {
  KernelOptions options;
  options.log_bytes = 10000;
  KernelSubject subject(kWrongKernel, options);
  subject.load(two_triangles());
  const std::vector<Ray> rays{ray_of(Wrong::prints)};
  EXPECT_TRUE(subject.closest(rays).at(0).hit()) << "a chatty kernel is judged like a silent one";
  const std::string log = subject.log();
  EXPECT_TRUE(log.starts_with("line 0 of what nobody asked for")) << log.substr(0, 100);
  EXPECT_NE(log.find("bytes dropped"), std::string::npos);
  EXPECT_NE(log.find("line 99999 of"), std::string::npos);
  EXPECT_NE(log.find("and without an end of line"), std::string::npos);
  EXPECT_LT(log.size(), 10100u);
}

TEST_F(KernelFailures, WhatCannotBeLoadedIsTheUsersError) {
  EXPECT_THROW(KernelSubject("/nowhere/kernel.so"), InputError);
  try {
    KernelSubject subject(PLUMB_TEST_KERNELS "/no_kernel.so");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no_kernel.so: the library has no function plumb_kernel_v1"),
              std::string::npos)
        << error.what();
  }
  const fs::path text = fs::path(testing::TempDir()) / ("plumb-kernel-" + std::to_string(::getpid()) + ".so");
  std::ofstream(text) << "not a library";
  EXPECT_THROW(KernelSubject{text}, InputError);
  fs::remove(text);
}

TEST_F(KernelFailures, ATableThatCannotBeIsTheUsersError) {
  expect_refused("null", "null");
  expect_refused("version", "version 2, expected 1");
  expect_refused("size", "8 bytes");
  expect_refused("function", "is null");
  expect_refused("capability", "capability whose function is null");
  expect_refused("name", "name");
  expect_refused("no name", "name");
  expect_refused("description", "one line");
  expect_refused("precision", "precision is 7");
  expect_refused("edges", "edge_rule is 0");
  expect_refused("shapes", "shapes is 1024");
  expect_refused("largest", "largest is nan");
}

TEST_F(KernelFailures, ALibraryThatFailsWhereItIsLoadedIsAFailure) {
  ::setenv("PLUMB_WRONG_KERNEL", "crash", 1);
  expect_failure([] { KernelSubject subject(kWrongKernel); }, Verdict::crash, "signal", "11");
  ::setenv("PLUMB_WRONG_KERNEL", "hang", 1);
  KernelOptions options;
  options.seconds = 0.5;
  expect_failure([&] { KernelSubject subject(kWrongKernel, options); }, Verdict::timeout, "wall_time", "0.5");
}

TEST_F(KernelFailures, ALibraryThatIsExchangedMeanwhileIsNoticed) {
  KernelSubject subject(kWrongKernel);
  subject.load(two_triangles());
  EXPECT_THROW(subject.closest(std::vector<Ray>{ray_of(Wrong::crash)}), SubjectFailure);
  ::setenv("PLUMB_WRONG_KERNEL", "another name", 1);
  expect_failure([&] { subject.load(two_triangles()); }, Verdict::fail, "protocol", "something else");
}

TEST_F(KernelFailures, WhatTheContractExcludesIsNotAsked) {
  KernelSubject subject(kWrongKernel);
  SubjectScene scene = two_triangles();
  scene[0].shape.kind = ShapeKind::box;
  EXPECT_THROW(subject.load(scene), UnsupportedBySubject);
  scene = two_triangles();
  scene[0].world_from_object = scaling({2, 1, 1});
  EXPECT_THROW(subject.load(scene), UnsupportedBySubject);
  EXPECT_THROW(subject.matrices(), UnsupportedBySubject);

  ::setenv("PLUMB_WRONG_KERNEL", "float", 1);
  KernelSubject single(kWrongKernel);
  EXPECT_EQ(single.contract().precision, PLUMB_FLOAT);
  single.load(two_triangles());
  EXPECT_THROW(single.closest(std::vector<Ray>{{{0.1, 0, 0}, {0, 0, 1}}}), std::invalid_argument) << "0.1 is no float";
  EXPECT_NO_THROW(single.closest(std::vector<Ray>{{{0.125, 0, 0}, {0, 0, 1}}}));

  ::setenv("PLUMB_WRONG_KERNEL", "small", 1);
  KernelSubject small(kWrongKernel);
  small.load(two_triangles());
  EXPECT_THROW(small.closest(std::vector<Ray>{{{101, 0, 0}, {0, 0, 1}}}), UnsupportedBySubject);
  EXPECT_THROW(small.load(sphere_of(Wrong::crash)), UnsupportedBySubject) << "its radius is 101";
}

TEST_F(KernelFailures, TheHostEndsWithWhoAskedIt) {
  std::array<int, 2> ready;
  ASSERT_EQ(::pipe(ready.data()), 0);
  const pid_t asker = ::fork();
  if (asker == 0) {
    KernelSubject subject(kWrongKernel);
    [[maybe_unused]] const ssize_t written = ::write(ready[1], "!", 1);
    ::sleep(100);
    ::_exit(0);
  }
  ::close(ready[1]);
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  ::close(ready[0]);
  const std::string number = std::to_string(asker);
  pid_t host = 0;
  std::ifstream("/proc/" + number + "/task/" + number + "/children") >> host;
  ASSERT_GT(host, 0);
  const auto is_there = [&] {
    const std::optional<ProcessStat> process = read_process_stat(host);
    return process && process->state != 'Z';
  };
  EXPECT_TRUE(is_there());
  ::kill(asker, SIGKILL);
  ASSERT_EQ(::waitpid(asker, nullptr, 0), asker);
  for (int i = 0; i < 10000 && is_there(); ++i) ::usleep(1000);
  EXPECT_FALSE(is_there());
}

TEST_F(KernelFailures, AHostThatIsNotThereIsNoFaultOfTheKernel) {
  KernelOptions options;
  options.host = "/nowhere/plumb-kernel-host";
  EXPECT_THROW(KernelSubject(kWrongKernel, options), std::runtime_error);
}

}  // namespace
}  // namespace plumb
