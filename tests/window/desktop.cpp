#include "tests/window/desktop.hpp"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace atrium::window {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// Until `done` says so, or the time is over.
bool await(const std::function<bool()>& done, std::chrono::milliseconds most)
{
    const auto end = Clock::now() + most;
    while (!done()) {
        if (Clock::now() > end) return false;
        std::this_thread::sleep_for(20ms);
    }
    return true;
}

/// The fields of /proc/PID/stat after the program's name.
std::vector<std::string> stat_of(int pid)
{
    std::ifstream in("/proc/" + std::to_string(pid) + "/stat");
    std::string text((std::istreambuf_iterator<char>(in)), {});
    text.erase(0, text.rfind(')') + 1);
    std::istringstream words(text);
    return {std::istream_iterator<std::string>(words), {}};
}

std::string title_of(Display* display, Window window)
{
    const Atom name = XInternAtom(display, "_NET_WM_NAME", False), utf8 = XInternAtom(display, "UTF8_STRING", False);
    Atom type = 0;
    int format = 0;
    unsigned long count = 0, left = 0;
    unsigned char* data = nullptr;
    XGetWindowProperty(display, window, name, 0, 1024, False, utf8, &type, &format, &count, &left, &data);
    std::string out;
    if (data) {
        out.assign(reinterpret_cast<char*>(data), count);
        XFree(data);
    }
    return out;
}

Window find_below(Display* display, Window parent, const std::string& title)
{
    Window root = 0, above = 0, *children = nullptr;
    unsigned count = 0;
    Window found = 0;
    if (!XQueryTree(display, parent, &root, &above, &children, &count)) return 0;
    for (unsigned i = 0; i < count && !found; ++i) {
        XWindowAttributes attributes{};
        XGetWindowAttributes(display, children[i], &attributes);
        const bool seen = attributes.map_state == IsViewable;
        found = seen && title_of(display, children[i]).find(title) != std::string::npos
                    ? children[i]
                    : find_below(display, children[i], title);
    }
    if (children) XFree(children);
    return found;
}

} // namespace

Process::Process(const std::vector<std::string>& command, const std::filesystem::path& folder,
                 const std::vector<std::string>& environment)
{
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("cannot start " + command.front());
    if (pid_ > 0) return;
    prctl(PR_SET_PDEATHSIG, SIGKILL); // also when the tests end without destroying anything
    if (!folder.empty() && chdir(folder.c_str()) != 0) _exit(127);
    for (const std::string& variable : environment) putenv(const_cast<char*>(variable.c_str()));
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments.front(), arguments.data());
    _exit(127);
}

Process::~Process()
{
    if (!running()) return;
    kill(pid_, SIGTERM);
    if (!wait(5s)) {
        kill(pid_, SIGKILL);
        static_cast<void>(wait(5s));
    }
}

bool Process::running()
{
    return !wait(0s);
}

std::optional<int> Process::wait(std::chrono::seconds most)
{
    await(
        [&] {
            int status = 0;
            if (!code_ && waitpid(pid_, &status, WNOHANG) == pid_)
                code_ = WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
            return code_.has_value();
        },
        most);
    return code_;
}

