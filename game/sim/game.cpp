#include "game/sim/game.h"

#include "engine/effects/has/slow_motion.h"
#include "game/sim/level.h"
#include "game/sim/session.h"
#include "game/sim/track.h"

namespace brittle::sim {

namespace {

/// Raised whenever a snapshot's layout or the meaning of an input changes.
constexpr std::uint32_t kSnapshotVersion = 3;
/// Added to it in snapshots of a game that has power-ups: those stand behind the globals.
constexpr std::uint32_t kWithPowerUps = 0x10000;

}  // namespace

struct Game::Impl {
  Impl(const content::AssetSource& assets, const GameDef& def) : session(assets, def) {
    session.score.balls = clampTo(def.balls, 1, session.ballCap());
    session.score.streak = maxOf(def.streak, 0);
    session.score.free = def.mode == Mode::Zen;
    session.globals["player.mode"] = std::to_string(static_cast<int>(def.mode));
    stage.phase = def.title ? Phase::Title : Phase::Playing;
    stage.checkpoint = stage.reached = {def.firstRoom, session.score.balls, session.score.streak, 0.0f};
  }
  /// Where the game stands; changed only here.
  struct Stage {
    Phase phase = Phase::Playing;
    std::uint32_t ticks = 0;  // since it began
    RestartPoint checkpoint, reached;
    template <class Archive>
    void serialize(Archive& a) {
      a(phase);
      a(ticks);
      checkpoint.serialize(a);
      reached.serialize(a);
    }
  };
  void enter(Phase phase, EventType type);
  void emit(EventType type, PowerUp kind);
  void usePowerUps(std::uint8_t buttons);
  TimeStep passTime();
  void listOmissions(std::vector<NamedCount>& counts) const;
  bool hasPowerUps() const {
    return !session.inventory.isEmpty() || !session.clock.isWhole() || session.explosions > 0;
  }
  void remember();
  void refreshHud();
  RestartPoint pointAt(std::uint32_t room) const;

