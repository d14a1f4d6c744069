// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings.h"

#include <QSettings>
#include <QStandardPaths>
#include <QVariant>

#include <algorithm>

namespace mb {
namespace {

constexpr double smallestFont = 0.5;
constexpr double largestFont = 3.0;

} // namespace

Settings::Settings(bool remembers)
{
    if (remembers)
        m_store = std::make_unique<QSettings>(
            QStringLiteral("motorbench"), QStringLiteral("MotorBench")); // settingsFolder()
}

Settings::~Settings() = default;

QVariant Settings::value(const QString &key) const
{
    return m_store ? m_store->value(key) : m_values.value(key);
}

void Settings::setValue(const QString &key, const QVariant &value)
{
    if (m_store)
        m_store->setValue(key, value);
    else
        m_values[key] = value;
}

Look Settings::look() const
{
    if (m_worn)
        return *m_worn;
    Look look;
    look.theme = theme();
    look.language = value(QStringLiteral("language")).toString();
    const QVariant scale = value(QStringLiteral("font-scale"));
    look.fontScale = scale.isValid() ? std::clamp(scale.toDouble(), smallestFont, largestFont) : 1.0;
    look.reducedMotion = value(QStringLiteral("reduced-motion")).toBool();
    look.revolutions = value(QStringLiteral("revolutions")).toBool();
    const QVariant sounds = value(QStringLiteral("sounds"));
    look.sounds = !sounds.isValid() || sounds.toBool();
    return look;
}

void Settings::setLook(const Look &look)
{
    m_worn.reset();
    setTheme(look.theme);
    setValue(QStringLiteral("language"), look.language);
    setValue(QStringLiteral("font-scale"), look.fontScale);
    setValue(QStringLiteral("reduced-motion"), look.reducedMotion);
    setValue(QStringLiteral("revolutions"), look.revolutions);
    setValue(QStringLiteral("sounds"), look.sounds);
}

void Settings::addLink(const QString &address)
{
    changeLinks([&address](QStringList &all) { all << address; });
}

void Settings::removeLink(const QString &address)
{
    changeLinks([&address](QStringList &all) { all.removeAll(address); });
}

/// Another window may have kept one since the file was read.
void Settings::changeLinks(const std::function<void(QStringList &)> &change)
{
    if (m_store)
        m_store->sync();
    QStringList all = links();
    change(all);
    all.removeDuplicates();
    setValue(QStringLiteral("links"), all);
    if (m_store)
        m_store->sync();
}

void Settings::setJournal(const QString &server, const QString &station)
{
    setValue(QStringLiteral("journal-server"), server);
    setValue(QStringLiteral("station"), station);
}

QString Settings::firmwareFolder() const
{
    const QString chosen = value(QStringLiteral("firmware-folder")).toString();
    return chosen.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DownloadLocation) : chosen;
}

KeyChoices Settings::keys() const
{
    KeyChoices keys;
    const QVariantMap kept = value(QStringLiteral("keys")).toMap();
    for (auto row = kept.begin(); row != kept.end(); ++row) {
        const QList<QKeySequence> list = QKeySequence::listFromString(row->toString(), QKeySequence::PortableText);
        std::vector<QKeySequence> &chosen = keys[row.key()];
        std::copy_if(list.begin(), list.end(), std::back_inserter(chosen),
            [](const QKeySequence &key) { return !key.isEmpty(); });
    }
    return keys;
}

void Settings::setKeys(const KeyChoices &keys)
{
    QVariantMap kept;
    for (const auto &[id, chosen] : keys) {
        const QList<QKeySequence> list(chosen.begin(), chosen.end());
        kept[id] = QKeySequence::listToString(list, QKeySequence::PortableText);
    }
    setValue(QStringLiteral("keys"), kept);
}

} // namespace mb
