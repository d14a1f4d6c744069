// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/languages.h"

#include <QDir>
#include <QTranslator>

namespace mb {
namespace {

constexpr const char *context = "Languages";
constexpr struct {
    const char *source;
    const char *comment;
} self = QT_TRANSLATE_NOOP3("Languages", "English", "the name of this language in itself");

QString folderOfThem()
{
    return QStringLiteral(":/translations");
}

QString fileOf(const QString &code)
{
    return QStringLiteral("motorbench_%1.qm").arg(code);
}

} // namespace

QStringList spokenCodes()
{
    QStringList codes;
    for (const QString &file : QDir(folderOfThem()).entryList({fileOf(QStringLiteral("*"))}, QDir::Files, QDir::Name))
        codes += file.section(QLatin1Char('_'), 1).section(QLatin1Char('.'), 0, 0);
    return codes;
}

std::vector<Language> languages()
{
    std::vector<Language> found;
    for (const QString &code : spokenCodes()) {
        QTranslator translator;
        if (!translator.load(fileOf(code), folderOfThem()))
            continue;
        const QString name = translator.translate(context, self.source, self.comment);
        found.push_back({code, name.isEmpty() ? QString::fromLatin1(self.source) : name});
    }
    return found;
}

QString glyphsOf(const QLocale &locale)
{
    switch (locale.language()) {
    case QLocale::Chinese: return QStringLiteral("Noto Sans CJK SC");
    case QLocale::Japanese: return QStringLiteral("Noto Sans CJK JP");
    default: return {};
    }
}

} // namespace mb
