// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/trialtraits.h"
#include "widgets/common/displayunits.h"
#include "widgets/common/theme.h"
#include "widgets/control/envelopebook.h"

#include <QWidget>

#include <array>

class QLabel;
class QLineEdit;
class QPushButton;

namespace mb {

class SavedLimits;

/// Travel, speed, current and duty that no experiment may leave: what a person has entered, and beside it what holds now.
class EnvelopePanel : public QWidget {
    Q_OBJECT
public:
    explicit EnvelopePanel(const ThemeSource &theme, QWidget *parent = nullptr);

    void setUnits(const DisplayUnits &units);
    /// Where limits of every unit are kept, shared with other pages; it outlives this. Before, they are this panel's own.
    void share(EnvelopeBook &book) { m_book = &book; }
    [[nodiscard]] EnvelopeBook &book() { return *m_book; }
    /// Shows what was entered for this unit (Trial::unit), also by another run of the program; changed() where that is something
    /// else. Limits go along when a unit turns out to have a serial number. Empty: not known who it is; what is entered meanwhile
    /// belongs to the same device only.
    void choose(const std::string &unit, bool sameDevice);
    [[nodiscard]] const Envelope &entered() const { return m_entered; }
    /// What stands in a field and is no limit, for people; entered() is as before it was typed. Empty: nothing.
    [[nodiscard]] const QString &fault() const { return m_fault; }
    /// What bounds the next experiment; `missing` must be entered before it.
    void setInForce(const Envelope &inForce, const QString &missing);
    /// What an experiment still needs, or what is wrong with what was entered; empty: nothing.
    [[nodiscard]] const QString &missing() const { return m_fault.isEmpty() ? m_missing : m_fault; }
    void setOpen(bool open);

Q_SIGNALS:
    void changed();

private:
    struct Row {
        QLineEdit *field = nullptr;
        QLabel *inForce = nullptr;
        ShownUnit unit;
        std::optional<double> before; ///< what holds while what is typed is no limit
    };
    /// What is typed into a field: a limit, or none where it is empty, or neither.
    struct Reading {
        std::optional<double> value;
        bool good = false;
    };
    [[nodiscard]] Reading readingOf(std::size_t at) const;
    void read(std::size_t at);
    void showVerdict();
    void write(bool all = false);
    void say();
    void take(const Envelope &limits);
    void look(bool all = false);

    const ThemeSource &m_theme;
    EnvelopeBook m_own;
    EnvelopeBook *m_book = &m_own;
    std::string m_unit;
    SavedLimits *m_saved = nullptr;
    Envelope m_entered;
    Envelope m_inForce;
    QString m_missing;
    QString m_fault;
    std::array<Row, 4> m_rows;
    QPushButton *m_head = nullptr;
    QLabel *m_words = nullptr;
    QWidget *m_box = nullptr;
};

} // namespace mb
