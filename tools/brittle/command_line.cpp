// The command line: which subcommands there are, their options, help with examples. What they do is in a file each.
#include <algorithm>
#include <functional>

#include "engine/effects/effect.h"
#include "engine/replay/replay.h"
#include "tools/brittle/arguments.h"

namespace brittle::program {
namespace {

/// What was asked for, run after the whole line was understood.
using Action = std::function<int()>;

/// What is wrong with a number from 0 to 2^64 - 1, or nothing: the library itself takes -1 for the largest.
std::string wholeNumber(const std::string& text) {
  std::uint64_t number = 0;
  return readWhole(text, number) ? "" : text + ": expected a whole number from 0 to 18446744073709551615";
}

/// What is wrong with a text that was given and is empty: nobody means that, a script's variable was.
std::string someText(const std::string& text) {
  return text.empty() ? "expected a text, got an empty one" : "";
}

/// Of every option of a command that takes a text.
void refuseEmptyTexts(CLI::App& command) {
  for (CLI::Option* option : command.get_options([](const CLI::Option* one) { return one->get_items_expected() > 0; }))
    option->check(CLI::Validator(someText, ""));
}

void addAssets(CLI::App& command, std::string& assets) {
  command
      .add_option("--assets", assets,
                  "folder of levels, rooms and segments (default: the one that came with the program)")
      ->type_name("DIR");
}

void addAccuracy(CLI::App& command, std::string& accuracy, const std::string& otherwise) {
  command
      .add_option("--accuracy", accuracy,
                  "phone, balanced, accurate or reference: what tools/accuracy found best for its time (default: " +
                      otherwise + ")")
      ->type_name("PRESET");
}

void addWithout(CLI::App& command, std::string& without) {
  std::string names;
  for (std::size_t i = 0; i < effects::kEffects; ++i)
    names += (i == 0 ? "" : ", ") + std::string(effects::nameOf(static_cast<effects::Effect>(i)));
  command.add_option("--without", without, "effects to switch off, separated by commas: of " + names)
      ->type_name("EFFECTS");
}

void addGame(CLI::App& command, GameOptions& game) {
  command.add_option("LEVEL", game.level, "name of the level: levels/LEVEL.xml in the assets")->capture_default_str();
  command.add_option("--seed", game.seed, "the same seed gives the same game")
      ->capture_default_str()
      ->type_name("N")
      ->check(CLI::Validator(wholeNumber, ""));
  command.add_option("--mode", game.mode, "training, classic, mayhem or zen")->capture_default_str();
  command.add_option("--room", game.room, "start at this room of the level, from 0")
      ->capture_default_str()
      ->type_name("N");
  addAccuracy(command, game.accuracy, "balanced; a replay records it");
  addWithout(command, game.without);
  addAssets(command, game.assets);
}

void addPlay(CLI::App& app, Action& action) {
  auto options = std::make_shared<PlayOptions>();
  CLI::App* command = app.add_subcommand("play", "play a level in a window");
  addGame(*command, options->game);
  command->add_option("--record", options->record, "write the game as a replay; of several in a row the last")
      ->type_name("FILE");
  command->add_option("--frames", options->frames, "end after so many frames (default: when the window is closed)")
      ->type_name("N");
  command->add_option("--size", options->size, "size of the window [pixels]")->capture_default_str()->type_name("WxH");
  command->add_flag("--mute", options->mute, "without sound");
  command->footer(
      "Touch or click: throw. P: pause. R: restart. F3: frame time, effects, what is left out. F4: settings of "
      "accuracy. Escape: leave.\n\n"
      "Examples:\n  brittle play\n  brittle play first --seed 7 --record game.brt\n  brittle play --accuracy phone");
  command->callback([options, &action] { action = [options] { return play(*options); }; });
}

void addRender(CLI::App& app, Action& action) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command =
      app.add_subcommand("render", "render a replay to pictures, sound or a video, without a display or device");
  command->add_option("REPLAY", options->replay, "a recorded game (.brt)")->required();
  command
      ->add_option("--out", options->out,
                   "folder for frame_000600.png and so on, made if it is missing; or FILE.mp4 for a video with sound")
      ->type_name("DIR");
  command->add_option("--sound", options->sound, "the frames' sound as a WAV file")->type_name("FILE");
  command->add_option("--size", options->size, "size of the pictures [pixels]")
      ->capture_default_str()
      ->type_name("WxH");
  command->add_option("--frames", options->frames, "first and last frame, one per tick of 1/60 s (default: all)")
      ->type_name("A..B");
  command->add_option("--every", options->every, "only every Nth frame")
      ->capture_default_str()
      ->type_name("N")
      ->check(CLI::Range(1u, 1000000u));
  command->add_option("--backend", options->backend, "egl, osmesa, or null: every step but the drawing, without a GPU")
      ->capture_default_str();
  command->add_option("--samples", options->samples, "multisampling: 0 or 4")
      ->capture_default_str()
      ->check(CLI::IsMember({0, 4}));
  addAccuracy(*command, options->accuracy, "what was recorded; another one plays the same throws");
  addWithout(*command, options->without);
  addAssets(*command, options->assets);
  command->footer(
      "Examples:\n  brittle render game.brt --out frames --size 1280x720 --frames 600..900\n"
      "  brittle render game.brt --out frames --every 60 --backend osmesa\n"
      "  brittle render game.brt --out game.mp4 --size 1280x720\n"
      "  brittle render game.brt --sound game.wav");
  command->callback([options, &action] { action = [options] { return render(*options); }; });
}

void addVerify(CLI::App& app, Action& action) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command = app.add_subcommand(
      "verify", "replay recorded games and compare every tick's state, then again from each snapshot");
  command->add_option("REPLAY", options->replays, "recorded games (.brt)")->required();
  command->add_option("--ticks", options->ticks, "only the first N ticks (default: all)")
      ->type_name("N")
      ->check(CLI::Range(1u, replay::kMaxTicks));
  addAssets(*command, options->assets);
  command->footer(
      "Examples:\n  brittle verify game.brt\n  brittle verify replays/*.brt\n  brittle verify game.brt --ticks 600");
  command->callback([options, &action] { action = [options] { return verify(*options); }; });
}

