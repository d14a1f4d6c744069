// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/helptopics.h"

#include <QCoreApplication>
#include <QFile>

namespace mb {
namespace {

struct HelpTitles {
    Q_DECLARE_TR_FUNCTIONS(HelpTitles)
};

} // namespace

std::vector<HelpTopic> helpTopics()
{
    return {{QStringLiteral("first-hour"), HelpTitles::tr("First hour")},
        {QStringLiteral("connecting"), HelpTitles::tr("Connecting")},
        {QStringLiteral("tuning"), HelpTitles::tr("Tuning by itself")},
        {QStringLiteral("plots"), HelpTitles::tr("Plots")}, {QStringLiteral("service"), HelpTitles::tr("Service")},
        {QStringLiteral("safety"), HelpTitles::tr("Safety")}, {QStringLiteral("files"), HelpTitles::tr("Files")},
        {QStringLiteral("troubleshooting"), HelpTitles::tr("Troubleshooting")},
        {QStringLiteral("hardware/dmc60c"), HelpTitles::tr("Hardware: DMC60C")},
        {QStringLiteral("hardware/supermodified"), HelpTitles::tr("Hardware: Supermodified")},
        {QStringLiteral("hardware/abstractdc"), HelpTitles::tr("Hardware: Abstract DC Drive")},
        {QStringLiteral("hardware/quadquad2drv"), HelpTitles::tr("Hardware: QuadQuad2Drv")}};
}

QString hardwareTopic(std::string_view family)
{
    const QString topic
        = QStringLiteral("hardware/") + QString::fromUtf8(family.data(), static_cast<int>(family.size()));
    return QFile::exists(QStringLiteral(":/help/%1.md").arg(topic)) ? topic : QString();
}

} // namespace mb
