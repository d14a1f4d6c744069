// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/refusal.h"

#include "widgets/common/devicetext.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <cerrno>
#include <cstdio>

namespace mb {
namespace {

constexpr int notWritten = 1;
constexpr int wrongInput = 2;

} // namespace

int refuse(const Error &wrong, bool json)
{
    Error error = wrong;
    if (error.help().empty())
        error.remedy = say("--help tells what there is");
    const bool isKept = error.fault != Fault::NotKept;
    const int status = isKept ? wrongInput : notWritten;
    if (!json) {
        std::fprintf(stderr, "%s: %s\n", program_invocation_short_name, error.text().c_str());
        return status;
    }
    const QJsonObject row{{QStringLiteral("status"), status},
        {QStringLiteral("fault"), isKept ? QStringLiteral("out-of-range") : QStringLiteral("refused")},
        {QStringLiteral("cause"), qt(error.detail.english())}, {QStringLiteral("remedy"), qt(error.help().english())}};
    const QByteArray line = QJsonDocument(QJsonObject{{QStringLiteral("error"), row}}).toJson(QJsonDocument::Compact);
    std::fprintf(stderr, "%s\n", line.constData());
    return status;
}

} // namespace mb
