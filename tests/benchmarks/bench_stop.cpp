// SPDX-License-Identifier: GPL-3.0-or-later
// docs/names.md#numbers: stop key pressed to stop frame handed to the link, p99 at most 20 ms, also while another order blocks the
// engine. The real stop keys and the real engine, on a terminal whose other end takes the time.
#include "app/engine.h"
#include "app/stopkeys.h"
#include "support/pseudoterminal.h"
#include "support/textmotor.h"

#include <QApplication>
#include <QKeyEvent>
#include <QWidget>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>

#include <poll.h>

namespace mb {
namespace {

using namespace std::chrono_literals;
using SteadyClock = std::chrono::steady_clock;

constexpr int rounds = 300;
constexpr auto blocked = 60ms;

/// When a stop came at the far end; zero until one did.
class FarEnd {
public:
    explicit FarEnd(const test::PseudoTerminal &terminal)
        : m_thread([this, &terminal] { listen(terminal); })
    {
    }
    FarEnd(const FarEnd &) = delete;
    FarEnd &operator=(const FarEnd &) = delete;
    ~FarEnd()
    {
        m_ending = true;
        m_thread.join();
    }
    void forget() { m_heardAt = SteadyClock::duration::zero(); }
    [[nodiscard]] SteadyClock::duration heardAt() const { return m_heardAt; }

private:
    void listen(const test::PseudoTerminal &terminal)
    {
        while (!m_ending) {
            pollfd source{terminal.descriptor(), POLLIN, 0};
            if (::poll(&source, 1, 50) != 1)
                continue;
            const auto at = SteadyClock::now().time_since_epoch();
            if (terminal.read().empty())
                std::this_thread::sleep_for(1ms); // nobody is there yet
            else if (m_heardAt.load() == SteadyClock::duration::zero())
                m_heardAt = at;
        }
    }

    std::atomic<bool> m_ending = false;
    std::atomic<SteadyClock::duration> m_heardAt = SteadyClock::duration::zero();
    std::thread m_thread;
};

double milliseconds(SteadyClock::duration time)
{
    return std::chrono::duration<double, std::milli>(time).count();
}

void serveFor(SteadyClock::duration time)
{
    for (const auto end = SteadyClock::now() + time; SteadyClock::now() < end;)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
}

/// One key press, and how long its stop took.
double press(QWidget &window, FarEnd &far)
{
    far.forget();
    QKeyEvent key(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
    const auto at = SteadyClock::now().time_since_epoch();
    QCoreApplication::sendEvent(&window, &key);
    while (far.heardAt() == SteadyClock::duration::zero() && SteadyClock::now().time_since_epoch() - at < 5s)
        std::this_thread::sleep_for(100us);
    return milliseconds(far.heardAt() - at);
}

void measure(const char *what, QWidget &window, Engine &engine, FarEnd &far, bool blocking)
{
    std::vector<double> times;
    for (int i = 0; i < rounds; ++i) {
        auto begun = std::make_shared<std::atomic<bool>>(!blocking);
        if (blocking)
            engine.post([begun](EngineCore &) {
                *begun = true;
                std::this_thread::sleep_for(blocked);
            });
        while (!*begun)
            std::this_thread::sleep_for(100us);
        times.push_back(press(window, far));
        serveFor(blocking ? blocked + 10ms : 10ms);
    }
    std::sort(times.begin(), times.end());
    std::printf("%s: median %.2f ms, p99 %.2f ms, worst %.2f ms (p99 at most 20)\n", what, times[times.size() / 2],
        times[times.size() * 99 / 100], times.back());
}

int run()
{
    const test::PseudoTerminal terminal;
    FarEnd far(terminal);
    Engine engine(test::textFamilies, false);
    engine.send(orders::OpenLink{*LinkAddress::parse("serial:" + terminal.path())});
    for (int i = 0; i < 500 && engine.snapshot().devices.empty(); ++i)
        serveFor(10ms);
    if (engine.snapshot().devices.empty())
        return 1;
    StopKeys keys;
    qApp->installEventFilter(&keys);
    QObject::connect(&keys, &StopKeys::stopPressed, &engine, [&engine] { engine.stopAll(StopCause::User); });
    QWidget window;
    window.show();
    measure("stop key to line, engine free", window, engine, far, false);
    measure("stop key to line, engine blocked by another order", window, engine, far, true);
    return 0;
}

} // namespace
} // namespace mb

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    return mb::run();
}
