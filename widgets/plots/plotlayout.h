// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace mb {

/// What a layout of the plots page remembers: which signals, where, how long a window, which formulas.
struct PlotLayout {
    struct Trace {
        QString device; ///< selector; "*" in a family's default: the selected device; empty: a derived signal
        QString key;    ///< of the channel, or the name of the derived signal
        QString pane;   ///< empty: that of its unit
        bool second = false;

        friend bool operator==(const Trace &, const Trace &) = default;
    };
    /// What a name in a formula means: the selector of a device, the key of its channel.
    struct Meaning {
        QString name;
        QString device;
        QString key;

        friend bool operator==(const Meaning &, const Meaning &) = default;
    };
    struct Derived {
        QString name;
        QString unit;
        QString formula;
        std::vector<Meaning> meanings{}; ///< empty: the devices of its formula were never there together

        friend bool operator==(const Derived &, const Derived &) = default;
    };
    std::vector<Trace> traces;
    std::vector<Derived> derived;
    double window = 10.0; ///< seconds

    friend bool operator==(const PlotLayout &, const PlotLayout &) = default;
    [[nodiscard]] QByteArray toJson() const;
    /// OutOfRange with the cause when it is no layout; unknown keys are passed over.
    [[nodiscard]] static Result<PlotLayout> fromJson(const QByteArray &json);
};

/// Layouts as files in a folder, one each. Without a folder nothing is remembered.
class PlotLayouts {
public:
    PlotLayouts() = default;
    explicit PlotLayouts(const QString &folder)
        : m_folder(folder)
    {
    }
    /// Names that a person gave.
    [[nodiscard]] QStringList names() const;
    [[nodiscard]] Result<PlotLayout> load(const QString &name) const;
    [[nodiscard]] Result<void> save(const QString &name, const PlotLayout &layout) const;
    void remove(const QString &name) const;
    [[nodiscard]] bool remembers() const { return !m_folder.isEmpty(); }

    /// Names that no person can give: what was there when the program ended, and what a family begins with.
    [[nodiscard]] static QString lastName() { return QStringLiteral("@last"); }
    [[nodiscard]] static bool isOwn(const QString &name) { return name.startsWith(QLatin1Char('@')); }
    [[nodiscard]] static QString familyName(const QString &family) { return QStringLiteral("@family ") + family; }

private:
    [[nodiscard]] QString fileOf(const QString &name) const;
    QString m_folder;
};

} // namespace mb
