// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/languages.h"

#include <QDir>
#include <QTranslator>

#include <algorithm>

namespace mb {
namespace {

constexpr const char *context = "Languages";
constexpr struct {
    const char *source;
    const char *comment;
} self = QT_TRANSLATE_NOOP3("Languages", "English", "the name of this language in itself");

} // namespace

std::vector<Language> languages()
{
    const QString prefix = QStringLiteral("motorbench_");
    std::vector<Language> found;
    const QDir folder(QStringLiteral(":/translations"));
    for (const QString &file : folder.entryList({prefix + QStringLiteral("*.qm")}, QDir::Files, QDir::Name)) {
        QTranslator translator;
        if (!translator.load(folder.filePath(file)))
            continue;
        const QString name = translator.translate(context, self.source, self.comment);
        found.push_back({file.mid(prefix.size()).chopped(3), name.isEmpty() ? QString::fromLatin1(self.source) : name});
    }
    return found;
}

bool isSpoken(const QString &code)
{
    const auto all = languages();
    return std::any_of(all.begin(), all.end(), [&](const Language &language) { return language.code == code; });
}

QString glyphsOf(const QLocale &locale)
{
    switch (locale.language()) {
    case QLocale::Chinese: return QStringLiteral("Noto Sans CJK SC");
    case QLocale::Japanese: return QStringLiteral("Noto Sans CJK JP");
    default: return {};
    }
}

QString spokenCodes()
{
    QStringList codes;
    for (const Language &language : languages())
        codes += language.code;
    return codes.join(QStringLiteral(", "));
}

} // namespace mb