void addSmoke(CLI::App& app, Action& action) {
  auto options = std::make_shared<SmokeOptions>();
  CLI::App* command = app.add_subcommand("smoke", "play scripted games and check what they expect");
  command->add_option("SCRIPT", options->scripts, "Lua scripts")->required();
  command->add_option("--record", options->record, "write the game of a single script as a replay")->type_name("FILE");
  command->add_option("--seeds", options->seeds, "play each script with the seeds 1 to N, and say how its games ended")
      ->type_name("N")
      ->check(CLI::Range(1u, 10000u));
  command->add_option("--set", options->settings, "what setting(\"NAME\", ...) answers in the script")
      ->type_name("NAME=TEXT");
  addAccuracy(*command, options->accuracy, "balanced; a replay records it");
  addWithout(*command, options->without);
  addAssets(*command, options->assets);
  command->footer(
      "A script throws at ticks and says what must come of it:\n"
      "  level(\"first\") seed(7)\n  throw{tick=120, x=0.0, y=0.1}\n  run(300)\n  expect_broken(1)\n\n"
      "Examples:\n  brittle smoke tests/smoke/*.lua\n  brittle smoke tour.lua --record tour.brt\n"
      "  brittle smoke assets/player.lua --set skill=average --seeds 20");
  command->callback([options, &action] { action = [options] { return smoke(*options); }; });
}

void addCheck(CLI::App& app, Action& action) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand(
      "check", "read levels, rooms and segments and name every fault as file:line; try the rooms of a folder's levels");
  command->add_option("PATH", options->paths, "files or folders")->required();
  command->footer(
      "Of a folder with levels/ every room is made as the game makes it, in each mode: what its script and its "
      "obstacles' "
      "scripts do wrong is named too. Of a folder without, or of files, only the files are read.\n\n"
      "Examples:\n  brittle check assets\n  brittle check my_level/segments/wall.xml");
  command->callback([options, &action] { action = [options] { return check(*options); }; });
}

void addExplain(CLI::App& app, Action& action) {
  auto options = std::make_shared<ExplainOptions>();
  CLI::App* command = app.add_subcommand(
      "explain", "which effects each room of a level calls for, who asked, what they cost, and what was left out");
  addGame(*command, options->game);
  command->add_option("--rooms", options->rooms, "how many rooms to pass through")
      ->capture_default_str()
      ->type_name("N")
      ->check(CLI::Range(1u, 1000u));
  command->add_flag("--json", options->json, "a list of rooms instead of a table");
  command->footer(
      "Each effect's price is measured against the same room with it switched off. '< 0.03': it cannot be told from "
      "nothing, with a noise of 0.03; --json has the measured number and its noise.\n\n"
      "Examples:\n  brittle explain first\n  brittle explain first --rooms 1 --json");
  command->callback([options, &action] { action = [options] { return explain(*options); }; });
}

}  // namespace

int run(int argc, char** argv) {
  CLI::App app("Brittle: throw balls at glass.", "brittle");
  app.require_subcommand(1);
  app.footer(
      "Each command has its own --help with examples.\nExit status: 0 done, 1 the answer is no, 2 wrong input, 130 "
      "Ctrl-C.");
  Action action;
  addPlay(app, action);
  addRender(app, action);
  addVerify(app, action);
  addSmoke(app, action);
  addCheck(app, action);
  addExplain(app, action);
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) refuseEmptyTexts(*command);
  const auto isNamed = [&](const CLI::App* command) { return command->get_name() == argv[1]; };
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  if (argc > 1 && argv[1][0] != '-' && std::none_of(commands.begin(), commands.end(), isNamed))
    return refuse({std::string("no command '") + argv[1] + "' (brittle --help)"});
  const std::optional<int> ended = readArguments(app, argc, argv);
  return ended ? *ended : action();
}

}  // namespace brittle::program

int main(int argc, char** argv) {
  return brittle::program::run(argc, argv);
}
