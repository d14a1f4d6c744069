// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/helptopics.h"

#include "model/family.h"
#include "model/registry.h"
#include "widgets/help/helppages.h"

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
    std::vector<HelpTopic> topics{{QStringLiteral("first-hour"), HelpTitles::tr("First hour")},
        {QStringLiteral("connecting"), HelpTitles::tr("Connecting")},
        {QStringLiteral("tuning"), HelpTitles::tr("Tuning by itself")},
        {QStringLiteral("plots"), HelpTitles::tr("Plots")}, {QStringLiteral("service"), HelpTitles::tr("Service")},
        {QStringLiteral("recipes"), HelpTitles::tr("Recipes")}, {QStringLiteral("safety"), HelpTitles::tr("Safety")},
        {QStringLiteral("files"), HelpTitles::tr("Files")},
        {QStringLiteral("troubleshooting"), HelpTitles::tr("Troubleshooting")}};
    for (const Family *family : families()) {
        const QString title = QString::fromUtf8(family->title.data(), static_cast<int>(family->title.size()));
        if (const QString key = hardwareTopic(family->key); !key.isEmpty())
            topics.push_back({key, HelpTitles::tr("Hardware: %1").arg(title)});
    }
    return topics;
}

QString hardwareTopic(std::string_view family)
{
    const QString topic
        = QStringLiteral("hardware/") + QString::fromUtf8(family.data(), static_cast<int>(family.size()));
    return QFile::exists(helpFile(topic)) ? topic : QString();
}

} // namespace mb
