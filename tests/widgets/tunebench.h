// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parameterbench.h"
#include "widgets/control/arming.h"
#include "widgets/control/tunecolumn.h"
#include "widgets/control/tuneform.h"
#include "widgets/control/tunegains.h"
#include "widgets/control/tunepage.h"

#include <cmath>
#include <memory>
#include <utility>

namespace mb::test {

/// A board with four axes, heard, at this place.
inline DeviceView boardAt(const char *place)
{
    DeviceView board;
    board.id = {2};
    board.family = findFamily(families(), "quadquad2drv");
    board.link = board.unit = place;
    board.liveness.heard = true;
    board.telemetry = std::make_shared<Telemetry>(board.family->channels);
    board.parameters.edit().resize(board.family->parameters.size());
    return board;
}

/// What a drive records of a velocity step: 100 Hz encoder and output, 50 Hz current.
class Recording {
public:
    explicit Recording(Instant start)
        : m_telemetry(std::make_shared<Telemetry>(dmc60c().channels))
        , m_now(start)
    {
    }
    [[nodiscard]] const std::shared_ptr<Telemetry> &telemetry() const { return m_telemetry; }
    [[nodiscard]] Instant now() const { return m_now; }

    void add(const char *channel, double value) { m_telemetry->append({*m_telemetry->find(channel), m_now, value}); }
    /// Seconds at a set-point, reached as a motor with a slightly lively loop does.
    void run(double seconds, double target)
    {
        constexpr double omega = 14.0;
        constexpr double damping = 0.65;
        const double begin = m_velocity;
        const auto steps = static_cast<int>(seconds * 100.0);
        const double damped = omega * std::sqrt(1.0 - damping * damping);
        for (int i = 0; i < steps; ++i) {
            const double t = i / 100.0;
            const double rest = std::exp(-damping * omega * t)
                * (std::cos(damped * t) + damping * omega / damped * std::sin(damped * t));
            const double before = m_velocity;
            m_velocity = target + (begin - target) * rest;
            m_position += m_velocity / 100.0;
            const double noise = 0.004 * target * std::sin(i * 1.7);
            add("velocity", m_velocity + noise);
            add("position", std::round(m_position));
            add("duty", m_velocity / 350000.0 + (m_velocity - before) / 60000.0);
            if (m_commanded)
                add("setpoint", target);
            if (i % 2 == 0)
                add("current", 2.3 + (m_velocity - before) / 160.0);
            m_now += std::chrono::milliseconds(10);
        }
        m_telemetry->commit();
    }
    /// Nothing comes for so long.
    void skip(double seconds) { m_now += std::chrono::milliseconds(static_cast<int>(seconds * 1000.0)); }
    void setCommanded(bool commanded)
    {
        m_commanded = commanded;
        if (!commanded)
            m_telemetry->breakLine(*m_telemetry->find("setpoint"));
    }

private:
    std::shared_ptr<Telemetry> m_telemetry;
    Instant m_now;
    double m_velocity = 0.0;
    double m_position = 0.0;
    bool m_commanded = false;
};

/// A drive that was read and records, with gains in both slots.
inline DeviceView tunableDrive(const std::shared_ptr<Telemetry> &telemetry, std::uint32_t id = 1, int address = 5)
{
    DeviceView device = readDrive(id, address);
    device.identity.edit().name = "shooter";
    device.link = "sim:can";
    device.unit = "simulated place sim:can dmc60c:" + std::to_string(address);
    device.telemetry = telemetry;
    device.rates = {100, 100, 50, 100, 100, 100, 10, 10, 10};
    const auto set = [&device](const char *key, double value) {
        device.parameters.edit()[named(key).value].raw = rawOf(key, value);
    };
    set("slot0.p", 1.165);
    set("slot0.i", 0.00346);
    set("slot1.p", 1.6);
    set("slot1.f", 0.5);
    return device;
}

/// The page over one drive, shown and active.
struct TuneBench {
    FakeWorkbench workbench;
    Selection selection;
    ThemeSource theme;
    Arming arming{workbench};
    Recording recording{workbench.time};
    std::unique_ptr<TunePage> page;

    explicit TuneBench(const Theme &look = lightTheme(), QSize size = {1208, 760})
        : theme(look)
    {
        workbench.shot.devices.push_back(tunableDrive(recording.telemetry()));
        LinkView link;
        link.address = "sim:can";
        link.name = "sim:can";
        link.simulated = true;
        workbench.shot.links.push_back(link);
        selection.select({1});
        page = std::make_unique<TunePage>(workbench, selection, arming, theme, nullptr);
        page->resize(size);
        page->showLive(true); // most is about driving by hand
        page->show();
        QApplication::setActiveWindow(page.get());
    }
    /// The page of the next window, before this one is gone.
    void openNext()
    {
        const auto before
            = std::exchange(page, std::make_unique<TunePage>(workbench, selection, arming, theme, nullptr));
        page->resize(before->size());
        page->show();
    }
    [[nodiscard]] DeviceView &device() { return workbench.device(0); }
    void arm()
    {
        arming.arm({1});
        workbench.publish();
    }
    /// What the engine would tell after a start.
    void confirmMotion()
    {
        const auto starts = workbench.given<orders::StartMotion>();
        const auto updates = workbench.given<orders::UpdateMotion>();
        device().motion.running = true;
        device().motion.setPoint = updates.empty() ? starts.back().setPoint : updates.back().setPoint;
        device().liveness.moving = true;
        workbench.publish();
    }
    /// Time passes, and the recording with it.
    void pass(double seconds, double velocity)
    {
        recording.run(seconds, velocity);
        workbench.time = recording.now();
        workbench.publish();
    }
    template <class Widget> [[nodiscard]] Widget *find(const char *accessibleName) const
    {
        for (auto *widget : page->findChildren<Widget *>()) {
            if (widget->accessibleName() == QString::fromUtf8(accessibleName))
                return widget;
        }
        return nullptr;
    }
};

} // namespace mb::test
