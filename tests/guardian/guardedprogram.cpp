// SPDX-License-Identifier: GPL-3.0-or-later
// A program that drives a motor without watchdog under the real guardian, to be killed and frozen:
//     guardedprogram packet|stream|INTERFACE
// It drives on descriptor 5, CAN frames of a packet socket or lines of text on a terminal, or on a CAN interface.
// Prints "guardian PID" once it drives, "ended: REASON" when the motion ends, and goes on until it is killed.
#include "app/guardian/client/guardianclient.h"
#include "model/setpointstream.h"
#include "support/loosemotor.h"
#include "transport/backends/socketcan.h"
#include "transport/qtclock.h"

#include <QCoreApplication>

#include <cstdio>
#include <cstring>

#include <unistd.h>

namespace {

using namespace mb;
using namespace std::chrono_literals;

constexpr int lineDescriptor = 5;

/// Frames as lines of text on a stream.
class TextLink final : public CanLink {
public:
    explicit TextLink(Clock &clock)
        : CanLink(LinkAddress{"serial", "tty", {}}, clock)
    {
    }

private:
    Result<void> doOpen() override { return {}; }
    void doClose() override { }
    [[nodiscard]] Outlet doOutlet() const override { return {Outlet::Form::Stream, lineDescriptor}; }
    Result<void> doSend(const CanFrame &frame, Priority) override
    {
        const std::string text = toText(frame) + "\n";
        return ::write(lineDescriptor, text.data(), text.size()) < 0 ? fail(Fault::LinkLost) : Result<void>();
    }
    [[nodiscard]] std::size_t doBacklog() const override { return 0; }
    [[nodiscard]] int doBitrate() const override { return 0; }
};

std::unique_ptr<CanLink> linkOf(const char *form, Clock &clock)
{
    if (std::strcmp(form, "stream") == 0)
        return std::make_unique<TextLink>(clock);
    if (std::strcmp(form, "packet") == 0)
        return std::make_unique<SocketCanLink>(LinkAddress{"socketcan", "test", {}}, clock, lineDescriptor);
    return std::make_unique<SocketCanLink>(LinkAddress{"socketcan", form, {}}, clock);
}

StopScript textScript()
{
    const std::string stop = "STOP\n";
    const std::string answer = "ok";
    return {{{std::nullopt, {stop.begin(), stop.end()}, {answer.begin(), answer.end()}, {}, 20ms, 8}}};
}

} // namespace

int main(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    QtClock clock;
    GuardianClient guardian;
    const auto link = linkOf(argc > 1 ? argv[1] : "", clock);
    if (!link->open())
        return 1;
    test::LooseMotor motor(*link, clock);
    if (link->outlet().form == Outlet::Form::Stream)
        motor.script = textScript();
    motor.guard().setSource(&guardian);
    SetPointStream stream(motor, clock);
    SetPoint setPoint;
    setPoint.mode = Mode::Duty;
    const Subscription changed = stream.changed().add([&stream] {
        if (!stream.isRunning())
            std::printf("ended: %s\n", stream.reason().english().c_str());
        std::fflush(stdout);
    });
    if (const auto started = stream.start(setPoint, 1h); !started) {
        std::printf("ended: %s\n", started.error().text().c_str());
        return 1;
    }
    for (const pid_t pid : guardian.processes())
        std::printf("guardian %d\n", pid);
    std::fflush(stdout);
    return QCoreApplication::exec();
}
