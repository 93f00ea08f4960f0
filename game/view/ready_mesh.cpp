#include "game/view/ready_mesh.h"

#include <algorithm>
#include <array>

#include "engine/math/aabb.h"

namespace brittle::view {
namespace {

constexpr float kNear = 0.002f;             // between a triangle and the face it lies on [m]
constexpr std::ptrdiff_t kMostTried = 256;  // faces in one plane: whoever piles up more is drawn without polish

struct Face {
  float plane;  // where it lies along its axis [m]
  float sign;   // where it looks along it
  const sim::LookBox* box;
};

Aabb boundsOf(const sim::LookBox& box) {
  return {box.center - box.halfExtents, box.center + box.halfExtents};
}

/// The faces of a look's boxes, to find the one that a triangle lies on.
class Faces {
 public:
  explicit Faces(const sim::SegmentLook& look) {
    for (const sim::LookBox& box : look.boxes)
      for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {-1.0f, 1.0f})
          faces_[static_cast<std::size_t>(axis)].push_back(
              {box.center[axis] + sign * box.halfExtents[axis], sign, &box});
    for (std::vector<Face>& along : faces_)
      std::stable_sort(along.begin(), along.end(), [](const Face& a, const Face& b) { return a.plane < b.plane; });
  }

  /// Null if there is none. `axis`: along which the triangle is flat.
  const Face* under(const Aabb& triangle, int axis) const {
    const std::vector<Face>& along = faces_[static_cast<std::size_t>(axis)];
    auto at = std::lower_bound(along.begin(), along.end(), triangle.low[axis] - kNear,
                               [](const Face& face, float plane) { return face.plane < plane; });
    const auto end = along.end() - at > kMostTried ? at + kMostTried : along.end();
    for (; at != end && at->plane <= triangle.low[axis] + kNear; ++at)
      if (boundsOf(*at->box).grownBy(kNear).contains(triangle)) return &*at;
    return nullptr;
  }

 private:
  std::array<std::vector<Face>, 3> faces_;
};

/// Triangle by triangle of a mesh that is carried.
class Fitting {
 public:
  Fitting(const content::BakedMesh& carried, const sim::SegmentLook& look) : carried_(carried), faces_(look) {
    for (std::size_t i = 0; i < carried.indices.size(); i += 3) add(i);
  }
  render::BakedMesh take() {
    render::BakedMesh mesh;
    for (const content::BakedVertex& vertex : carried_.vertices)
      mesh.vertices.push_back({vertex.point, vertex.u, vertex.v, vertex.color});
    mesh.polished = static_cast<std::uint32_t>(polished_.size());
    mesh.indices = std::move(plain_);
    mesh.indices.insert(mesh.indices.end(), polished_.begin(), polished_.end());
    if (inwards_ > outwards_)
      for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    return mesh;
  }

 private:
  void add(std::size_t first) {
    const Vec3 corners[] = {corner(first), corner(first + 1), corner(first + 2)};
    Aabb bounds;
    for (const Vec3& at : corners) bounds.include(at);
    int axis = 0;
    (bounds.high - bounds.low).minCoeff(&axis);
    const Face* face = bounds.high[axis] - bounds.low[axis] <= kNear ? faces_.under(bounds, axis) : nullptr;
    std::vector<std::uint32_t>& indices = face != nullptr && face->box->reflects ? polished_ : plain_;
    for (std::size_t i = first; i < first + 3; ++i) indices.push_back(carried_.indices[i]);
    if (face == nullptr) return;
    const float outwards = (corners[1] - corners[0]).cross(corners[2] - corners[0])[axis] * face->sign;
    ++(outwards > 0.0f ? outwards_ : inwards_);
  }
  const Vec3& corner(std::size_t i) const { return carried_.vertices[carried_.indices[i]].point; }

  const content::BakedMesh& carried_;
  Faces faces_;
  std::vector<std::uint32_t> plain_, polished_;
  std::size_t outwards_ = 0, inwards_ = 0;  // triangles wound so
};

}  // namespace

render::BakedMesh readyMesh(const content::BakedMesh& carried, const sim::SegmentLook& look) {
  return Fitting(carried, look).take();
}

void append(const render::BakedMesh& more, render::BakedMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
  std::vector<std::uint32_t> indices;
  for (const std::uint32_t index : more.indices) indices.push_back(index + first);
  const auto polished = indices.end() - static_cast<std::ptrdiff_t>(more.polished);
  mesh.indices.insert(mesh.indices.end() - static_cast<std::ptrdiff_t>(mesh.polished), indices.begin(), polished);
  mesh.indices.insert(mesh.indices.end(), polished, indices.end());
  mesh.polished += more.polished;
}

}  // namespace brittle::view
