#include "game/sim/track.h"

#include <algorithm>

namespace brittle::sim {
namespace {

constexpr std::int64_t kFarthest = std::int64_t{1} << 48;  // a snapshot's origin may lie here [2^-8 m]

}  // namespace

Track::Track(Session& session, std::vector<RoomEntry> entries, std::uint32_t firstRoom, std::int64_t startOffset)
    : session_(session), entries_(std::move(entries)), firstRoom_(firstRoom), origin_(startOffset) {
  next_ = makeRoom(0);
  pace_.startBefore(next_->settings().length);
  // As if an empty room of the same length came before: so the first room is entered in the state every later one is.
  origin_ -= pace_.lengthUnits();
  tickRooms();
  while (!pace_.atDoor()) {
    pace_.tick();
    tickRooms();
  }
  enterNext();
  session_.events.clear();
}

std::unique_ptr<Room> Track::makeRoom(std::uint64_t number) {
  const std::uint64_t index = number + firstRoom_;
  if (index >= entries_.size()) return nullptr;
  return std::make_unique<Room>(session_, entries_[index], number, static_cast<std::uint32_t>(number & 1));
}

void Track::tick(const replay::InputFrame& input, bool isMoving, const TimeStep& time) {
  isMoving_ = isMoving;
  if (isMoving) pace_.tick(time);
  makeNext();
  if (isMoving) throwBalls(input);
  tickRooms(time);
  moveBalls();
  if (!isMoving) return;
  current_->crashTest();
  if (pace_.atDoor()) passDoor();
}

void Track::passDoor() {
  Event event;
  event.point = Vec3(0.0f, rules::kCameraHeight, current_->shift() - pace_.distance());
  event.type = EventType::Checkpoint;
  event.value = session_.score.balls;
  if (current_->entry().endsAtCheckpoint) session_.events.push_back(event);
  if (next_) return enterNext();
  done_ = true;
}

void Track::makeNext() {
  if (!next_ && pace_.nextRoomDue()) next_ = makeRoom(number_ + 1);
}

void Track::throwBalls(const replay::InputFrame& input) {
  std::size_t place = 0;
  for (const replay::Throw& aim : input.throws) {
    if (place++ == replay::kMaxThrows) {
      session_.omissions.add(Omission::RefusedThrow, input.throws.size() - replay::kMaxThrows);
      return;
    }
    if (!session_.score.spendThrow(session_.inventory.runs(PowerUp::BallFrenzy))) return;
    throwBall(aim);
  }
}

/// A barrel goes with the first throw after it was used.
void Track::throwBall(const replay::Throw& aim) {
  Inventory& inventory = session_.inventory;
  const bool hasBarrel = inventory.runs(PowerUp::Barrel);
  const Charge otherwise = inventory.runs(PowerUp::NitroBalls) ? Charge::Nitro : Charge::None;
  current_->throwBalls(camera(), aim, session_.score.ballsPerThrow(), hasBarrel ? Charge::Barrel : otherwise);
  if (hasBarrel) inventory.finish(PowerUp::Barrel);
}

void Track::tickRooms(const TimeStep& time) {
  const float speed = isMoving_ ? pace_.speed() : 0.0f;
  if (current_) current_->tick(pace_.distance(), speed, pace_.ticks(), time, pace_.tickPart());
  if (!next_) return;
  const float shift = current_ ? current_->shift() : 0.0f;
  next_->setFrameOffset(Vec3(0.0f, 0.0f, shift - pace_.roomLength()));
  next_->tick(pace_.distance() - pace_.roomLength(), speed, pace_.ticks() - rules::kRoomTicks, time, pace_.tickPart());
}

void Track::moveBalls() {
  if (!next_) return;
  for (const BallStart& ball : current_->takeLeavingBalls()) next_->addBall(ball);
}

void Track::enterNext() {
  const Vec3 moved(0.0f, 0.0f, pace_.roomLength() - (current_ ? current_->shift() : 0.0f));
  for (Event& event : session_.events) event.point += moved;  // into the frame that is now shown
  origin_ += pace_.lengthUnits();
  if (current_) {
    ++number_;
    session_.worldOmissions.add(current_->world().counters().omissions);
  }
  current_ = std::move(next_);
  current_->setFrameOffset(Vec3::Zero());
  pace_.enterRoom(current_->settings().length);
  Event event;
  event.type = EventType::RoomEntered;
  event.point = Vec3(0.0f, rules::kCameraHeight, 0.0f);
  event.value = static_cast<std::int32_t>(number_);
  session_.events.push_back(event);
}

Camera Track::camera() const {
  Camera camera;
  camera.position = Vec3(0.0f, rules::kCameraHeight, current_->shift() - pace_.distance());
  camera.velocity = Vec3(0.0f, 0.0f, isMoving_ && !done_ ? -pace_.speed() : 0.0f);
  camera.halfWidthTangent = rules::kHalfWidthTangent;
  camera.near = rules::kNear;
  camera.far = rules::kFar;
  const RoomSettings& settings = current_->settings();
  if (current_->runs(effects::Effect::CameraRoll)) {
    const float progress = pace_.distance() / pace_.roomLength();
    const float angle = 2.0f * kPi * settings.turns * progress;
    camera.rotation =
        rotationAbout(Vec3::UnitZ(), settings.turnAngle != 0.0f ? settings.turnAngle * sine(angle) : angle);
  }
  return camera;
}

float Track::displayedDistance() const {
  float distance = session_.def.distance;
  for (std::uint64_t i = 0; i < roomIndex() && i < entries_.size(); ++i) distance += entries_[i].displayLength;
  return distance + current_->entry().displayLength * minOf(1.0f, pace_.distance() / pace_.roomLength());
}

void Track::look(std::vector<Sight>& sights) const {
  sights.clear();
  current_->look(sights);
  const std::size_t ofNext = sights.size();
  if (next_) next_->look(sights);
  for (std::size_t i = ofNext; i < sights.size(); ++i)
    sights[i].clear = sights[i].clear && current_->isInSight(sights[i].position, 0);
  std::stable_sort(sights.begin(), sights.end(),
                   [](const Sight& a, const Sight& b) { return a.position.z() < b.position.z(); });
}

std::uint64_t Track::roomHash() const {
  HashArchive hash;
  Pace pace = pace_;
  pace.serialize(hash);
  const std::uint64_t parts[2] = {hash.value(), current_->stateHash()};
  return hashBytes(parts, sizeof(parts));
}

std::uint64_t Track::stateHash() const {
  const std::uint64_t flags = (done_ ? 1u : 0u) | (isMoving_ ? 2u : 0u);
  const std::uint64_t parts[4] = {roomHash(), next_ ? next_->stateHash() : 0, number_, flags};
  return hashBytes(parts, sizeof(parts));
}

void Track::save(ByteWriter& out) const {
  SaveArchive archive(out);
  Pace pace = pace_;
  pace.serialize(archive);
  out.write(origin_);
  out.write(number_);
  out.write(done_);
  out.write(isMoving_);
  out.write(next_ != nullptr);
  current_->save(out);
  if (next_) next_->save(out);
}

std::unique_ptr<Room> Track::restoreRoom(ByteReader& in, std::uint64_t number) {
  session_.globals.clear();
  const auto count = in.read<std::uint32_t>();
  for (std::uint32_t i = 0; i < count && in.ok(); ++i) {
    const std::string key = in.readString();
    session_.globals[key] = in.readString();
  }
  std::unique_ptr<Room> room = in.ok() ? makeRoom(number) : nullptr;
  if (room && !room->restore(in)) room.reset();
  return room;
}

bool Track::restore(ByteReader& in) {
  RestoreArchive archive(in);
  pace_.serialize(archive);
  origin_ = in.read<std::int64_t>();
  number_ = in.read<std::uint64_t>();
  done_ = in.read<bool>();
  isMoving_ = in.read<bool>();
  const bool hasNext = in.read<bool>();
  if (!in.ok() || !pace_.isValid() || origin_ < -kFarthest || origin_ > kFarthest) return false;
  std::unique_ptr<Room> current = restoreRoom(in, number_);
  if (!current) return false;
  current_ = std::move(current);
  next_ = hasNext ? restoreRoom(in, number_ + 1) : nullptr;
  if (next_) next_->setFrameOffset(Vec3(0.0f, 0.0f, current_->shift() - pace_.roomLength()));
  return !hasNext || next_ != nullptr;
}

}  // namespace brittle::sim
