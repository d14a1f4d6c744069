// SPDX-License-Identifier: GPL-3.0-or-later
// Controller: what experiments ask for, and the readings of the reference that they find.
#include "families/quadquad2drv/controller.h"

#include "families/quadquad2drv/calibrations.h"

namespace mb::quadquad2drv {
Readings Controller::readings() const
{
    Readings now;
    now.velocityTargetShifted = profile().calibrated(calibration::targetShift) == calibration::shiftedTarget;
    now.libraryPolarity = profile().calibrated(calibration::inputReading) == calibration::asLibrary;
    return now;
}

/// Inputs that were written with the other reading are written again, so that they are what the parameters say.
void Controller::doProfileChanged()
{
    const bool library = readings().libraryPolarity;
    const bool changed = library != std::exchange(m_libraryPolarity, library);
    if (!changed || !m_resetKnown || m_spi.state() != LinkState::Open)
        return;
    std::vector<Bytes> inputs;
    for (int axis = 0; axis < axes; ++axis) {
        if (parameters().entry(indexOf(axis, AxisParameter::InputMode)).raw)
            inputs.push_back(inputOf(axis));
    }
    m_scope.spawn<void>(sendAll(std::move(inputs)));
}

Task<void> Controller::sendAll(std::vector<Bytes> requests)
{
    for (const Bytes &request : requests) {
        auto asking = m_port.request(request);
        co_await std::move(asking);
    }
    co_return {};
}

Task<void> Controller::tell(Bytes request)
{
    if (m_port.masks()[0] != datamask::everything) {
        auto telling = tellEverything();
        co_await std::move(telling);
    }
    m_changed = true;
    auto asking = m_port.request(std::move(request));
    co_await std::move(asking);
    co_return {};
}

Task<std::uint8_t> Controller::askStatus(int axis)
{
    auto asking = m_port.request(getRequest(PacketId::GetMotion));
    const Packet reply = co_await std::move(asking);
    const auto motion = parseMotion(reply, m_port.masks(), m_port.streamConfig());
    if (!motion || !motion->channels[static_cast<std::size_t>(axis)].status)
        co_return fail(Fault::BadReply, say("the board did not tell its status"));
    co_return *motion->channels[static_cast<std::size_t>(axis)].status;
}

Task<History> Controller::askHistory()
{
    auto asking = m_port.request(getRequest(PacketId::GetHistory));
    const Packet reply = co_await std::move(asking);
    const auto history = parseHistory(reply);
    if (!history)
        co_return fail(Fault::BadReply, say("the history has an unexpected length"));
    co_return *history;
}

std::vector<Bytes> Controller::settingsOf(int axis)
{
    using enum AxisParameter;
    if (!parameters().entry(indexOf(axis, LimitPower)).raw)
        parameters().setWritten(indexOf(axis, LimitPower), firstPowerLimit);
    const auto bits = [&](AxisParameter which) { return static_cast<std::uint32_t>(known(axis, which)); };
    return {
        setPowerLimit(maskOf(axis), static_cast<std::uint16_t>(bits(LimitPower))),
        setVelocityLimit(maskOf(axis), bits(LimitVelocity)),
        setAccelerationLimit(maskOf(axis), bits(LimitAcceleration)),
        groupRequest(axis, PositionP, known(axis, PositionP)),
        groupRequest(axis, VelocityP, known(axis, VelocityP)),
        inputOf(axis),
    };
}

Bytes Controller::inputOf(int axis)
{
    return groupRequest(axis, AxisParameter::InputMode, known(axis, AxisParameter::InputMode));
}

void Controller::putBack(std::vector<Bytes> requests)
{
    m_scope.spawn<void>(sendAll(std::move(requests)));
}

} // namespace mb::quadquad2drv
