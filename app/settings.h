// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QStringList>
#include <QVariant>

#include <memory>

class QSettings;

namespace mb {

/// What the program remembers between runs. A demo or a test keeps nothing: make it without a store.
class Settings {
public:
    /// The user's own settings, or none at all.
    explicit Settings(bool remembers);
    ~Settings();

    /// "dark", "light"; empty until chosen.
    [[nodiscard]] QString theme() const;
    void setTheme(const QString &theme);
    [[nodiscard]] QByteArray geometry() const;
    void setGeometry(const QByteArray &geometry);
    /// Addresses that the user added by hand, opened again at the next start.
    [[nodiscard]] QStringList links() const;
    void addLink(const QString &address);
    void removeLink(const QString &address);

private:
    [[nodiscard]] QVariant value(const QString &key) const;
    void setValue(const QString &key, const QVariant &value);

    std::unique_ptr<QSettings> m_store;
};

} // namespace mb
