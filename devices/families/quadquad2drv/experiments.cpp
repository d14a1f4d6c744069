// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/experiments.h"

#include "async/sleep.h"
#include "families/quadquad2drv/borrowedsettings.h"
#include "families/quadquad2drv/calibrations.h"

#include <QtGlobal>

#include <array>

namespace mb::quadquad2drv {
namespace {

using namespace std::chrono_literals;

constexpr double firstPower = 0.25;
constexpr double greatestPower = 0.5;
constexpr Duration settling = 50ms;

constexpr std::array<std::string_view, 2> levels{
    QT_TRANSLATE_NOOP("table", "open: nothing is connected, the pin is high"),
    QT_TRANSLATE_NOOP("table", "connected to GND: the pin is low"),
};

constexpr std::array<Experiment, 2> experimentTable{{
    {
        .key = "gain-scales",
        .title = QT_TRANSLATE_NOOP("table", "Find the gain scales"),
        .explanation = QT_TRANSLATE_NOOP("table",
            "The maker does not tell what a raw gain is worth. The motor of one axis is turned to and fro for one to "
            "two "
            "minutes, with the power that you allow here: first with constant power, then with one gain alone at a "
            "time, which "
            "grows until the motor moves. The shaft must turn freely, some turns each way, and nobody may touch it. "
            "Gains and "
            "limits are put back at the end."),
        .power = firstPower,
        .mostPower = greatestPower,
        .question = {},
        .answers = {},
        .run = findGainScales,
    },
    {
        .key = "input-reading",
        .title = QT_TRANSLATE_NOOP("table", "Find the input polarity"),
        .explanation = QT_TRANSLATE_NOOP("table",
            "Data sheet and the maker's library give the polarity of the inputs opposite bits. The input of one axis "
            "is set up "
            "with both, and the status bit tells which of them is active at the level that the pin has. Nothing moves, "
            "the "
            "counter stays, and the input is set up afterwards as it was."),
        .power = 0.0,
        .mostPower = 0.0,
        .question = QT_TRANSLATE_NOOP("table", "The input pin of this axis is"),
        .answers = levels,
        .run = findInputReading,
    },
}};

/// Status bits of an axis (0…3) now.
Task<std::uint8_t> askStatus(PacketPort &port, int axis)
{
    const Packet reply = co_await port.request(getRequest(PacketId::GetMotion));
    const auto motion = parseMotion(reply, port.masks(), port.streamConfig());
    if (!motion || !motion->channels[static_cast<std::size_t>(axis)].status)
        co_return fail(Fault::BadReply, say("the board did not tell its status"));
    co_return *motion->channels[static_cast<std::size_t>(axis)].status;
}

/// Whether the input is active with this polarity bit, as it is on the wire. Edge 0 records and sets nothing in both readings.
Task<bool> isActive(Controller &board, int axis, int bit)
{
    InputSettings input;
    input.configuration = static_cast<std::uint8_t>(static_cast<int>(InputMode::Home) | bit << 3);
    co_await board.tell(setInputMode(maskOf(axis), input));
    co_await Sleep(board.clock(), settling);
    const std::uint8_t bits = co_await askStatus(board.port(), axis);
    co_return (bits & status::inputActive) != 0;
}

} // namespace

std::span<const Experiment> experiments()
{
    return experimentTable;
}

Task<ExperimentReport> findInputReading(Device &device, SetPointStream &, ExperimentOptions options, Progress &progress)
{
    if (options.axis < 1 || options.axis > axes)
        co_return fail(Fault::OutOfRange, say("the board has axes 1 to 4"));
    if (device.liveness().moving)
        co_return fail(Fault::Unsafe, say("stop the motors first"));
    auto &board = static_cast<Controller &>(device);
    const int axis = options.axis - 1;
    const BorrowedSettings borrowed(board, axis, BorrowedSettings::Part::Input);
    std::array<bool, 2> active{};
    for (int bit = 0; bit < 2; ++bit) {
        progress.step(say("looking at the status bit"), bit, 2);
        auto asking = isActive(board, axis, bit);
        active[static_cast<std::size_t>(bit)] = co_await std::move(asking);
        progress.log(Severity::Info,
            active[static_cast<std::size_t>(bit)] ? say("polarity bit %1: the input is active", bit)
                                                  : say("polarity bit %1: the input is not active", bit));
    }
    if (active[0] == active[1])
        co_return fail(Fault::Refused, say("the status bit is the same with both polarities, so it tells nothing"),
            say("look at the wiring of the input"));
    const bool high = options.answer == 0;
    const bool bitZeroIsHigh = active[0] == high;
    const int reading = bitZeroIsHigh ? calibration::asLibrary : calibration::asDataSheet;
    co_await board.knowledge().calibrate(calibration::inputReading, reading);
    ExperimentReport report;
    report.found.emplace_back(calibration::inputReading, reading);
    report.sentence = bitZeroIsHigh ? say("polarity 0 is active high: the board follows the maker's library")
                                    : say("polarity 0 is active low: the board follows the data sheet");
    co_return report;
}

} // namespace mb::quadquad2drv