  Session session;
  std::unique_ptr<Track> track;
  Stage stage;
  Hud hud;
};

void Game::Impl::enter(Phase phase, EventType type) {
  stage.phase = phase;
  stage.ticks = 0;
  session.inventory.stop();
  Event event;
  event.type = type;
  session.events.push_back(event);
}

void Game::Impl::emit(EventType type, PowerUp kind) {
  Event event;
  event.type = type;
  event.value = static_cast<std::int32_t>(kind);
  session.events.push_back(event);
}

void Game::Impl::usePowerUps(std::uint8_t buttons) {
  for (const PowerUp ended : session.inventory.tick()) emit(EventType::PowerUpEnded, ended);
  for (int place = 0; place < replay::kUsePlaces; ++place) {
    if ((buttons & replay::useBit(place)) == 0) continue;
    if (const auto used = session.inventory.use(static_cast<std::size_t>(place))) emit(EventType::PowerUpUsed, *used);
  }
  for (const PowerUpSlot& slot : session.inventory.slots()) track->current().demandFor(slot.kind);
}

/// Whole ticks, but for slow motion and until its time has caught up.
TimeStep Game::Impl::passTime() {
  if constexpr (effects::kHasSlowMotion) {
    const bool isSlow =
        session.inventory.runs(PowerUp::SlowMotion) && track->current().effects().runs(effects::Effect::SlowMotion);
    if (isSlow || !session.clock.isWhole()) return sim::passTime(session.clock, session.tick, isSlow);
  }
  return {};
}

RestartPoint Game::Impl::pointAt(std::uint32_t room) const {
  return {room, session.score.balls, session.score.streak, track->displayedDistance()};
}

/// Checkpoints passed in this tick, and the room reached a few ticks after its door.
void Game::Impl::remember() {
  for (const Event& event : session.events)
    if (event.type == EventType::Checkpoint)
      stage.checkpoint = pointAt(track->roomIndex() + (track->levelDone() ? 1 : 0));
  if (!session.score.free && track->pace().ticks() == rules::kQuickSaveTick)
    stage.reached = pointAt(track->roomIndex());
}

void Game::Impl::refreshHud() {
  const Score& score = session.score;
  hud.phase = stage.phase;
  hud.phaseTicks = stage.ticks;
  hud.countsBalls = !score.free;
  hud.room = static_cast<std::int32_t>(track->roomIndex());
  hud.rooms = static_cast<std::int32_t>(track->roomCount());
  hud.checkpointBalls = stage.checkpoint.balls;
  hud.balls = score.balls;
  hud.streak = score.streak;
  hud.ballsPerThrow = score.ballsPerThrow();
  hud.distance = track->displayedDistance();
  hud.roomProgress = clampTo(track->pace().distance() / track->pace().roomLength(), 0.0f, 1.0f);
  hud.pain = static_cast<float>(score.pain) / static_cast<float>(rules::kPainTicks);
  hud.throwsAreFree = session.inventory.runs(PowerUp::BallFrenzy);
  hud.powerUps.clear();
  for (const PowerUpSlot& slot : session.inventory.slots()) {
    const float left =
        slot.ticksAll > 0 ? static_cast<float>(slot.ticksLeft) / static_cast<float>(slot.ticksAll) : 1.0f;
    hud.powerUps.push_back({slot.kind, slot.count, slot.runs, slot.runs ? left : 0.0f});
  }
}

const char* nameOf(Phase phase) {
  constexpr const char* names[] = {"title", "playing", "checkpoint", "game over"};
  return names[static_cast<int>(phase)];
}

Game::Game(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Game::~Game() = default;

Result<std::unique_ptr<Game>> Game::create(const content::AssetSource& assets, const GameDef& def) {
  auto impl = std::make_unique<Impl>(assets, def);
  Result<std::vector<RoomEntry>> entries = loadLevel(impl->session, def.level);
  if (!entries) return entries.error();
  if (def.firstRoom >= entries->size())
    return Error{"level " + def.level + ": no room " + std::to_string(def.firstRoom) + ", it has " +
                 std::to_string(entries->size())};
  readAhead(impl->session, *entries);
  impl->track = std::make_unique<Track>(impl->session, std::move(*entries), def.firstRoom, def.startOffset);
  impl->refreshHud();
  return std::unique_ptr<Game>(new Game(std::move(impl)));
}

void Game::tick(const replay::InputFrame& input) {
  Session& session = impl_->session;
  session.events.clear();
  Impl::Stage& stage = impl_->stage;
  const bool isPlaying = stage.phase == Phase::Playing;
  ++stage.ticks;
  if (isPlaying) impl_->usePowerUps(input.buttons);
  const TimeStep time = impl_->passTime();
  impl_->track->tick(input, isPlaying, time);
  if (time.isWhole()) session.score.tick(session.inventory.runs(PowerUp::BallFrenzy));
  if (stage.phase == Phase::Title && !input.throws.empty()) impl_->enter(Phase::Playing, EventType::Begin);
  if (isPlaying) {
    impl_->remember();
    if (impl_->track->levelDone()) {
      impl_->enter(Phase::Checkpoint, EventType::LevelDone);
    } else if (session.score.over) {
      impl_->enter(Phase::GameOver, EventType::GameOver);
    }
  }
  ++session.tick;
  impl_->refreshHud();
}

std::uint64_t Game::tickCount() const {
  return impl_->session.tick;
}

std::uint64_t Game::stateHash() const {
  HashArchive archive;
  impl_->session.score.serialize(archive);
  impl_->stage.serialize(archive);
  StateHash hash;
  hash.add(impl_->session.tick);
  hash.add(archive.value());
  for (const auto& [key, value] : impl_->session.globals) {
    hash.addBytes(key.data(), key.size());
    hash.addBytes(value.data(), value.size());
  }
  hash.add(impl_->track->stateHash());
  if (impl_->hasPowerUps()) {
    HashArchive powerUps;
    impl_->session.inventory.serialize(powerUps);
    impl_->session.clock.serialize(powerUps);
    powerUps(impl_->session.explosions);
    hash.add(powerUps.value());
  }
  return hash.value();
}

std::uint64_t Game::roomHash() const {
  return impl_->track->roomHash();
}

void Game::save(ByteWriter& out) const {
  const Session& session = impl_->session;
  out.write(impl_->hasPowerUps() ? kSnapshotVersion + kWithPowerUps : kSnapshotVersion);
  out.writeString(session.def.level);
  out.write(session.def.seed);
  out.write(session.tick);
  SaveArchive archive(out);
  Score score = session.score;
  score.serialize(archive);
  Impl::Stage stage = impl_->stage;
  stage.serialize(archive);
  out.write(static_cast<std::uint32_t>(session.globals.size()));
  for (const auto& [key, value] : session.globals) {
    out.writeString(key);
    out.writeString(value);
  }
  if (impl_->hasPowerUps()) {
    Inventory inventory = session.inventory;
    inventory.serialize(archive);
    Clock clock = session.clock;
    clock.serialize(archive);
    out.write(session.explosions);
  }
  impl_->track->save(out);
}

bool Game::restore(ByteReader& in) {
  Session& session = impl_->session;
  const auto version = in.read<std::uint32_t>();
  const bool hasPowerUps = version == kSnapshotVersion + kWithPowerUps;
  if ((!hasPowerUps && version != kSnapshotVersion) || in.readString() != session.def.level) return false;
  if (in.read<std::uint64_t>() != session.def.seed) return false;
  session.tick = in.read<std::uint64_t>();
  RestoreArchive archive(in);
  session.score.serialize(archive);
  impl_->stage.serialize(archive);
  std::map<std::string, std::string> globals;
  const auto count = in.read<std::uint32_t>();
  for (std::uint32_t i = 0; i < count && in.ok(); ++i) {
    const std::string key = in.readString();
    globals[key] = in.readString();
  }
  session.inventory = {};
  session.clock = {};
  session.explosions = 0;
  if (hasPowerUps) session.inventory.serialize(archive);
  if (hasPowerUps) session.clock.serialize(archive);
  if (hasPowerUps) session.explosions = in.read<std::uint32_t>();
  if (!session.inventory.isValid() || !session.clock.isValid()) return false;
  if (!in.ok() || impl_->stage.phase > Phase::GameOver || !impl_->track->restore(in)) return false;
  session.globals = globals;  // rooms made anew have run their scripts: what those set is in here already
  session.events.clear();
  session.omissions = {};
  session.worldOmissions = {};
  impl_->refreshHud();
  return true;
}

const GameDef& Game::def() const {
  return impl_->session.def;
}
std::uint64_t Game::contentHash() const {
  return impl_->session.files.hash();
}
Camera Game::camera() const {
  return impl_->track->camera();
}
void Game::setAccuracy(const physics::Accuracy& accuracy) {
  impl_->session.def.accuracy = accuracy;
  impl_->track->current().world().setAccuracy(accuracyOf(impl_->session));
  if (Room* next = impl_->track->next()) next->world().setAccuracy(accuracyOf(impl_->session));
}
const physics::Accuracy& Game::accuracy() const {
  return impl_->session.def.accuracy;
}
const Hud& Game::hud() const {
  return impl_->hud;
}
bool Game::isOver() const {
  return impl_->stage.phase == Phase::GameOver || impl_->stage.phase == Phase::Checkpoint;
}
const RestartPoint& Game::checkpoint() const {
  return impl_->stage.checkpoint;
}
const RestartPoint& Game::reached() const {
  return impl_->stage.reached;
}
const std::vector<Event>& Game::events() const {
  return impl_->session.events;
}
const std::vector<Problem>& Game::problems() const {
  return impl_->session.problems;
}
const std::vector<std::string>& Game::soundNames() const {
  return impl_->session.soundNames;
}
std::uint64_t Game::roomNumber() const {
  return impl_->track->current().number();
}
float Game::roomDistance() const {
  return impl_->track->pace().distance();
}
std::int64_t Game::globalOrigin() const {
  return impl_->track->globalOrigin();
}
std::uint32_t Game::totalBreaks() const {
  return impl_->session.score.breaks;
}
std::uint32_t Game::totalCrashes() const {
  return impl_->session.score.crashes;
}
std::uint32_t Game::totalQuarantined() const {
  return impl_->session.score.quarantined;
}
std::uint32_t Game::totalCrystals() const {
  return impl_->session.score.crystals;
}
std::uint32_t Game::totalCleared() const {
  return impl_->session.score.cleared;
}
std::uint32_t Game::totalExplosions() const {
  return impl_->session.explosions;
}
float Game::timeShare() const {
  return static_cast<float>(impl_->session.clock.share) / kWholeTick;
}
float Game::gravity() const {
  return rules::kGravity * impl_->track->current().gravity();
}
std::vector<NamedCount> Game::omissions() const {
  std::vector<NamedCount> counts;
  impl_->listOmissions(counts);
  return counts;
}
void Game::Impl::listOmissions(std::vector<NamedCount>& counts) const {
  Tally<physics::Omission> worlds = session.worldOmissions;
  worlds.add(track->current().world().counters().omissions);
  if (const Room* next = track->next()) worlds.add(next->world().counters().omissions);
  worlds.list(counts);
  session.omissions.list(counts);
}
const effects::EffectSet& Game::effects() const {
  return impl_->track->current().effects();
}

void Game::look(std::vector<Sight>& sights) const {
  impl_->track->look(sights);
}

void Game::copyFrame(FramePacket& packet) const {
  const Session& session = impl_->session;
  const Track& track = *impl_->track;
  packet.tick = session.tick;
  packet.time = static_cast<double>(session.clock.after(session.tick)) / kWholeTick;
  packet.timeShare = static_cast<float>(session.clock.share) / kWholeTick;
  packet.camera = track.camera();
  packet.originZ = -(static_cast<double>(track.globalOrigin()) / 256.0 + static_cast<double>(track.current().shift()));
  packet.fogNear = rules::kFogNear;
  packet.fogFull = rules::kFogFull;
  packet.shake = track.current().shake();
  packet.rooms.resize(track.next() != nullptr ? 2 : 1);
  packet.balls.clear();
  track.current().copyView(packet.rooms[0], packet.balls);
  if (track.next() != nullptr) track.next()->copyView(packet.rooms[1], packet.balls);
  packet.events = session.events;
  packet.soundNames = session.soundNames;
  packet.hud = impl_->hud;
  packet.omissions.clear();
  impl_->listOmissions(packet.omissions);
  packet.maxDebris = session.def.accuracy.maxDebris;
}

geometry::MeshPool* Game::meshes(std::uint32_t slot) {
  Room* room = impl_->track->inSlot(slot);
  return room != nullptr ? &room->world().meshes() : nullptr;
}

const physics::World* Game::world(std::uint32_t slot) const {
  const Room* room = impl_->track->inSlot(slot);
  return room != nullptr ? &room->world() : nullptr;
}

}  // namespace brittle::sim
