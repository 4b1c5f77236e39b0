// The real program in a real window on a screen that nobody sees (Xvfb), driven by xdotool as a user would
// and watched through its state log (app/state_log.h).
#pragma once

#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "cli/program.h"
#include "level/json.h"
#include "math/vec.h"

namespace anamorph::testing {

using Environment = std::map<std::string, std::string>;  // an empty value: unset

inline double secondsOfClock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Longer than anything takes on a machine that does much else: waiting so long only ends a test that hangs.
constexpr double hang = 240;

inline void sleepFor(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

inline bool isInstalled(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

/// A process that ends with this object.
class Process {
 public:
  Process(const std::vector<std::string>& arguments, const Environment& environment, const std::string& out,
          const std::string& err, int keptOpen = -1) {
    pid_ = ::fork();
    if (pid_ != 0) return;
    // Drivers of windows leak, and are unloaded before leaks are looked for, so that no suppression can name them.
    // Our own leaks are found in the tests that make GUIs.
    ::setenv("ASAN_OPTIONS", "detect_leaks=0", 0);
    for (const auto& [name, value] : environment) {
      value.empty() ? ::unsetenv(name.c_str()) : ::setenv(name.c_str(), value.c_str(), 1);
    }
    ::dup2(::open("/dev/null", O_RDONLY), 0);
    ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 1);
    ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 2);
    if (keptOpen >= 0) ::fcntl(keptOpen, F_SETFD, 0);
    std::vector<char*> list;
    for (const std::string& argument : arguments) list.push_back(const_cast<char*>(argument.c_str()));
    list.push_back(nullptr);
    ::execvp(list[0], list.data());
    ::_exit(127);
  }
  ~Process() {
    if (ended()) return;
    ::kill(pid_, SIGTERM);
    if (!waitForEnd(3)) ::kill(pid_, SIGKILL);
    waitForEnd(3);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  int pid() const { return pid_; }
  bool ended() {
    if (exitCode_ != running) return true;
    int status = 0;
    if (::waitpid(pid_, &status, WNOHANG) != pid_) return false;
    exitCode_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    return true;
  }
  bool waitForEnd(double seconds = hang) {
    const double end = secondsOfClock() + seconds;
    while (!ended() && secondsOfClock() < end) sleepFor(0.02);
    return ended();
  }
  /// Negative: the signal that ended it.
  int exitCode() {
    ended();
    return exitCode_;
  }
  /// Of the processor, all threads.
  double cpuSeconds() const {
    std::ifstream file("/proc/" + std::to_string(pid_) + "/stat");
    std::string text((std::istreambuf_iterator<char>(file)), {});
    std::istringstream rest(text.substr(text.rfind(')') + 1));
    std::string skipped;
    for (int i = 3; i < 14; ++i) rest >> skipped;
    double user = 0, system = 0;
    rest >> user >> system;
    return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
  }

 private:
  static constexpr int running = 1 << 20;
  int pid_ = -1;
  int exitCode_ = running;
};

/// An X server of its own. Throws Error when there is none to be had.
class VirtualScreen {
 public:
  VirtualScreen() {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw Error("no pipe");
    server_ = std::make_unique<Process>(
        std::vector<std::string>{"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0",
                                 "2600x1500x24", "-nolisten", "tcp"},
        Environment{}, "/dev/null", "/dev/null", ends[1]);
    ::close(ends[1]);
    std::string number;
    for (char c = 0; ::read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
    ::close(ends[0]);
    if (number.empty()) throw Error("Xvfb does not start");
    display_ = ":" + number;
  }
  const std::string& display() const { return display_; }

 private:
  std::unique_ptr<Process> server_;
  std::string display_;
};

/// A line of the state log.
class State {
 public:
  State() = default;
  explicit State(const std::string& line) : json_(parseJson(line, "state log")) {}

  bool empty() const { return json_.keys.empty(); }
  const JsonValue& operator[](const std::string& key) const {
    for (std::size_t i = 0; i < json_.keys.size(); ++i) {
      if (json_.keys[i] == key) return json_.items[i];
    }
    throw Error("the state log has no member " + key);
  }
  bool is(const std::string& key) const { return (*this)[key].text == "true"; }
  double number(const std::string& key) const { return (*this)[key].number; }
  const std::string& text(const std::string& key) const { return (*this)[key].text; }
  Vector vector(const std::string& key) const { return vectorOf((*this)[key]); }
  std::vector<double> list(const std::string& key) const {
    std::vector<double> numbers;
    for (const JsonValue& item : (*this)[key].items) numbers.push_back(item.number);
    return numbers;
  }
  static Vector vectorOf(const JsonValue& value) {
    return {value.items.at(0).number, value.items.at(1).number, value.items.at(2).number};
  }
  bool settled() const { return is("complete") && !is("unfinished") && !is("changing"); }

 private:
  JsonValue json_;
};

/// WM_DELETE_WINDOW. xdotool 3.2016 cannot send it, and Xlib's headers may not be there, its library is.
inline void sendDeleteWindow(const std::string& displayName, unsigned long window) {
  void* const library = ::dlopen("libX11.so.6", RTLD_NOW);
  if (!library || window == 0) throw Error("no libX11 or no window");
  const auto open = reinterpret_cast<void* (*)(const char*)>(::dlsym(library, "XOpenDisplay"));
  const auto close = reinterpret_cast<int (*)(void*)>(::dlsym(library, "XCloseDisplay"));
  const auto atom =
      reinterpret_cast<unsigned long (*)(void*, const char*, int)>(::dlsym(library, "XInternAtom"));
  const auto send =
      reinterpret_cast<int (*)(void*, unsigned long, int, long, void*)>(::dlsym(library, "XSendEvent"));
  void* const display = open(displayName.c_str());
  if (!display) throw Error("cannot open the display " + displayName);
  union {  // XEvent: an XClientMessageEvent, padded
    struct {
      int type;
      unsigned long serial;
      int sent;
      void* display;
      unsigned long window, message;
      int format;
      long data[5];
    } message;
    long padding[24];
  } event{};
  constexpr int clientMessage = 33;
  event.message.type = clientMessage;
  event.message.window = window;
  event.message.message = atom(display, "WM_PROTOCOLS", 0);
  event.message.format = 32;
  event.message.data[0] = static_cast<long>(atom(display, "WM_DELETE_WINDOW", 0));
  send(display, window, 0, 0, &event);
  close(display);
}

class VirtualWindow {
 public:
  /// `arguments` of the command open, or "--with-tour"; the window is at the screen's upper left corner.
  explicit VirtualWindow(std::vector<std::string> arguments, Environment more = {}) {
    Environment environment{{"DISPLAY", screen_.display()},
                            {"HOME", folder_ / ""},
                            {"XDG_CONFIG_HOME", folder_ / "config"},
                            {"XDG_STATE_HOME", folder_ / "state"},
                            {"WAYLAND_DISPLAY", ""}};
    for (const auto& [name, value] : more) environment[name] = value;
    arguments.insert(arguments.begin(), {ANAMORPH_PROGRAM, "open"});
    // A first start shows newcomers around, which most tests do not want.
    const bool tour = std::erase(arguments, "--with-tour") > 0;
    if (!tour) arguments.push_back("--no-tour");
    arguments.insert(arguments.end(), {"--log-state", logPath()});
    program_ = std::make_unique<Process>(arguments, environment, folder_ / "out", folder_ / "err");
  }

  Process& program() { return *program_; }
  /// A name in the folder that is the user's home.
  std::string inHome(const std::string& name) const { return folder_ / name; }
  std::string errorText() const { return readAll(folder_ / "err"); }
  std::string preferencesPath() const { return folder_ / "config/anamorph/preferences.json"; }

  /// The newest line; empty before the first frame.
  State state() const {
    const std::string text = readAll(logPath());
    const std::size_t begin = beginOfLastLine(text), end = text.find('\n', begin);
    return end == std::string::npos ? State() : State(text.substr(begin, end - begin));
  }

  /// Whether a state is as wanted, from the newest one on; waits for it. No line is missed, however seldom this process
  /// gets to look.
  bool waitFor(const std::function<bool(const State&)>& wanted, double seconds = hang) const {
    return waitFrom(beginOfLastLine(readAll(logPath())), wanted, seconds);
  }
  /// The same from the first one on.
  bool waitForEver(const std::function<bool(const State&)>& wanted) const {
    return waitFrom(0, wanted, hang);
  }
  bool settle() const {
    return waitFor([](const State& s) { return s.settled(); });
  }
  /// Waits until the window says that it draws nothing more.
  bool rest() const {
    return waitFor([](const State& s) { return s.is("resting"); });
  }

  // What a user does, one thing after the other: each returns when a frame has seen it, or the program has ended.
  void move(double x, double y) {
    mouse_ = {std::round(x), std::round(y)};
    const auto isThere = [this](const State& s) { return s.list("mouse") == mouse_; };
    const double end = secondsOfClock() + hang;
    do {
      point(mouse_[0], mouse_[1]);
      if (program_->ended() || waitFor(isThere, patience)) return;
      point(mouse_[0] + 1, mouse_[1]);
    } while (secondsOfClock() < end);
    throw Error(fmt::format("the mouse does not come to {}, {}", x, y));
  }
  void moveBy(double x, double y) { move(mouse_[0] + x, mouse_[1] + y); }
  void press(int button = 1) { send(fmt::format("mousedown {}", button), {{"buttonsDown", 1}}); }
  void release(int button = 1) { send(fmt::format("mouseup {}", button), {{"buttonsUp", 1}}); }
  void click(double x, double y, int button = 1) {
    move(x, y);
    press(button);
    release(button);
  }
  /// From one place to another in some steps; the button stays down.
  void dragTo(double fromX, double fromY, double toX, double toY, int button = 1) {
    move(fromX, fromY);
    press(button);
    for (int i = 1; i <= 5; ++i) move(fromX + (toX - fromX) * i / 5, fromY + (toY - fromY) * i / 5);
  }
  void turnWheelUp() { send("click 4", {{"wheel", 1}}); }
  /// A key, or several at once: "Return", "ctrl+z".
  void key(const std::string& keys) {
    const auto count = 1 + std::count(keys.begin(), keys.end(), '+');
    send("key " + keys, {{"keysDown", count}, {"keysUp", count}});
  }
  void hold(const std::string& key) { send("keydown " + key, {{"keysDown", 1}}); }
  void letGoOf(const std::string& key) { send("keyup " + key, {{"keysUp", 1}}); }
  /// Small letters, digits and signs that need no shift.
  void type(const std::string& text) {
    for (const char c : text)
      send(fmt::format("type '{}'", c), {{"characters", 1}, {"keysDown", 1}, {"keysUp", 1}});
  }
  void shell(const std::string& command) const {
    if (std::system(("DISPLAY=" + screen_.display() + " " + command).c_str()) != 0) throw Error(command);
  }
  void resize(int width, int height) const {
    const std::vector<double> size{double(width), double(height)};
    const double end = secondsOfClock() + hang;
    do {
      xdotool(fmt::format("windowsize {} {} {}", id(), width, height));
      if (waitFor([&](const State& s) { return s.list("window") == size; }, patience)) return;
    } while (secondsOfClock() < end);
    throw Error(fmt::format("the window does not become {} x {}", width, height));
  }
  /// As the button of a window's frame does: a message that the program may refuse.
  void askToClose() const { sendDeleteWindow(screen_.display(), id()); }

 private:
  unsigned long id() const {
    const TemporaryFolder folder;
    const double end = secondsOfClock() + hang;
    do {
      xdotool(fmt::format("search --onlyvisible --pid {} >{}", program_->pid(), folder / "id"));
      if (const auto id = std::strtoul(readAll(folder / "id").c_str(), nullptr, 10)) return id;
      sleepFor(0.1);
    } while (secondsOfClock() < end && !program_->ended());
    throw Error("the window is not to be found");
  }
  std::string logPath() const { return folder_ / "state.jsonl"; }

  static std::size_t beginOfLastLine(const std::string& text) {
    const std::size_t end = text.rfind('\n');
    return end == std::string::npos || end == 0 ? 0 : text.rfind('\n', end - 1) + 1;  // npos + 1 is 0
  }

  bool waitFrom(std::size_t at, const std::function<bool(const State&)>& wanted, double seconds) const {
    const double end = secondsOfClock() + seconds;
    do {
      const bool ended = program_->ended();  // before the last lines are read
      std::ifstream log(logPath(), std::ios::binary);
      log.seekg(static_cast<std::streamoff>(at));
      for (std::string line; std::getline(log, line) && !log.eof(); at += line.size() + 1) {
        if (wanted(State(line))) return true;
      }
      if (ended) return false;
      sleepFor(0.03);
    } while (secondsOfClock() < end);
    return false;
  }

  // Whether it did anything is told by the window alone: on a busy machine it may fail without a reason.
  void xdotool(const std::string& commands) const {
    const std::string line = "DISPLAY=" + screen_.display() + " xdotool " + commands + " 2>/dev/null";
    [[maybe_unused]] const int ignored = std::system(line.c_str());
  }
  void point(double x, double y) const { xdotool(fmt::format("mousemove {:.0f} {:.0f}", x, y)); }

  using Counts = std::map<std::string, std::ptrdiff_t>;
  static Counts countsIn(const State& state) {
    Counts counts;
    const JsonValue& input = state["input"];
    for (std::size_t i = 0; i < input.keys.size(); ++i)
      counts[input.keys[i]] = static_cast<std::ptrdiff_t>(input.items[i].number);
    return counts;
  }

  // Input comes in the order in which it was sent. So what has not come when a later motion of the mouse has is lost, and
  // may be sent again.
  void send(const std::string& commands, const Counts& more) {
    const Counts before = countsIn(state());
    const auto arrived = [&](const State& s) {
      const Counts now = countsIn(s);
      return std::all_of(more.begin(), more.end(), [&](const auto& kind) {
        return now.at(kind.first) >= before.at(kind.first) + kind.second;
      });
    };
    const auto lost = [&](const State& s) {
      const Counts now = countsIn(s);
      return std::all_of(more.begin(), more.end(),
                         [&](const auto& kind) { return now.at(kind.first) == before.at(kind.first); });
    };
    const double end = secondsOfClock() + hang;
    do {
      xdotool(commands);
      if (program_->ended() || waitFor(arrived, patience)) return;
      const std::ptrdiff_t motions = countsIn(state()).at("motions");
      point(mouse_[0] + 1, mouse_[1]);
      point(mouse_[0], mouse_[1]);
      waitFor([&](const State& s) { return countsIn(s).at("motions") > motions; });
      if (!lost(state()) && waitFor(arrived)) return;
    } while (secondsOfClock() < end && !program_->ended());
    if (!program_->ended()) throw Error("the window does not receive: " + commands);
  }

  static constexpr double patience = 20;  // seconds; then it is looked whether input was lost

  TemporaryFolder folder_;
  VirtualScreen screen_;
  std::vector<double> mouse_{0, 0};
  std::unique_ptr<Process> program_;
};

}  // namespace anamorph::testing
