// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/transcript.h"

#include "model/parameterfile.h"

#include <QDir>

namespace mb {
namespace {

/// Seconds with milliseconds, as in the traffic logs.
std::string stampOf(Duration sinceEpoch)
{
    const auto all = std::chrono::duration_cast<std::chrono::milliseconds>(sinceEpoch).count();
    const std::string rest = std::to_string(all % 1000);
    return std::to_string(all / 1000) + '.' + std::string(3 - rest.size(), '0') + rest;
}

} // namespace

Result<std::string> saveTranscript(
    const std::string &folder, const Device &device, const OperationStatus &status, const UpdateReport &report)
{
    const Duration offset = device.clock().unixOffset();
    std::string text = "# firmware update of " + device.selector() + '\n';
    for (const LogLine &line : status.log)
        text += '(' + stampOf(line.time.time_since_epoch() + offset) + ") " + line.text + '\n';
    text += "# " + std::string(toString(report.outcome)) + ": " + report.evidence + '\n';
    const auto seconds = std::chrono::floor<std::chrono::seconds>(status.startedAt.time_since_epoch() + offset);
    const std::string path = folder + '/' + std::string(device.family().key) + '-'
        + std::to_string(device.identity().address) + '-' + std::to_string(seconds.count()) + ".log";
    if (!QDir().mkpath(QString::fromStdString(folder)))
        return fail(Fault::OutOfRange, folder + " cannot be made", "check the rights of the folder above it");
    if (auto saved = saveFile(path, QByteArray::fromStdString(text)); !saved)
        return fail(saved.error());
    return path;
}

} // namespace mb