double Process::cpu_seconds() const
{
    const std::vector<std::string> fields = stat_of(pid_);
    return (std::stod(fields.at(11)) + std::stod(fields.at(12))) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

std::uint64_t Process::resident_bytes() const
{
    return std::stoull(stat_of(pid_).at(21)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

Desktop::Desktop(ivec2 size)
{
    // The server says through a pipe which display it took.
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
    const std::string screen = std::to_string(size.x) + "x" + std::to_string(size.y) + "x24";
    server_.emplace(std::vector<std::string>{"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0", screen,
                                             "-nolisten", "tcp", "-noreset"},
                    "", std::vector<std::string>{});
    ::close(ends[1]);
    std::string number;
    for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
    ::close(ends[0]);
    if (number.empty()) throw std::runtime_error("Xvfb did not start: is it installed?");
    name_ = ":" + number;
    // A window that is gone, or has no picture now, is no reason to end the tests.
    XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
    display_ = XOpenDisplay(name_.c_str());
    if (!display_) throw std::runtime_error("cannot reach " + name_);
    manager_.emplace(std::vector<std::string>{"openbox", "--sm-disable"}, "",
                     std::vector<std::string>{"DISPLAY=" + name_, "HOME=/nonexistent"});
    const Atom check = XInternAtom(display_, "_NET_SUPPORTING_WM_CHECK", False);
    const bool managed = await(
        [&] {
            Atom type = 0;
            int format = 0;
            unsigned long count = 0, left = 0;
            unsigned char* data = nullptr;
            XGetWindowProperty(display_, DefaultRootWindow(display_), check, 0, 1, False, AnyPropertyType, &type,
                               &format, &count, &left, &data);
            if (data) XFree(data);
            return count > 0;
        },
        10s);
    if (!managed) throw std::runtime_error("openbox did not start: is it installed?");
}

Desktop::~Desktop()
{
    if (display_) XCloseDisplay(display_);
}

Desktop::WindowId Desktop::find(const std::string& title, std::chrono::seconds most)
{
    WindowId found = 0;
    await([&] { return (found = find_below(display_, DefaultRootWindow(display_), title)) != 0; }, most);
    return found;
}

ivec2 Desktop::size_of(WindowId window)
{
    XWindowAttributes attributes{};
    XGetWindowAttributes(display_, window, &attributes);
    return {attributes.width, attributes.height};
}

void Desktop::resize(WindowId window, ivec2 size)
{
    XResizeWindow(display_, window, static_cast<unsigned>(size.x), static_cast<unsigned>(size.y));
    XSync(display_, False);
}

void Desktop::minimise(WindowId window)
{
    XIconifyWindow(display_, window, 0);
    XSync(display_, False);
}

void Desktop::restore(WindowId window)
{
    XMapRaised(display_, window);
    XSync(display_, False);
}

void Desktop::close(WindowId window)
{
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window;
    event.xclient.message_type = XInternAtom(display_, "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(XInternAtom(display_, "WM_DELETE_WINDOW", False));
    XSendEvent(display_, window, False, NoEventMask, &event);
    XSync(display_, False);
}

void Desktop::focus(WindowId window)
{
    XRaiseWindow(display_, window);
    XSetInputFocus(display_, window, RevertToParent, CurrentTime);
    XSync(display_, False);
}

Image8 Desktop::grab(WindowId window)
{
    const ivec2 size = size_of(window);
    Image8 out(size.x, size.y, 3);
    XImage* image = XGetImage(display_, window, 0, 0, static_cast<unsigned>(size.x), static_cast<unsigned>(size.y),
                              AllPlanes, ZPixmap);
    if (!image) return {}; // hidden, or of another size meanwhile
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const unsigned long pixel = XGetPixel(image, x, y);
            std::uint8_t* to = out.at(x, y);
            to[0] = static_cast<std::uint8_t>(pixel >> 16 & 255);
            to[1] = static_cast<std::uint8_t>(pixel >> 8 & 255);
            to[2] = static_cast<std::uint8_t>(pixel & 255);
        }
    }
    XDestroyImage(image);
    return out;
}

namespace {

void key_event(Display* display, const std::string& key, bool down)
{
    const KeyCode code = XKeysymToKeycode(display, XStringToKeysym(key.c_str()));
    if (code == 0) throw std::runtime_error("no key is called " + key);
    XTestFakeKeyEvent(display, code, down ? True : False, CurrentTime);
    XSync(display, False);
}

} // namespace

void Desktop::press(const std::string& key)
{
    key_event(display_, key, true);
}

void Desktop::release(const std::string& key)
{
    key_event(display_, key, false);
}

void Desktop::tap(const std::string& key, const std::string& held)
{
    if (!held.empty()) press(held);
    press(key);
    std::this_thread::sleep_for(10ms);
    release(key);
    if (!held.empty()) release(held);
}

void Desktop::move(WindowId window, ivec2 at)
{
    ivec2 on_root;
    Window child = 0;
    XTranslateCoordinates(display_, window, DefaultRootWindow(display_), at.x, at.y, &on_root.x, &on_root.y, &child);
    XTestFakeMotionEvent(display_, -1, on_root.x, on_root.y, CurrentTime);
    XSync(display_, False);
}

void Desktop::button(int number, bool down)
{
    XTestFakeButtonEvent(display_, static_cast<unsigned>(number), down ? True : False, CurrentTime);
    XSync(display_, False);
}

void Desktop::click(WindowId window, ivec2 at, int number)
{
    move(window, at);
    std::this_thread::sleep_for(60ms); // what was clicked before has opened
    button(number, true);
    std::this_thread::sleep_for(60ms);
    button(number, false);
}

void Desktop::drag(WindowId window, ivec2 from, ivec2 to, int number)
{
    move(window, from);
    std::this_thread::sleep_for(100ms);
    button(number, true);
    for (int step = 1; step <= 10; ++step) {
        std::this_thread::sleep_for(50ms);
        move(window, from + (to - from) * step / 10);
    }
    std::this_thread::sleep_for(100ms);
    button(number, false);
}

namespace {

/// One message of the XDND protocol from `source` to `target`.
void send_xdnd(Display* display, const char* name, Window source, Window target, const std::array<long, 4>& data)
{
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = target;
    event.xclient.message_type = XInternAtom(display, name, False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(source);
    std::copy(data.begin(), data.end(), event.xclient.data.l + 1);
    XSendEvent(display, target, False, NoEventMask, &event);
    XSync(display, False);
}

/// Gives what is dropped to who asks for it.
void answer(Display* display, const XSelectionRequestEvent& request, const std::string& text)
{
    XChangeProperty(display, request.requestor, request.property, request.target, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(text.data()), static_cast<int>(text.size()));
    XEvent event{};
    event.xselection.type = SelectionNotify;
    event.xselection.requestor = request.requestor;
    event.xselection.selection = request.selection;
    event.xselection.target = request.target;
    event.xselection.property = request.property;
    event.xselection.time = request.time;
    XSendEvent(display, request.requestor, False, NoEventMask, &event);
    XSync(display, False);
}

} // namespace

bool Desktop::drop(WindowId window, const std::filesystem::path& file)
{
    const auto atom = [&](const char* name) { return XInternAtom(display_, name, False); };
    const ivec2 middle = size_of(window) / 2;
    ivec2 at;
    Window child = 0;
    XTranslateCoordinates(display_, window, DefaultRootWindow(display_), middle.x, middle.y, &at.x, &at.y, &child);
    const Window source = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
    XSetSelectionOwner(display_, atom("XdndSelection"), source, CurrentTime);
    constexpr long version = 5;
    send_xdnd(display_, "XdndEnter", source, window, {version << 24, static_cast<long>(atom("text/uri-list")), 0, 0});
    send_xdnd(display_, "XdndPosition", source, window,
              {0, static_cast<long>(at.x) << 16 | at.y, CurrentTime, static_cast<long>(atom("XdndActionCopy"))});
    bool taken = false;
    await(
        [&] {
            XEvent event;
            while (!taken && XPending(display_) > 0) {
                XNextEvent(display_, &event);
                const bool message = event.type == ClientMessage;
                if (message && event.xclient.message_type == atom("XdndStatus"))
                    send_xdnd(display_, "XdndDrop", source, window, {0, CurrentTime, 0, 0});
                if (event.type == SelectionRequest)
                    answer(display_, event.xselectionrequest, "file://" + file.string() + "\r\n");
                taken = message && event.xclient.message_type == atom("XdndFinished");
            }
            return taken;
        },
        10s);
    XDestroyWindow(display_, source);
    return taken;
}

double mean_difference(const Image8& a, const Image8& b)
{
    if (a.width != b.width || a.height != b.height) return 255;
    double sum = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) sum += std::abs(int(a.values[i]) - int(b.values[i]));
    return a.values.empty() ? 0 : sum / static_cast<double>(a.values.size());
}

} // namespace atrium::window
