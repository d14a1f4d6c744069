// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/pagekeys.h"

#include <QByteArray>
#include <QStringList>
#include <QVariant>
#include <QVariantMap>

#include <functional>
#include <memory>
#include <optional>

class QSettings;

namespace mb {

/// How the program looks and speaks.
struct Look {
    QString theme;              ///< of themeNames(); empty until chosen
    QString language;           ///< of languages(); empty: the desktop's
    double fontScale = 1.0;     ///< of the desktop's font, 0.5 to 3
    bool reducedMotion = false; ///< nothing moves but data
    bool revolutions = false;   ///< rpm and degrees rather than counts, where nobody has chosen otherwise
    bool sounds = true;         ///< with every verdict in production

    friend bool operator==(const Look &, const Look &) = default;
};

/// What the program remembers between runs. A demo or a test keeps nothing beyond its own end: make it without a store.
class Settings {
public:
    /// The user's own settings, or none at all.
    explicit Settings(bool remembers);
    ~Settings();

    /// Of themeNames(); empty until chosen.
    [[nodiscard]] QString theme() const { return value(QStringLiteral("theme")).toString(); }
    void setTheme(const QString &theme) { setValue(QStringLiteral("theme"), theme); }
    /// As it is worn, which is what was chosen last.
    [[nodiscard]] Look look() const;
    void setLook(const Look &look);
    /// Of the command line: worn until another look is chosen, and not remembered.
    void wear(const Look &look) { m_worn = look; }
    [[nodiscard]] QByteArray geometry() const { return value(QStringLiteral("geometry")).toByteArray(); }
    void setGeometry(const QByteArray &geometry) { setValue(QStringLiteral("geometry"), geometry); }
    /// Addresses that the user added by hand, opened again at the next start.
    [[nodiscard]] QStringList links() const { return value(QStringLiteral("links")).toStringList(); }
    void addLink(const QString &address);
    void removeLink(const QString &address);
    /// Where the start page looks for images; the user's downloads until one was chosen.
    [[nodiscard]] QString firmwareFolder() const;
    void setFirmwareFolder(const QString &folder) { setValue(QStringLiteral("firmware-folder"), folder); }
    /// Keys that the user gave to commands, by PageKeys::idOf.
    [[nodiscard]] KeyChoices keys() const;
    void setKeys(const KeyChoices &keys);
    /// As orders::KeepJournal: the server that stations share, and the name of this one; empty until chosen.
    [[nodiscard]] QString journalServer() const { return value(QStringLiteral("journal-server")).toString(); }
    [[nodiscard]] QString station() const { return value(QStringLiteral("station")).toString(); }
    void setJournal(const QString &server, const QString &station);
    /// Something that was offered once and is not offered again, by a key of its own.
    [[nodiscard]] bool isDismissed(const QString &key) const
    {
        return value(QStringLiteral("dismissed/") + key).toBool();
    }
    void dismiss(const QString &key) { setValue(QStringLiteral("dismissed/") + key, true); }

private:
    [[nodiscard]] QVariant value(const QString &key) const;
    void setValue(const QString &key, const QVariant &value);
    void changeLinks(const std::function<void(QStringList &)> &change);

    std::unique_ptr<QSettings> m_store;
    QVariantMap m_values; ///< without a store
    std::optional<Look> m_worn;
};

} // namespace mb
