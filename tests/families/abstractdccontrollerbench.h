// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "abstractdcbench.h"
#include "families/abstractdc/scan.h"
#include "families/abstractdc/setpoints.h"
#include "model/parametertransfer.h"
#include "model/setpointstream.h"
#include "support/fakeunit.h"
#include "support/simulatedsession.h"

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace mb::abstractdc {

class AbstractDcController : public Drives {
protected:
    using Drives::Drives;
    Device &open(int offset, const Dialect *dialect)
    {
        device = family.open(host, clock, identityOf(offset, dialect));
        sentTap = host.traffic().add([this](const Traffic &traffic) {
            if (traffic.direction == Direction::Sent)
                sent.push_back(toText(*traffic.can));
        });
        clock.advance(500ms);
        sent.clear();
        return *device;
    }
    ParameterIndex index(std::string_view key) const { return *findParameter(family.parameters, key); }
    ChannelIndex channel(std::string_view key) const { return *findChannel(family.channels, key); }
    Result<std::int64_t> write(std::string_view key, std::int64_t raw)
    {
        return test::run(clock, device->write(index(key), raw));
    }
    void powerCycle(Simulator &drive, Duration without)
    {
        drive.setPowered(false);
        clock.advance(without);
        drive.setPowered(true);
        clock.advance(std::chrono::seconds(1));
    }
    /// It stands somewhere else afterwards.
    bool turnsAwayFromZero()
    {
        for (int i = 0; i < 100; ++i) { // it is led there
            if (!device->command(setPoint(Mode::Duty, 0.6)))
                return false;
            clock.advance(std::chrono::milliseconds(20));
        }
        device->stop();
        clock.advance(std::chrono::seconds(5));
        return std::abs(latest("position")) > 1000.0;
    }
    static SetPoint setPoint(Mode mode, double target)
    {
        SetPoint s;
        s.mode = mode;
        s.target = target;
        return s;
    }
    [[nodiscard]] std::vector<std::string> sentOf(const std::string &prefix) const
    {
        std::vector<std::string> all;
        for (const std::string &frame : sent) {
            if (frame.starts_with(prefix))
                all.push_back(frame);
        }
        return all;
    }
    double latest(std::string_view key) const
    {
        const auto point = device->telemetry()->latest(channel(key));
        return point ? point->value : std::nan("");
    }
    std::unique_ptr<Device> device;
    std::vector<std::string> sent;
    Subscription sentTap;
};

} // namespace mb::abstractdc
