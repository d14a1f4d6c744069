// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings.h"

#include <QSettings>
#include <QVariant>

namespace mb {

Settings::Settings(bool remembers)
{
    if (remembers)
        m_store = std::make_unique<QSettings>(QStringLiteral("MotorBench"), QStringLiteral("MotorBench"));
}

Settings::~Settings() = default;

QVariant Settings::value(const QString &key) const
{
    return m_store ? m_store->value(key) : QVariant();
}

void Settings::setValue(const QString &key, const QVariant &value)
{
    if (m_store)
        m_store->setValue(key, value);
}

QString Settings::theme() const
{
    return value(QStringLiteral("theme")).toString();
}

void Settings::setTheme(const QString &theme)
{
    setValue(QStringLiteral("theme"), theme);
}

QByteArray Settings::geometry() const
{
    return value(QStringLiteral("geometry")).toByteArray();
}

void Settings::setGeometry(const QByteArray &geometry)
{
    setValue(QStringLiteral("geometry"), geometry);
}

QStringList Settings::links() const
{
    return value(QStringLiteral("links")).toStringList();
}

void Settings::addLink(const QString &address)
{
    QStringList all = links();
    if (!all.contains(address))
        setValue(QStringLiteral("links"), all << address);
}

void Settings::removeLink(const QString &address)
{
    QStringList all = links();
    if (all.removeAll(address) > 0)
        setValue(QStringLiteral("links"), all);
}

} // namespace mb
