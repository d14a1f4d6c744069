// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/device.h"

namespace mb::test {

/// A device that is heard from the start and answers no question. What it is told, and how it stops, its heirs say.
class MuteDevice : public Device {
protected:
    MuteDevice(const Family &family, Link &link, Clock &clock, Identity identity)
        : Device(family, link, clock, std::move(identity))
    {
        Liveness heard;
        heard.heard = true;
        setLiveness(heard);
    }

private:
    template <class T> static Task<T> no() { co_return fail(Fault::Unsupported); }
    Task<void> refresh() override { return no<void>(); }
    Task<std::int64_t> doRead(ParameterIndex) override { return no<std::int64_t>(); }
    Task<std::int64_t> doWrite(ParameterIndex, std::int64_t) override { return no<std::int64_t>(); }
    Task<bool> store(Progress &) override { return no<bool>(); }
    Task<std::vector<FaultRecord>> readFaults() override { return no<std::vector<FaultRecord>>(); }
    Task<std::vector<FaultRecord>> clearFaults() override { return no<std::vector<FaultRecord>>(); }
    Task<void> renumber(int) override { return no<void>(); }
    Task<void> setRate(ChannelIndex, double) override { return no<void>(); }
    [[nodiscard]] Result<void> doCheck(const SetPoint &) const override { return {}; }
};

} // namespace mb::test
