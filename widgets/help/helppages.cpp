// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/helppages.h"

#include <QCoreApplication>
#include <QFile>

namespace mb {
namespace {

QString root()
{
    return QStringLiteral(":/help/");
}

constexpr int codeLength = 2; ///< of "de/"

} // namespace

QString spokenCode()
{
    return QCoreApplication::translate("Languages", "en", "the code of this language, as in the name of its file");
}

QString helpFile(const QString &topic)
{
    const QString page = topic + QStringLiteral(".md");
    const QString translated = root() + spokenCode() + QLatin1Char('/') + page;
    return QFile::exists(translated) ? translated : root() + page;
}

QString helpTopicOf(const QString &file)
{
    QString topic = file.mid(root().size()).section(QLatin1Char('.'), 0, 0);
    return topic.indexOf(QLatin1Char('/')) == codeLength ? topic.mid(codeLength + 1) : topic;
}

} // namespace mb
