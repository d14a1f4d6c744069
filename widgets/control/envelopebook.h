// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "model/trialtraits.h"
#include "widgets/common/diskthread.h"

#include <QStringList>

#include <map>
#include <string>

namespace mb {

/// The limits of experiments that people have entered, by unit (Trial::unit): what holds for it now, and sets with names to
/// choose again. Kept in one JSON file, which several windows may have open, in the units of Envelope; without a file for as long as the
/// program runs. What is entered holds at once and is written by a DiskThread. GUI thread.
class EnvelopeBook : public QObject {
    Q_OBJECT
public:
    /// Reads the file, where there is one; OutOfRange when it is another, which is then neither taken nor written over.
    Result<void> open(const QString &file);

    /// What was entered for a unit; empty bounds where nothing was.
    [[nodiscard]] Envelope entered(const std::string &unit) const;
    void enter(const std::string &unit, const Envelope &limits);
    /// A unit is known by another name now, its serial number: what was entered for it goes along, unless that has its own.
    void carry(const std::string &from, const std::string &to);

    /// Names that limits of this unit were kept under, sorted.
    [[nodiscard]] QStringList names(const std::string &unit) const;
    [[nodiscard]] Envelope named(const std::string &unit, const QString &name) const;
    void keep(const std::string &unit, const QString &name, const Envelope &limits);
    void forget(const std::string &unit, const QString &name);
    /// Until everything is written.
    void finish() { m_disk.finish(); }

Q_SIGNALS:
    /// What was entered is not kept.
    void failed(const QString &cause);

private:
    struct Unit {
        Envelope entered;
        std::map<QString, Envelope> named;
    };
    void write(const std::string &unit);

    QString m_file;
    std::map<std::string, Unit> m_units;
    DiskThread m_disk;
};

} // namespace mb
