#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "conformance/subject/probe_command.h"
#include "conformance/subject/subject.h"

namespace plumb {

class ProbeLine;
struct ProbePlace;
struct ProbeQuestion;

/// A program that answers the probe protocol (docs/probe-protocol.md). It is not trusted and *not isolated*: see
/// Session, which also says that no other program may be run meanwhile. A failure ends it; the next question but one
/// about the scene, or the next load, starts it afresh.
class ProbeSubject : public Subject {
 public:
  /// Starts the program and reads its greeting. Throws SubjectFailure where that fails.
  explicit ProbeSubject(ProbeCommand command);
  ~ProbeSubject() override;
  ProbeSubject(const ProbeSubject&) = delete;
  ProbeSubject& operator=(const ProbeSubject&) = delete;

  const std::string& name() const override { return name_; }
  std::string description() const override;
  const Contract& contract() const override { return contract_; }

  double pace() const override { return 0.05; }
  void rest() override;
  /// Writes the scene as a file for the program, and matches the program's list of surfaces with it. Throws
  /// UnsupportedBySubject also for shapes that the contract leaves out and for a matrix without groups.
  void load(const SubjectScene& scene) override;
  /// A scene file of the caller's, for `trace` alone.
  void load_file(const std::filesystem::path& scene);

  std::vector<SubjectHit> closest(std::span<const Ray> rays) override;
  std::vector<std::uint8_t> any(std::span<const Ray> rays) override;
  std::vector<std::vector<SubjectHit>> all(std::span<const Ray> rays) override;
  std::vector<Bounds3> bounds() override;
  std::vector<SubjectMatrices> matrices() override;
  std::vector<Point3> average_positions() override;
  double fresnel(double cosine, double from, double to) override;
  std::optional<Vec3> refract(const Vec3& direction, const Vec3& normal, double from, double to) override;
  std::array<Vec3, 3> frame(const Vec3& direction) override;

  /// Linear colours of pixels of the loaded file's picture, each x, y from the top left.
  std::vector<Color> trace(std::span<const std::array<int, 2>> pixels);
  bool can_trace() const { return can_trace_; }

  /// What the program printed before its last failure: the beginning and the end.
  const std::string& failure_log() const { return failure_log_; }

 private:
  template <class Act>
  auto guarded(Act act);
  void start();
  void require(bool ability, const char* what) const;
  void require_scene() const;
  template <class Item, class Write, class Read>
  void ask_each(ProbeQuestion question, std::span<const Item> items, std::size_t chunk, Write write, Read read);
  template <class Value, class Read, class Combine>
  std::vector<Value> ask_places(const char* word, Read read, Combine combine);

  ProbeCommand command_;
  std::string name_;
  Contract contract_;
  bool can_trace_ = false;
  std::unique_ptr<ProbeLine> line_;
  std::filesystem::path folder_;  // Of the scene that is loaded; empty if there is none.
  std::size_t surface_count_ = 0;
  std::vector<ProbePlace> places_;
  bool loaded_ = false;
  std::string failure_log_;
};

}  // namespace plumb
