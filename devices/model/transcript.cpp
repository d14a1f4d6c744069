// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/transcript.h"

#include "files/filebytes.h"
#include "model/device.h"
#include "model/deviceprofile.h"

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

Transcript transcriptOf(
    const std::string &folder, const Device &device, const OperationStatus &status, const UpdateReport &report)
{
    const Duration offset = device.clock().unixOffset();
    const auto seconds = std::chrono::floor<std::chrono::seconds>(status.startedAt.time_since_epoch() + offset);
    Transcript made;
    made.folder = folder;
    made.path = folder + '/' + fileNameOf(device.selector(), '-' + std::to_string(seconds.count()) + ".log");
    made.text = "# firmware update of " + device.selector() + '\n';
    for (const LogLine &line : status.log)
        made.text += '(' + stampOf(line.time.time_since_epoch() + offset) + ") " + line.text.english() + '\n';
    made.text += "# " + std::string(toString(report.outcome)) + ": " + report.summary().english() + '\n';
    return made;
}

Result<std::string> save(const Transcript &transcript)
{
    if (!QDir().mkpath(QString::fromStdString(transcript.folder)))
        return fail(Fault::OutOfRange, say("%1 cannot be made", transcript.folder),
            say("check the rights of the folder above it"));
    MB_TRY_VOID(saveFile(transcript.path, QByteArray::fromStdString(transcript.text)));
    return transcript.path;
}

} // namespace mb
