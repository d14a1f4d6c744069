// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/firmware.h"

#include "families/quadquad2drv/updater.h"
#include "transport/linkcatalog.h"

namespace mb::quadquad2drv {
namespace {

constexpr std::string_view noWay
    = "the board is updated over its UART: name its serial port, for example --via serial:/dev/ttyUSB0";

UpdateReport refused(const Error &error)
{
    UpdateReport report;
    report.outcome = UpdateOutcome::Refused;
    report.evidence = error.detail;
    report.fault = error.fault;
    return report;
}

} // namespace

Result<ImageSummary> inspect(const FirmwareImage &image)
{
    if (image.lines().empty())
        return fail(Fault::OutOfRange, "the file has no lines to send");
    ImageSummary summary;
    summary.parts.push_back(0);
    summary.notes.push_back(std::to_string(image.lines().size()) + " lines, " + std::to_string(image.byteCount())
        + " bytes; the file does not name its version");
    return summary;
}

Task<UpdateReport> update(Device &device, const FirmwareImage &image, UpdateOptions options, Progress &progress)
{
    if (!options.target.empty())
        co_return fail(Fault::Unsupported, "a QuadQuad2Drv has one kind of chip; leave the target out");
    if (options.via.empty())
        co_return refused({Fault::OutOfRange, std::string(noWay)});
    const auto address = LinkAddress::parse(options.via);
    if (!address)
        co_return refused(address.error());
    auto link = createLink(*address, device.clock());
    if (!link)
        co_return refused(link.error());
    if ((*link)->kind() != LinkKind::Serial)
        co_return refused({Fault::OutOfRange, std::string(noWay)});
    Updater updater(device, static_cast<SerialLink &>(**link), image, progress);
    auto task = updater.run(options.dryRun);
    UpdateReport report = co_await std::move(task);
    co_return report;
}

} // namespace mb::quadquad2drv
