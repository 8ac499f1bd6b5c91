#include <algorithm>
#include <cmath>

#include "conformance/checks/testing/planted_fault.h"

namespace plumb::planted {
namespace {

constexpr std::size_t kOneLeaf = 8;

/// Hits by the right formulas, but searched in a way that makes a mistake where a scene or a mesh has more than one
/// leaf.
class Searched : public FormulaSubject {
 public:
  using FormulaSubject::FormulaSubject;
  void load(const SubjectScene& scene) override {
    FormulaSubject::load(scene);
    parts_ = scene.size() == 1 && scene[0].shape.mesh ? scene[0].shape.mesh->triangles.size() : scene.size();
  }

 protected:
  bool has_leaves() const { return parts_ > kOneLeaf; }

 private:
  std::size_t parts_ = 0;
};

/// Keeps the first hit that it finds.
class KeepsTheFirst : public Searched {
 public:
  using Searched::Searched;
  std::vector<SubjectHit> closest(std::span<const Ray> rays) override {
    std::vector<SubjectHit> answers;
    for (const std::vector<SubjectHit>& hits : all(rays)) {
      const auto first = has_leaves() ? hits.begin() : std::ranges::min_element(hits, {}, &SubjectHit::t);
      answers.push_back(hits.empty() ? SubjectHit{} : *first);
    }
    return answers;
  }
};

/// What lies between two halves goes into neither: every ninth part.
class LosesParts : public Searched {
 public:
  using Searched::Searched;
  std::vector<SubjectHit> closest(std::span<const Ray> rays) override {
    std::vector<SubjectHit> answers;
    for (std::vector<SubjectHit>& hits : all(rays)) {
      if (has_leaves()) std::erase_if(hits, [](const SubjectHit& h) { return (h.surface + h.primitive) % 9 == 8; });
      answers.push_back(hits.empty() ? SubjectHit{} : *std::ranges::min_element(hits, {}, &SubjectHit::t));
    }
    return answers;
  }
};

/// A slab test by which a direction with a zero meets no node.
class MissesByZeros : public Searched {
 public:
  using Searched::Searched;
  std::vector<SubjectHit> closest(std::span<const Ray> rays) override {
    std::vector<SubjectHit> answers = Searched::closest(rays);
    for (std::size_t i = 0; has_leaves() && i < rays.size(); ++i)
      for (int axis = 0; axis < 3; ++axis)
        if (rays[i].direction[axis] == 0) answers[i] = {};
    return answers;
  }
};

/// Shadow rays that go on behind the light.
class AnyWithoutEnd : public Searched {
 public:
  using Searched::Searched;
  std::vector<std::uint8_t> any(std::span<const Ray> rays) override {
    std::vector<Ray> endless(rays.begin(), rays.end());
    for (Ray& ray : endless) ray.t_max = Bounds3::kInfinity;
    return Searched::any(endless);
  }
};

template <class Subject>
std::unique_ptr<plumb::Subject> of_kernel() {
  Formulas formulas = right_formulas();
  formulas.contract.matrices = false;
  return std::make_unique<Subject>(std::move(formulas));
}

}  // namespace

std::vector<Fault> search_faults() {
  return {
      {"hierarchy", "the first hit that is found is kept", Verdict::fail, "traversal", of_kernel<KeepsTheFirst>},
      {"hierarchy", "a split loses what lies between its halves", Verdict::fail, "traversal", of_kernel<LosesParts>},
      {"hierarchy", "a slab test in which zeros make NaN", Verdict::fail, "traversal", of_kernel<MissesByZeros>},
      {"hierarchy", "shadow rays without an end", Verdict::fail, "any_hit", of_kernel<AnyWithoutEnd>},
  };
}

}  // namespace plumb::planted
