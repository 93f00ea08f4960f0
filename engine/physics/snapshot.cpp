// Saving, restoring and hashing a world, all three by one description, so that they cannot cover different things. The
// hash takes the hash of each mesh in place of its vertices and leaves out the buffers they lie in.
#include "engine/physics/edit.h"
#include "engine/physics/state_error.h"
#include "engine/physics/world.h"

namespace brittle::physics {
namespace {

constexpr std::uint32_t kSnapshotVersion = 2;

template <class Archive>
void archiveState(State& state, Archive& archive) {
  archive(state.bodies);
  archive(state.shapes);
  archive(state.contacts);
  archive(state.joints);
  archive(state.drives);
  archive(state.tree);
  archive(state.debris);
  archive.vector(state.budgets);
  archive.vector(state.held);
  archive.vector(state.newShapes);
  archive(state.accuracy);
  archive(state.gravity);
  archive(state.seed);
  archive(state.tick);
  archive(state.nextAssembly);
  archive(state.nextSerial);
}

}  // namespace

std::uint64_t World::stateHash() const {
  HashArchive hash;
  archiveState(*state_, hash);
  return hash.value();
}

void World::save(ByteWriter& out) const {
  out.write(kSnapshotVersion);
  SaveArchive archive(out);
  archiveState(*state_, archive);
  state_->meshes.save(out);
}

bool World::restore(ByteReader& in) {
  if (in.read<std::uint32_t>() != kSnapshotVersion) return false;
  auto restored = std::make_unique<State>();
  RestoreArchive archive(in);
  archiveState(*restored, archive);
  if (!restored->meshes.restore(in) || !archive.ok() || findError(*restored) != nullptr) return false;
  restored->shapeBoxes.resize(restored->shapes.capacity());
  restored->bodies.forEach([&](BodyHandle, Body& body) { refreshInertia(body); });
  restored->meshes.markAllDirty();
  state_ = std::move(restored);
  return true;
}

}  // namespace brittle::physics
